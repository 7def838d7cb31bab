#include "replay/nearest_approach.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "contact/closest_memory.hpp"
#include "part/border.hpp"

namespace fingerpad {
namespace {

/// A place on the path, and how far it is from a surface at least.
using Bounded = std::pair<double, std::size_t>;

/// The nearest of some places, and how far it is from a surface [m].
struct Nearest {
  double distance_m = std::numeric_limits<double>::infinity();
  std::size_t place = 0;
};

Nearest nearest_to_plane(const PlacedSurface& plane, const std::vector<Vec3>& places_W) {
  Nearest nearest;
  for (std::size_t k = 0; k < places_W.size(); ++k) {
    const double height_m = plane.plane_normal_W.dot(places_W[k] - plane.plane_point_W);
    if (height_m < nearest.distance_m) nearest = {height_m, k};
  }
  return nearest;
}

/// Those nearest to the part's box are looked at first: of places far off few are left then, and a search
/// from there is dear.
Nearest nearest_to_part(const PlacedSurface& part, const std::vector<Vec3>& places_W) {
  const WorldBox box = world_box(part);
  std::vector<Bounded> in_order;
  in_order.reserve(places_W.size());
  for (std::size_t k = 0; k < places_W.size(); ++k) {
    const Vec3 beyond = (places_W[k] - box.middle).cwiseAbs() - box.half;
    // Within the box it may be as deep as any.
    in_order.emplace_back(
        beyond.maxCoeff() > 0 ? beyond.cwiseMax(0.0).norm() : -std::numeric_limits<double>::infinity(), k);
  }
  std::sort(in_order.begin(), in_order.end());
  const bool has_inside = !has_border(*part.part);
  ClosestMemory memory;
  Nearest nearest;
  for (const auto& [least_m, k] : in_order) {
    if (least_m >= nearest.distance_m) break;
    const WorldPoint point =
        nearest_point(part, places_W[k], Normals::facet, memory, std::numeric_limits<double>::infinity());
    if (!point.found) continue;
    const double distance_m = has_inside ? point.signed_distance_m : (places_W[k] - point.point_W).norm();
    if (distance_m < nearest.distance_m) nearest = {distance_m, k};
  }
  return nearest;
}

}  // namespace

NearestApproach nearest_approach(const World& world, const FingerPath& path, double radius_m,
                                 const Mat3& columns, long most_places) {
  const long last = path.tick_count() - 1, stride = last / most_places + 1;
  std::vector<long> ticks;
  for (long k = 0; k < last; k += stride) ticks.push_back(k);
  ticks.push_back(last);
  NearestApproach approach;
  std::vector<Vec3> places_W;
  places_W.reserve(ticks.size());
  for (const long k : ticks) {
    const Vec3 p_WQ = columns * path.at(k).p_WQ;
    if (places_W.empty()) approach.box_W = {p_WQ, p_WQ};
    approach.box_W.min = approach.box_W.min.cwiseMin(p_WQ);
    approach.box_W.max = approach.box_W.max.cwiseMax(p_WQ);
    if (stride > 1 && !places_W.empty())
      approach.between_m = std::max(approach.between_m, (p_WQ - places_W.back()).norm() / 2);
    places_W.push_back(p_WQ);
  }
  for (std::size_t i = 0; i < world.surfaces.size(); ++i) {
    const Surface& surface = world.surfaces[i];
    const Nearest nearest =
        surface.is_plane() ? nearest_to_plane(surface, places_W) : nearest_to_part(surface, places_W);
    if (!(nearest.distance_m - radius_m < approach.gap_m)) continue;
    approach.gap_m = nearest.distance_m - radius_m;
    approach.t_s = path.at(ticks[nearest.place]).t_s;
    approach.surface = i;
  }
  return approach;
}

}  // namespace fingerpad
