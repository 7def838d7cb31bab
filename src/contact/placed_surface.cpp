#include "contact/placed_surface.hpp"

#include "contact/closest_memory.hpp"
#include "contact/surface_point.hpp"

namespace fingerpad {
namespace {

bool within_padded_box(const Part& part, const Vec3& p_P, double reach_m) noexcept {
  const Vec3 beyond = (p_P - part.centre_P).cwiseAbs() - part.half_extent;
  // A few rounding errors of slack: the box is a filter, the search decides.
  return beyond.maxCoeff() <= reach_m + 1e-12 * (part.size_m() + p_P.norm());
}

Vec3 in_part(const PlacedSurface& surface, const Vec3& p_WQ) noexcept {
  return surface.R_WP.transpose() * (p_WQ - surface.p_WP);
}

WorldPoint in_world(const PlacedSurface& surface, const SurfacePoint& point) noexcept {
  WorldPoint result;
  if (point.triangle < 0) return result;
  result.point_W = surface.R_WP * point.point_P + surface.p_WP;
  result.normal_W = surface.R_WP * point.normal_P;
  result.signed_distance_m = point.signed_distance_m;
  result.triangle = point.triangle;
  result.found = true;
  return result;
}

/// @param hint  a seed, or a memory
template <class Hint>
WorldPoint nearest(const PlacedSurface& surface, const Vec3& p_WQ, Normals normals, Hint& hint,
                   double reach_m) noexcept {
  WorldPoint result;
  if (surface.is_plane()) {
    const SurfacePoint near = nearest_plane_point(surface.plane_point_W, surface.plane_normal_W, p_WQ);
    result.point_W = near.point_P;
    result.normal_W = near.normal_P;
    result.signed_distance_m = near.signed_distance_m;
    result.found = near.signed_distance_m <= reach_m;
    return result;
  }
  const Vec3 p_PQ = in_part(surface, p_WQ);
  // A surface of the normals' own stands out of the box; its search has a filter of its own.
  if (normals->own_surface == nullptr && !within_padded_box(*surface.part, p_PQ, reach_m)) return result;
  return in_world(surface, nearest_surface_point(*surface.tree, p_PQ, normals, hint, reach_m));
}

}  // namespace

WorldPoint nearest_point(const PlacedSurface& surface, const Vec3& p_WQ, Normals normals, int seed,
                         double reach_m) noexcept {
  return nearest(surface, p_WQ, normals, seed, reach_m);
}

WorldPoint nearest_point(const PlacedSurface& surface, const Vec3& p_WQ, Normals normals,
                         ClosestMemory& memory, double reach_m) noexcept {
  return nearest(surface, p_WQ, normals, memory, reach_m);
}

WorldPoint nearest_point(const PlacedSurface& surface, const Vec3& p_WQ, Normals normals, BriefSearch& search,
                         double reach_m) noexcept {
  return nearest(surface, p_WQ, normals, search, reach_m);
}

WorldBox world_box(const PlacedSurface& part) {
  return {part.R_WP * part.part->centre_P + part.p_WP, part.R_WP.cwiseAbs() * part.part->half_extent};
}

bool comes_within(const PlacedSurface& surface, const WorldBox& box, double width_m) {
  if (surface.is_plane()) {
    const double middle_m = surface.plane_normal_W.dot(box.middle - surface.plane_point_W);
    return middle_m - surface.plane_normal_W.cwiseAbs().dot(box.half) <= width_m;
  }
  const WorldBox beside = world_box(surface);
  return ((beside.middle - box.middle).cwiseAbs() - beside.half - box.half).maxCoeff() <= width_m;
}

}  // namespace fingerpad
