#include "contact/crowded_hollow.hpp"

#include <fmt/format.h>

#include <vector>

#include "base/number_text.hpp"
#include "contact/contact_method_table.hpp"
#include "contact/proxy_memory_limits.hpp"
#include "contact/surface_places.hpp"
#include "contact/triangle_tree.hpp"

namespace fingerpad {
namespace {

constexpr double near_share = 1.0 / 64;
/// A ball that has more room than this share of the hollow's radius is near few triangles of it.
constexpr double tight_room = 0.25;
constexpr std::size_t most_hollows = 128;

/// How many triangles are near a ball that rests on a place.
int near_facets(const TriangleTree& tree, const SurfacePlace& place, double radius_m) {
  const Part& part = tree.part();
  Vec3 centre = radius_m * part.facet_normals.col(place.triangle);
  for (int k = 0; k < 3; ++k) centre += part.vertices.col(part.triangles(k, place.triangle)) / 3;
  SearchLimit limit{ProxyMemoryLimits::richest_view, ProxyMemoryLimits::most_packets};
  tree.each_within(
      centre, (1 + near_share) * radius_m, limit, [](void*, int) {}, nullptr);
  return limit.is_exceeded() ? ProxyMemoryLimits::richest_view + 1 : limit.triangles;
}

}  // namespace

bool CrowdedHollow::is_too_much() const noexcept {
  return facets > ProxyMemoryLimits::richest_view;
}

CrowdedHollow most_crowded_hollow(const TriangleTree& tree, std::span<const SurfacePlace> places,
                                  double radius_m) {
  CrowdedHollow most;
  if (!(radius_m > 0)) return most;
  std::vector<const SurfacePlace*> tight;
  for (const SurfacePlace& place : places) {
    const double room = 1 + radius_m * place.curvature_per_m;
    if (place.curvature_per_m < 0 && room > 0 && room < tight_room) tight.push_back(&place);
  }
  const std::size_t step = tight.size() / most_hollows + 1;
  for (std::size_t i = 0; i < tight.size(); i += step) {
    const int facets = near_facets(tree, *tight[i], radius_m);
    if (facets > most.facets) most = {facets, -1 / tight[i]->curvature_per_m};
    if (most.is_too_much()) break;
  }
  return most;
}

std::string proxy_fails(const ContactDemand& demand) {
  if (!demand.crowded.is_too_much()) return {};
  return fmt::format("a {} mm finger is near more than {} facets at once in a hollow of {} mm",
                     rounded_text(1e3 * demand.finger_radius_m, 3), ProxyMemoryLimits::richest_view,
                     rounded_text(1e3 * demand.crowded.radius_m, 3));
}

}  // namespace fingerpad
