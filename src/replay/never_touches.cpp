#include "replay/never_touches.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <utility>
#include <vector>

#include "base/number_text.hpp"

namespace fingerpad {
namespace {

constexpr double mm_per_m = 1e3;

/// "10 x 20 x 30 mm".
std::string size_text(const Vec3& size_m) {
  // To a nanometre: what a motion at one height spans is nothing.
  const Vec3 size_mm = (1e9 * size_m).array().round() / 1e6;
  return fmt::format("{} x {} x {} mm", rounded_text(size_mm.x(), 4), rounded_text(size_mm.y(), 4),
                     rounded_text(size_mm.z(), 4));
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
  constexpr long places = 2000;       // a question: what it asks is seen at some
  std::vector<std::string> ways;
  for (OtherColumns& other : other_columns()) {
    const double gap_m = nearest_approach(world, path, radius_m, other.columns, places).gap_m;
    if (gap_m < 0 && gap_m > -radius_m - deepest_m) ways.push_back(std::move(other.words));
  }
  if (ways.empty()) return {};
  return fmt::format("; with {} it does: is a column's sign turned, or named as another ([motion] columns)?",
                     fmt::join(ways, ", or with "));
}

}  // namespace

std::string never_touches(const World& world, const FingerPath& path, double radius_m, bool is_placed) {
  return never_touches(world, path, nearest_approach(world, path, radius_m), radius_m, is_placed);
}

std::string never_touches(const World& world, const FingerPath& path, const NearestApproach& nearest,
                          double radius_m, bool is_placed) {
  if (!(nearest.gap_m >= 0) || !std::isfinite(nearest.gap_m)) return {};
  const Surface& surface = world.surfaces[nearest.surface];
  const std::string reach = fmt::format(
      "the motion never touches: it comes nearest at t = {} s, {} mm from {}", rounded_text(nearest.t_s, 4),
      rounded_text(mm_per_m * nearest.gap_m, 4), counted_name(world, nearest.surface));
  const std::string spans = size_text(nearest.box_W.max - nearest.box_W.min);
  const std::string remedy =
      path.recording() != nullptr && !is_placed ? remedy_words(world, path, radius_m) : "";
  if (surface.is_plane())
    return fmt::format("{}; the motion spans {}: check [motion] unit{}", reach, spans, remedy);
  return fmt::format("{}; the part is {} and the motion spans {}: check [motion] unit and [[part]] unit{}",
                     reach, size_text(2 * world_box(surface).half), spans, remedy);
}

std::string pressed_too_deep(const Scene& scene, double depth_m) {
  constexpr double deepest_m = 0.03;
  if (scene.motion.file.empty() || !(depth_m > deepest_m)) return "";
  return fmt::format("the finger is pressed {} mm deep, which no finger is: check [motion] unit{}",
                     rounded_text(mm_per_m * depth_m, 4),
                     scene.parts.empty() ? "" : " and [[part]] unit (or is it held at a wall on its way?)");
}

}  // namespace fingerpad
