#include "app/check_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "base/count_words.hpp"
#include "base/number_text.hpp"
#include "base/printable_text.hpp"
#include "contact/closest_memory.hpp"
#include "contact/triangle_tree.hpp"
#include "part/part.hpp"
#include "scene/scene.hpp"

namespace fingerpad {
namespace {

/// Of a longer motion every so many-th tick: a second or two of searches at the most.
constexpr long most_places = 1000000;
/// A box of the finger's way that is so many times as large as all parts together is told. To a part and
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

/// A part whose surface has an edge is a sheet, which has no inside.
bool is_sheet(const PlacedSurface& surface) {
  return !surface.is_plane() && (surface.part->neighbours.array() < 0).any();
}

/// How far a place is from a surface, or less: from a part's box. Below a plane, and in a box, 0 or less.
double least_distance_m(const PlacedSurface& surface, const WorldBox& box, const Vec3& p_WQ) {
  if (surface.is_plane()) return surface.plane_normal_W.dot(p_WQ - surface.plane_point_W);
  return ((p_WQ - box.middle).cwiseAbs() - box.half).cwiseMax(0.0).norm();
}

/// How near any of the places comes to a surface; 0 or less within a part or below a plane. The places
/// nearest to the surface's box are looked at first: mostly few are left then.
double nearest_of_m(const PlacedSurface& surface, const std::vector<Vec3>& places_W, double enough_m) {
  const WorldBox box = surface.is_plane() ? WorldBox{} : world_box(surface);
  std::vector<std::pair<double, std::size_t>> by_distance;
  by_distance.reserve(places_W.size());
  for (std::size_t k = 0; k < places_W.size(); ++k)
    by_distance.emplace_back(least_distance_m(surface, box, places_W[k]), k);
  if (surface.is_plane()) return std::min_element(by_distance.begin(), by_distance.end())->first;
  std::sort(by_distance.begin(), by_distance.end());
  const bool has_inside = !is_sheet(surface);
  ClosestMemory memory;
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const auto& [least_m, k] : by_distance) {
    if (least_m >= nearest_m || nearest_m <= enough_m) break;
    const WorldPoint point = nearest_point(surface, places_W[k], Normals::facet, memory, nearest_m);
    if (!point.found) continue;
    const double distance_m = has_inside ? point.signed_distance_m : (places_W[k] - point.point_W).norm();
    nearest_m = std::min(nearest_m, distance_m);
  }
  return nearest_m;
}

/// Whether a way between two places goes through a part: a proxy is held there.
bool is_crossed(const PlacedSurface& surface, const std::vector<Vec3>& places_W) {
  const WorldBox box = world_box(surface);
  const auto crosses = [&](const Vec3& from_W, const Vec3& to_W) {
    if (least_distance_m(surface, box, from_W) > (to_W - from_W).norm()) return false;
    const auto from_centre = [&](const Vec3& p_W) {
      return Vec3(surface.R_WP.transpose() * (p_W - surface.p_WP) - surface.part->centre_P);
    };
    const Vec3 from = from_centre(from_W), to = from_centre(to_W);
    return surface.tree->first_crossing(from, to).triangle >= 0 ||
           surface.tree->first_crossing(to, from).triangle >= 0;
  };
  return std::adjacent_find(places_W.begin(), places_W.end(), crosses) != places_W.end();
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
  std::vector<Vec3> places_W;
  for (long k = 0; k < last; k += stride) places_W.push_back(path.at(k).p_WQ);
  places_W.push_back(path.at(last).p_WQ);
  double longest_m = 0;  // way from one place to the next
  for (std::size_t k = 0; k < places_W.size(); ++k) {
    check.box_W.min = check.box_W.min.cwiseMin(places_W[k]);
    check.box_W.max = check.box_W.max.cwiseMax(places_W[k]);
    if (k > 0) longest_m = std::max(longest_m, (places_W[k] - places_W[k - 1]).norm());
  }
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const PlacedSurface& surface : surfaces) {
    if (nearest_m <= scene.finger.radius_m) break;
    nearest_m = std::min(nearest_m, nearest_of_m(surface, places_W, scene.finger.radius_m));
    if (!surface.is_plane() && is_crossed(surface, places_W)) nearest_m = 0;
  }
  if (const Motion* recording = path.recording()) {
    check.box_W.min = recording->p_WQ.rowwise().minCoeff();
    check.box_W.max = recording->p_WQ.rowwise().maxCoeff();
  }
  // Between two places the finger may come nearer by half the way from one to the other.
  if (stride > 1) nearest_m -= longest_m / 2;
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
  // A plane is as wide as any motion.
  if (std::any_of(surfaces.begin(), surfaces.end(), [](const auto& surface) { return surface.is_plane(); }))
    return "";
  const Bounds parts = box_of(surfaces);
  const double way_m = (motion.box_W.max - motion.box_W.min).maxCoeff(),
               parts_m = (parts.max - parts.min).maxCoeff();
  if (!(parts_m > 0 && way_m > far_beyond * parts_m)) return "";
  return fmt::format("{} goes {} mm far, {:.0f} times the size of the parts; is its unit right?",
                     printable(motion.name), mm_text(way_m), way_m / parts_m);
}

}  // namespace fingerpad
