#include "contact/placed_surface.hpp"
#include "contact/surface_point.hpp"

namespace fingerpad {
namespace {

WorldPoint nearest_on_plane(const PlacedSurface& plane, const Vec3& p_WQ, double reach_m) noexcept {
  const SurfacePoint near = nearest_plane_point(plane.plane_point_W, plane.plane_normal_W, p_WQ);
  WorldPoint result;
  result.point_W = near.point_P;
  result.normal_W = near.normal_P;
  result.signed_distance_m = near.signed_distance_m;
  result.found = near.signed_distance_m <= reach_m;
  return result;
}

/// In closed form: nothing is searched, whatever a search would start from.
template <class Hint>
WorldPoint nearest_by(const PlacedSurface& plane, const Vec3& p_WQ, Normals, Hint, double reach_m) noexcept {
  return nearest_on_plane(plane, p_WQ, reach_m);
}

bool plane_comes_within(const PlacedSurface& plane, const WorldBox& box, double width_m) {
  const double middle_m = plane.plane_normal_W.dot(box.middle - plane.plane_point_W);
  return middle_m - plane.plane_normal_W.cwiseAbs().dot(box.half) <= width_m;
}

Vec3 point_of_plane(const PlacedSurface& plane) {
  return plane.plane_point_W;
}

}  // namespace

const SurfaceKind plane_kind{.name = "plane",
                             .nearest_from_seed = nearest_by<int>,
                             .nearest_on_path = nearest_by<ClosestMemory&>,
                             .nearest_in_brief = nearest_by<BriefSearch&>,
                             .comes_within = plane_comes_within,
                             .middle_W = point_of_plane};

}  // namespace fingerpad
