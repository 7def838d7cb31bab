#include "app/check_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "base/count_words.hpp"
#include "base/number_text.hpp"
#include "base/printable_text.hpp"
#include "contact/triangle_tree.hpp"
#include "part/part.hpp"
#include "replay/never_touches.hpp"
#include "scene/scene.hpp"
#include "touch/parts_ball.hpp"

namespace fingerpad {
namespace {

/// A way whose box is so many times as large as the ball around all parts is told. To a part and
/// back a hand goes some times its size; a wrong unit makes that tens to thousands of times.
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

/// Whether a way from tick to tick goes through a part: a proxy is held there. Of a motion of more than a
/// million ticks, one of those.
bool is_crossed(const PlacedSurface& part, const FingerPath& path) {
  const auto from_centre = [&](long tick) {
    return Vec3(part.R_WP.transpose() * (path.at(tick).p_WQ - part.p_WP) - part.part->centre_P);
  };
  Vec3 from = from_centre(0);
  for (long k = 1; k < std::min(path.tick_count(), most_approach_places); ++k) {
    const Vec3 to = from_centre(k);
    if (part.tree->first_crossing(from, to).triangle >= 0 ||
        part.tree->first_crossing(to, from).triangle >= 0)
      return true;
    from = to;
  }
  return false;
}

bool crosses_a_part(const World& world, const FingerPath& path) {
  return std::any_of(world.surfaces.begin(), world.surfaces.end(), [&](const Surface& surface) {
    return !surface.is_plane() && is_crossed(surface, path);
  });
}

/// That it goes far beyond the parts; of planes, which are as wide as any motion, nothing is said.
std::string far_words(const MotionCheck& motion, const World& world) {
  const auto is_plane = [](const Surface& surface) { return surface.is_plane(); };
  if (std::any_of(world.surfaces.begin(), world.surfaces.end(), is_plane)) return "";
  const std::optional<Ball> parts = ball_of_parts(world);
  const double way_m = (motion.box_W.max - motion.box_W.min).norm();
  if (!parts || !(way_m > far_beyond * 2 * parts->radius_m)) return "";
  return fmt::format("the motion goes {} mm far, {:.0f} times the size of the parts: check [motion] unit",
                     mm_text(way_m), way_m / (2 * parts->radius_m));
}

}  // namespace

std::string motion_name(const Scene& scene) {
  return scene.motion.file.empty() ? "[motion]" : scene.motion.file;
}

MotionCheck look_at_motion(const Scene& scene, const LoadedMotion& motion, const World& world) {
  const FingerPath& path = motion.path;
  const double radius_m = scene.finger.radius_m;
  const NearestApproach approach = nearest_approach(world, path, radius_m);
  MotionCheck check;
  check.name = motion_name(scene);
  check.ticks = path.tick_count();
  check.rate_hz = path.rate_hz();
  check.duration_s = path.end_s() - path.start_s();
  check.box_W = approach.box_W;
  if (const Motion* recording = path.recording()) {
    check.box_W.min = recording->p_WQ.rowwise().minCoeff();
    check.box_W.max = recording->p_WQ.rowwise().maxCoeff();
  }
  const bool may_touch =
      approach.gap_m < approach.between_m || approach.gap_m <= 0 || crosses_a_part(world, path);
  check.nearest_m = may_touch ? 0 : approach.gap_m - approach.between_m;
  if (scene.hand && !may_touch) return check;  // where it goes its goal does not tell
  if (!may_touch) {
    check.hint = never_touches(world, path, approach, radius_m, !scene.motion.placement.is_world());
    return check;
  }
  // How deep it is in a part depends on how it came there.
  if (world.surfaces[approach.surface].is_plane()) check.hint = pressed_too_deep(scene, -approach.gap_m);
  if (check.hint.empty() && !scene.hand) check.hint = far_words(check, world);
  return check;
}

std::string motion_text(const MotionCheck& motion, const std::string& scene_path) {
  return fmt::format(
      "{}: {} can be followed\n  motion         {} at {} Hz, {} s\n  in a box of    {}\n", scene_path,
      printable(motion.name), count_words(static_cast<std::size_t>(motion.ticks), "tick"),
      rounded_text(motion.rate_hz, 6), rounded_text(motion.duration_s, 6), box_words(motion.box_W));
}

nlohmann::ordered_json motion_json(const MotionCheck& motion, std::vector<std::string> warnings) {
  if (!motion.hint.empty()) warnings.push_back(motion.hint);
  const auto place = [](const Vec3& p) { return nlohmann::ordered_json{p.x(), p.y(), p.z()}; };
  return {{"name", motion.name},
          {"ticks", motion.ticks},
          {"rate_hz", motion.rate_hz},
          {"duration_s", motion.duration_s},
          {"bounds_m", {{"min", place(motion.box_W.min)}, {"max", place(motion.box_W.max)}}},
          {"nearest_m", motion.nearest_m},
          {"warnings", std::move(warnings)}};
}

}  // namespace fingerpad
