#pragma once

#include <memory>
#include <string>
#include <vector>

#include "part/part.hpp"
#include "study/contact_runs.hpp"

namespace fingerpad {

/// A tessellation of a CAD part.
struct ExactMesh {
  std::shared_ptr<const Part> part;
  double facet_m = 0;  ///< mean width of its triangles on curved faces
};

/// A point near the CAD part and what is nearest to it on the exact surface.
struct ExactSample {
  Vec3 query = Vec3::Zero(), foot = Vec3::Zero();  ///< [m]
  Vec3 normal = Vec3::UnitZ();                     ///< unit, outward, at the foot
  double signed_distance_m = 0;                    ///< < 0 inside
  double sharp_edge_m = 0;                         ///< from the foot to the nearest sharp edge
  bool on_face = true;                             ///< else the foot is on a sharp edge
};

/// A way over the exact surface, a foot a tick; each is nearest also to what lies up to 1 mm under it.
struct ExactPath {
  std::string name;
  std::vector<Vec3> feet, normals;
};

/// A CAD part's exact surface at points, with tessellations: what scenes/exact holds (see its README).
struct ExactSet {
  std::vector<ExactMesh> meshes;  ///< coarse to fine, at least two
  std::vector<ExactSample> samples;
  std::vector<ExactPath> paths;  ///< by name, at least one
};

/// Reads such a folder: meshes.csv, mesh-<level>.ply (mm), samples.csv, path-*.csv. Throws Error (refused, at
/// `file:line`) for a file that is missing or broken, normals that are no unit vectors, and meshes that are
/// not ordered from coarse to fine.
ExactSet load_exact_set(const std::string& folder);

/// A rub along a path: the finger's centre `under_m` (at most 1 mm) under the feet.
Rub rub_along(const ExactPath& path, double under_m, double radius_m);

}  // namespace fingerpad
