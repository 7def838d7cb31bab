#include "contact/closest_memory.hpp"
#include "contact/placed_surface.hpp"
#include "contact/surface_point.hpp"
#include "contact/triangle_tree.hpp"

namespace fingerpad {
namespace {

const Part& part_of(const PlacedSurface& surface) noexcept {
  return surface.part ? *surface.part : surface.tree->part();
}

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

template <class Hint>
WorldPoint nearest_on_part(const PlacedSurface& surface, const Vec3& p_WQ, Normals normals, Hint hint,
                           double reach_m) noexcept {
  const Vec3 p_PQ = in_part(surface, p_WQ);
  // A surface of the normals' own stands out of the box; its search has a filter of its own.
  if (normals->own_surface == nullptr && !within_padded_box(part_of(surface), p_PQ, reach_m)) return {};
  return in_world(surface, nearest_surface_point(*surface.tree, p_PQ, normals, hint, reach_m));
}

bool part_comes_within(const PlacedSurface& surface, const WorldBox& box, double width_m) {
  const WorldBox beside = world_box(surface);
  return ((beside.middle - box.middle).cwiseAbs() - beside.half - box.half).maxCoeff() <= width_m;
}

Vec3 middle_of_part(const PlacedSurface& surface) {
  return surface.R_WP * part_of(surface).centre_P + surface.p_WP;
}

}  // namespace

WorldBox world_box(const PlacedSurface& part) {
  return {middle_of_part(part), part.R_WP.cwiseAbs() * part_of(part).half_extent};
}

const SurfaceKind part_kind{.name = "part",
                            .nearest_from_seed = nearest_on_part<int>,
                            .nearest_on_path = nearest_on_part<ClosestMemory&>,
                            .nearest_in_brief = nearest_on_part<BriefSearch&>,
                            .comes_within = part_comes_within,
                            .middle_W = middle_of_part};

}  // namespace fingerpad
