#pragma once

#include <limits>
#include <memory>

#include "contact/surface_kind.hpp"

namespace fingerpad {

class TriangleTree;
struct Part;

/// One thing to be touched, where it stands in the world: a part in its pose, or a plane. The functions below
/// answer for either kind; who asks them need not tell the kinds apart.
struct PlacedSurface {
  std::shared_ptr<const Part> part;          ///< none, nor a tree: a plane
  std::shared_ptr<const TriangleTree> tree;  ///< over the part; none where it is only to be looked at
  Vec3 p_WP = Vec3::Zero();
  Mat3 R_WP = Mat3::Identity();
  Vec3 plane_point_W = Vec3::Zero();
  Vec3 plane_normal_W = Vec3::UnitZ();  ///< outward, unit

  bool is_plane() const noexcept { return !part && !tree; }
  const SurfaceKind& kind() const noexcept { return is_plane() ? plane_kind : part_kind; }
};

/// Where a point stands against one surface of a world, frame W.
struct WorldPoint {
  Vec3 point_W = Vec3::Zero();    ///< S [m]
  Vec3 normal_W = Vec3::UnitZ();  ///< outward, unit
  double signed_distance_m = std::numeric_limits<double>::infinity();
  int triangle = -1;   ///< index into Part::triangles, the next search's seed; -1 for a plane
  bool found = false;  ///< something lies within reach, or the point is inside
};

/// The nearest point of a surface to p_WQ. `found` is false where the surface is farther than reach_m; for a
/// part a point outside its padded bounding box is told so without a search.
/// @pre p_WQ finite; a part has its tree. noexcept, allocates nothing.
inline WorldPoint nearest_point(const PlacedSurface& surface, const Vec3& p_WQ, Normals normals, int seed,
                                double reach_m) noexcept {
  return surface.kind().nearest_from_seed(surface, p_WQ, normals, seed, reach_m);
}

/// The same along a path; see TriangleTree::closest.
inline WorldPoint nearest_point(const PlacedSurface& surface, const Vec3& p_WQ, Normals normals,
                                ClosestMemory& memory, double reach_m) noexcept {
  return surface.kind().nearest_on_path(surface, p_WQ, normals, memory, reach_m);
}
inline WorldPoint nearest_point(const PlacedSurface& surface, const Vec3& p_WQ, Normals normals,
                                BriefSearch& search, double reach_m) noexcept {
  return surface.kind().nearest_in_brief(surface, p_WQ, normals, search, reach_m);
}

/// A box along the world's axes [m].
struct WorldBox {
  Vec3 middle, half;
};

/// The box around a part's own box in its pose.
/// @pre no plane
WorldBox world_box(const PlacedSurface& part);

/// Whether a surface may come within `width_m` of a box: a part is taken as its own box, a plane as all that
/// is behind it.
inline bool comes_within(const PlacedSurface& surface, const WorldBox& box, double width_m) {
  return surface.kind().comes_within(surface, box, width_m);
}

}  // namespace fingerpad
