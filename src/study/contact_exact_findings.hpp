#pragma once

#include <array>
#include <vector>

#include "study/contact_exact_set.hpp"

namespace fingerpad {

/// How far the nearest points of an exact set's samples are off.
struct SampleError {
  double distance_rms_m = 0, distance_worst_m = 0;  ///< signed distance, of every sample
  double normal_rms_rad = 0, normal_worst_rad = 0;  ///< of those on faces, away from sharp edges
  int normals = 0;                                  ///< how many those are
};

/// @param tree  of the mesh's part
SampleError sample_error(const ExactSet& set, const ExactMesh& mesh, const TriangleTree& tree,
                         Normals normals);

/// Strikes 2.4 mm deep, at several speeds, straight down onto feet of the samples that lie on faces and more
/// than 3 mm from any sharp edge: no rounding of the part in scenes/exact is that tight, so that only a wall
/// thinner than 4.8 mm has another surface nearer.
struct StrikeCount {
  int strikes = 0, pops = 0;
};
StrikeCount strike_samples(const ExactSet& set, const std::shared_ptr<const World>& world,
                           const ContactVariant& variant);

/// What one variant of contact gave over one path, one entry a mesh.
struct PathCurve {
  std::vector<RubError> deep;      ///< a point finger, 1 mm deep
  std::vector<RubError> near;      ///< a ball whose centre goes along the exact surface; for the orders alone
  std::vector<double> tick_ns;     ///< of a whole tick with finger-pad
  std::vector<double> contact_ns;  ///< of one without friction
};

/// What the meshes of an exact set gave, coarse to fine.
struct ExactFindings {
  std::vector<std::string> path_names;
  double sample_count = 0;
  std::vector<double> facet_mm, triangles;        ///< one a mesh
  std::vector<std::vector<SampleError>> samples;  ///< by row of normals_table(), a mesh
  std::vector<std::vector<PathCurve>> paths;      ///< by path, a variant
  std::vector<std::vector<StrikeCount>> strikes;  ///< by variant, a mesh
  std::vector<AutomaticChoice> chosen;            ///< one a mesh
};

ExactFindings exact_findings(const ExactSet& set);

}  // namespace fingerpad
