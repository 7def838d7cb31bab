#include "replay/never_touches.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

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

/// Where a path comes nearest, and which place it spans.
struct Nearest {
  double gap_m = std::numeric_limits<double>::infinity();
  double t_s = 0;
  std::size_t surface = 0;
  Vec3 low, high;
};

/// @param columns  how the path's coordinates are taken: a row an axis
Nearest nearest_of(const World& world, const FingerPath& path, double radius_m, const Mat3& columns) {
  constexpr long most_places = 2000;
  const long stride = std::max(1L, path.tick_count() / most_places);
  Nearest nearest;
  nearest.low = nearest.high = columns * path.at(0).p_WQ;
  for (long k = 0; k < path.tick_count(); k += stride) {
    const FingerSample sample = path.at(k);
    const Vec3 p_WQ = columns * sample.p_WQ;
    nearest.low = nearest.low.cwiseMin(p_WQ);
    nearest.high = nearest.high.cwiseMax(p_WQ);
    for (std::size_t i = 0; i < world.surfaces.size(); ++i) {
      const WorldPoint point =
          nearest_point(world.surfaces[i], p_WQ, Normals::facet, -1, std::numeric_limits<double>::infinity());
      const double gap_m = point.signed_distance_m - radius_m;
      if (!point.found || !(gap_m < nearest.gap_m)) continue;
      nearest.gap_m = gap_m;
      nearest.t_s = sample.t_s;
      nearest.surface = i;
    }
  }
  return nearest;
}

/// Columns that a recording may have otherwise than the scene takes them.
struct OtherColumns {
  Mat3 columns;
  std::string words;
};

std::vector<OtherColumns> other_columns() {
  constexpr const char* names[] = {"x", "y", "z"};
  std::vector<OtherColumns> others;
  for (int axis = 0; axis < 3; ++axis) {
    OtherColumns mirrored{Mat3::Identity(), fmt::format("{} mirrored", names[axis])};
    mirrored.columns(axis, axis) = -1;
    others.push_back(std::move(mirrored));
  }
  for (const auto& [one, other] : {std::pair(0, 1), {1, 2}, {0, 2}}) {
    OtherColumns swapped{Mat3::Identity(), fmt::format("{} and {} swapped", names[one], names[other])};
    swapped.columns.row(one).swap(swapped.columns.row(other));
    others.push_back(std::move(swapped));
  }
  return others;
}

/// What would make a recording touch, no deeper than a finger presses; empty where nothing does.
std::string remedy_words(const World& world, const FingerPath& path, double radius_m) {
  constexpr double deepest_m = 5e-3;  // of the finger's centre in a part: a pad is softer than that
  std::vector<std::string> ways;
  for (OtherColumns& other : other_columns()) {
    const double gap_m = nearest_of(world, path, radius_m, other.columns).gap_m;
    if (gap_m < 0 && gap_m > -radius_m - deepest_m) ways.push_back(std::move(other.words));
  }
  if (ways.empty()) return {};
  return fmt::format("; with {} it does: is a column's sign turned, or named as another ([motion] columns)?",
                     fmt::join(ways, ", or with "));
}

}  // namespace

std::string never_touches(const World& world, const FingerPath& path, double radius_m, bool is_placed) {
  const Nearest nearest = nearest_of(world, path, radius_m, Mat3::Identity());
  if (!(nearest.gap_m >= 0) || !std::isfinite(nearest.gap_m)) return {};
  const Surface& surface = world.surfaces[nearest.surface];
  const std::string reach =
      fmt::format("the motion never touches: it comes nearest at t = {} s, {} mm from",
                  rounded_text(nearest.t_s, 4), rounded_text(mm_per_m * nearest.gap_m, 4));
  const std::string spans = size_text(nearest.high - nearest.low);
  const std::string remedy =
      path.recording() != nullptr && !is_placed ? remedy_words(world, path, radius_m) : "";
  if (surface.is_plane())
    return fmt::format("{} plane {}; the motion spans {}: check [motion] unit{}", reach, nearest.surface,
                       spans, remedy);
  return fmt::format(
      "{} part {} ({}); the part is {} and the motion spans {}: check [motion] unit and [[part]] unit{}",
      reach, nearest.surface, printable(surface.mesh, 200), size_text(2 * world_box(surface).half), spans,
      remedy);
}

}  // namespace fingerpad
