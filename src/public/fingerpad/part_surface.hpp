#pragma once

#include <memory>
#include <string>
#include <vector>

#include "fingerpad/error.hpp"
#include "fingerpad/types.hpp"

namespace fingerpad {

/// How a mesh file is to be taken.
struct MeshOptions {
  std::string unit = "mm";  ///< what one unit of the file is: "m", "mm", "cm", "in" or "um"
  double crease_deg = 30;   ///< edges whose facets turn by more than this stay sharp
  bool repair = false;      ///< weld near vertices, leave out duplicates, wind outwards; warnings() tell
};

/// The point of a surface that lies closest to a point that was asked for.
struct ClosestPoint {
  Vec3 point_m = Vec3::Zero();  ///< on the surface [m]
  Vec3 normal = Vec3::UnitZ();  ///< angle-weighted, of the closest face, edge or vertex; outward, unit
  double signed_distance_m =
      0;              ///< to it, negative inside; infinite where a point was asked for that has none
  int triangle = -1;  ///< its number in the file, from 0; -1 where there is no closest point
};

/// A CAD part as a closed or open surface of triangles, ready to be asked and touched. All places are in the
/// part's own frame, that of its file, in metres.
///
/// Immutable; a copy shares the triangles. May be asked from any number of threads.
class PartSurface {
 public:
  /// Reads STL, OBJ, PLY or OFF. Throws Error (refused) for a file that cannot be touched, with the place of
  /// the damage.
  explicit PartSurface(const std::string& mesh_path, const MeshOptions& options = {});

  /// Takes triangles that a program has made.
  /// @param vertices_m  3 x n_v [m]
  /// @param triangles   3 x n, indices into the vertices, counterclockwise seen from outside
  /// @param crease_deg  as MeshOptions
  /// Throws Error (refused) for an index out of range, a coordinate that is not finite, and where no triangle
  /// has an area.
  PartSurface(const Points& vertices_m, const IndexTriples& triangles, double crease_deg = 30);

  /// The closest point to `p_m`, to 1e-12 of the part's size: that of every triangle looked at, ties to the
  /// lowest. noexcept, allocates nothing.
  ClosestPoint closest(const Vec3& p_m) const noexcept;

  /// The damages that were seen, each with what it means for touch; empty for a sound mesh.
  const std::vector<std::string>& warnings() const noexcept;
  /// The triangles that can be touched.
  int triangle_count() const noexcept;
  /// The least coordinates of the part's box [m].
  Vec3 lower_corner_m() const noexcept;
  /// The greatest ones [m].
  Vec3 upper_corner_m() const noexcept;

 private:
  friend class ClosestPointPath;
  friend class TouchWorld;
  struct Impl;
  std::shared_ptr<const Impl> impl_;
};

/// Asks one part for closest points along a path: the same answers as PartSurface::closest, several times
/// faster while the path goes on slowly. For one thread at a time.
class ClosestPointPath {
 public:
  /// Begins a path on a part, which it keeps.
  explicit ClosestPointPath(PartSurface part);
  /// Ends it.
  ~ClosestPointPath();
  /// Goes on with another's path; that one may only be destroyed or assigned to.
  ClosestPointPath(ClosestPointPath&&) noexcept;
  /// Goes on with another's path; that one may only be destroyed or assigned to.
  ClosestPointPath& operator=(ClosestPointPath&&) noexcept;

  /// As PartSurface::closest. noexcept, allocates nothing.
  ClosestPoint closest(const Vec3& p_m) noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace fingerpad
