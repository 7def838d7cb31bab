#include "app/check_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/count_words.hpp"
#include "base/number_text.hpp"
#include "base/printable_text.hpp"
#include "contact/closest_memory.hpp"
#include "contact/triangle_tree.hpp"
#include "part/part.hpp"
#include "scene/scene.hpp"

namespace fingerpad {
namespace {

/// Of a longer motion every so many-th tick: half a minute of searches at the most.
constexpr long most_places = 100000;
/// A box of the finger's way that is so many times as large as all parts together is told.
constexpr double far_beyond = 20;

std::string mm_text(double m) {
  return rounded_text(std::round(1e9 * m) / 1e6 + 0.0, 5);
}

/// "120 x 0 x 1.5 mm, from (-60, 10, 0) mm".
std::string box_words(const Bounds& box) {
  const Vec3 size = box.max - box.min;
  return fmt::format("{} x {} x {} mm, from ({}, {}, {}) mm", mm_text(size.x()), mm_text(size.y()),
                     mm_text(size.z()), mm_text(box.min.x()), mm_text(box.min.y()), mm_text(box.min.z()));
}

/// How far a place is from the nearest surface; less than 0 in a part or below a plane. Infinity where it is
/// farther than that.
double distance_m(std::span<const PlacedSurface> surfaces, std::span<ClosestMemory> memories,
                  const Vec3& p_WQ, double within_m) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const WorldPoint point =
        nearest_point(surfaces[i], p_WQ, Normals::facet, memories[i], std::min(within_m, nearest_m));
    if (point.found) nearest_m = std::min(nearest_m, point.signed_distance_m);
  }
  return nearest_m;
}

/// Whether the way between two ticks' places goes through a part: a proxy is held there.
bool crosses_a_part(std::span<const PlacedSurface> surfaces, const Vec3& from_W, const Vec3& to_W) {
  return std::any_of(surfaces.begin(), surfaces.end(), [&](const PlacedSurface& surface) {
    if (surface.is_plane()) return false;
    const auto from_centre = [&](const Vec3& p_W) {
      return Vec3(surface.R_WP.transpose() * (p_W - surface.p_WP) - surface.part->centre_P);
    };
    const Vec3 from = from_centre(from_W), to = from_centre(to_W);
    return surface.tree->first_crossing(from, to).triangle >= 0 ||
           surface.tree->first_crossing(to, from).triangle >= 0;
  });
}

Bounds box_of(std::span<const PlacedSurface> surfaces) {
  Bounds all;
  bool any = false;
  for (const PlacedSurface& surface : surfaces) {
    if (surface.is_plane()) continue;
    const WorldBox box = world_box(surface);
    const Vec3 low = box.middle - box.half, high = box.middle + box.half;
    all.min = any ? Vec3(all.min.cwiseMin(low)) : low;
    all.max = any ? Vec3(all.max.cwiseMax(high)) : high;
    any = true;
  }
  return all;
}

}  // namespace

MotionCheck look_at_motion(const Scene& scene, const LoadedMotion& motion,
                           std::span<const PlacedSurface> surfaces) {
  const FingerPath& path = motion.path;
  MotionCheck check;
  check.name = scene.motion.file.empty() ? "[motion]" : scene.motion.file;
  check.ticks = path.tick_count();
  check.rate_hz = path.rate_hz();
  check.duration_s = path.end_s() - path.start_s();
  const long last = path.tick_count() - 1, stride = last / most_places + 1;
  check.box_W.min = check.box_W.max = path.at(last).p_WQ;
  std::vector<ClosestMemory> memories(surfaces.size());
  double nearest_m = std::numeric_limits<double>::infinity();
  Vec3 before_W = path.at(0).p_WQ;
  const auto go_to = [&](const Vec3& p_WQ) {
    check.box_W.min = check.box_W.min.cwiseMin(p_WQ);
    check.box_W.max = check.box_W.max.cwiseMax(p_WQ);
    if (nearest_m > scene.finger.radius_m)
      nearest_m = crosses_a_part(surfaces, std::exchange(before_W, p_WQ), p_WQ)
                      ? 0
                      : std::min(nearest_m, distance_m(surfaces, memories, p_WQ, nearest_m));
  };
  for (long k = 0; k < last; k += stride) go_to(path.at(k).p_WQ);
  go_to(path.at(last).p_WQ);
  if (const Motion* recording = path.recording()) {
    check.box_W.min = recording->p_WQ.rowwise().minCoeff();
    check.box_W.max = recording->p_WQ.rowwise().maxCoeff();
  }
  check.nearest_m = std::max(0.0, nearest_m - scene.finger.radius_m);
  return check;
}

std::string motion_text(const MotionCheck& motion, const std::string& scene_path) {
  return fmt::format(
      "{}: {} can be followed\n  motion         {} at {} Hz, {} s\n  in a box of    {}\n", scene_path,
      printable(motion.name), count_words(static_cast<std::size_t>(motion.ticks), "tick"),
      rounded_text(motion.rate_hz, 6), rounded_text(motion.duration_s, 6), box_words(motion.box_W));
}

nlohmann::ordered_json motion_json(const MotionCheck& motion) {
  const auto place = [](const Vec3& p) { return nlohmann::ordered_json{p.x(), p.y(), p.z()}; };
  return {{"name", motion.name},
          {"ticks", motion.ticks},
          {"rate_hz", motion.rate_hz},
          {"duration_s", motion.duration_s},
          {"bounds_m", {{"min", place(motion.box_W.min)}, {"max", place(motion.box_W.max)}}},
          {"nearest_m", motion.nearest_m}};
}

std::string motion_hint(const MotionCheck& motion, std::span<const PlacedSurface> surfaces) {
  if (motion.nearest_m > 0)
    return fmt::format(
        "{} touches nothing: the finger comes no nearer than {} mm to any surface; are its unit, "
        "its frame and the parts' `position_m` right?",
        printable(motion.name), mm_text(motion.nearest_m));
  const Bounds parts = box_of(surfaces);
  const double way_m = (motion.box_W.max - motion.box_W.min).maxCoeff(),
               parts_m = (parts.max - parts.min).maxCoeff();
  if (!(parts_m > 0 && way_m > far_beyond * parts_m)) return "";
  return fmt::format("{} goes {} mm far, {:.0f} times the size of what there is to touch; is its unit right?",
                     printable(motion.name), mm_text(way_m), way_m / parts_m);
}

}  // namespace fingerpad
