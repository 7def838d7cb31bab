#include "replay/never_touches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/number_text.hpp"
#include "base/printable_text.hpp"

namespace fingerpad {
namespace {

constexpr double mm_per_m = 1e3;

/// "10 x 20 x 30 mm".
std::string size_text(const Vec3& size_m) {
  const Vec3 size_mm = mm_per_m * size_m;
  return fmt::format("{} x {} x {} mm", rounded_text(size_mm.x(), 4), rounded_text(size_mm.y(), 4),
                     rounded_text(size_mm.z(), 4));
}

/// Where a path comes nearest.
struct Nearest {
  double gap_m = std::numeric_limits<double>::infinity();
  double t_s = 0;
  std::size_t surface = 0;
};

}  // namespace

std::string never_touches(const World& world, const FingerPath& path, double radius_m) {
  constexpr long most_places = 2000;
  const long stride = std::max(1L, path.tick_count() / most_places);
  Nearest nearest;
  Vec3 low = path.at(0).p_WQ, high = low;
  for (long k = 0; k < path.tick_count(); k += stride) {
    const FingerSample sample = path.at(k);
    low = low.cwiseMin(sample.p_WQ);
    high = high.cwiseMax(sample.p_WQ);
    for (std::size_t i = 0; i < world.surfaces.size(); ++i) {
      const WorldPoint point = nearest_point(world.surfaces[i], sample.p_WQ, Normals::facet, -1,
                                             std::numeric_limits<double>::infinity());
      const double gap_m = point.signed_distance_m - radius_m;
      if (point.found && gap_m < nearest.gap_m) nearest = {gap_m, sample.t_s, i};
    }
  }
  if (!(nearest.gap_m >= 0) || !std::isfinite(nearest.gap_m)) return {};
  const Surface& surface = world.surfaces[nearest.surface];
  const std::string reach =
      fmt::format("the motion never touches: it comes nearest at t = {} s, {} mm from",
                  rounded_text(nearest.t_s, 4), rounded_text(mm_per_m * nearest.gap_m, 4));
  if (surface.is_plane()) {
    return fmt::format("{} plane {}; the motion spans {}: check [motion] unit", reach, nearest.surface,
                       size_text(high - low));
  }
  return fmt::format(
      "{} part {} ({}); the part is {} and the motion spans {}: check [motion] unit and [[part]] unit", reach,
      nearest.surface, printable(surface.mesh, 200), size_text(2 * world_box(surface).half),
      size_text(high - low));
}

}  // namespace fingerpad
