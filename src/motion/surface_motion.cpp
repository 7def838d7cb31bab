#include "motion/surface_motion.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "base/number_text.hpp"
#include "motion/finger_path.hpp"
#include "motion/proxy_trial.hpp"
#include "motion/sharp_edge.hpp"
#include "motion/surface_walk.hpp"
#include "part/border.hpp"
#include "part/random_places.hpp"

namespace fingerpad {
namespace {

constexpr double pi = std::numbers::pi;

/// How the spiral's angle grows from turn to turn: r = growth * angle.
double growth_of(const SurfaceMotion& rub) noexcept {
  return rub.size_m / (2 * pi * rub.turns);
}

/// Of the figure, as drawn once or as often as it asks for [m].
double length_m(const SurfaceMotion& rub) noexcept {
  if (rub.shape == SurfaceMotion::Shape::line) return rub.size_m * rub.turns;
  if (rub.shape == SurfaceMotion::Shape::circle) return 2 * pi * rub.size_m * rub.turns;
  const double end = 2 * pi * rub.turns;
  return growth_of(rub) / 2 * (end * std::hypot(1, end) + std::asinh(end));
}

/// What a finger goes in a tick, or in a millisecond where ticks are shorter.
double tick_way_m(const SurfaceMotion& rub, double rate_hz) noexcept {
  return rub.speed_m_per_s * std::max(1e-3, 1 / rate_hz);
}

/// Between samples: a millisecond's way, but no fewer than 50 and no more than 5,000 of the figure's size.
long steps_of(const SurfaceMotion& rub) noexcept {
  const double step_m = std::clamp(rub.speed_m_per_s * 1e-3, rub.size_m / 5000, rub.size_m / 50);
  return std::max(1L, std::lround(length_m(rub) / step_m));
}

/// The way from outside to the surface, and back in the end [m].
double lead_m(const SurfaceMotion& rub, double depth_m) noexcept {
  return depth_m + rub.size_m / 10;
}

/// By how much the figure turns on the step from `done_m` of its length.
class Turning {
 public:
  explicit Turning(const SurfaceMotion& rub) : rub_(rub), growth_m_(growth_of(rub)) {}
  double of_step(double step_m) noexcept {
    if (rub_.shape == SurfaceMotion::Shape::line) return 0;
    if (rub_.shape == SurfaceMotion::Shape::circle) return step_m / rub_.size_m;
    // Half a step, the curvature there, the other half: r = a phi has (2 + phi^2) / (a (1 + phi^2)^(3/2)).
    const double middle = angle_ + step_m / 2 / (growth_m_ * std::hypot(1, angle_));
    angle_ += step_m / (growth_m_ * std::hypot(1, middle));
    return step_m * (2 + middle * middle) / (growth_m_ * std::pow(1 + middle * middle, 1.5));
  }

 private:
  const SurfaceMotion& rub_;
  double growth_m_, angle_ = 0;
};

/// Whether the finger can come in from there. What lies around a point is known of a closed part alone: in a
/// valley of two sheets most of the view is sheet.
bool is_free(const TriangleTree& tree, SurfaceWalk& walk, const Vec3& from_P, double radius_m) {
  const Part& part = tree.part();
  if (!(walk.distance_at(from_P) > radius_m)) return false;
  return has_border(part) || !tree.encloses(from_P - part.centre_P);
}

/// What is drawn on the part, as far as one stroke or one figure goes.
struct Drawn {
  std::vector<Vec3> centres;
  std::vector<Vec3> normals;  ///< of each, outward
  int edges = 0;              ///< sharp ones that the finger goes round
};

/// Goes along the figure from where the walker stands; nothing where this place does not hold it.
/// @param edge_m  how far the centre keeps from sharp edges that it is taken round; 0: it is not
std::optional<Drawn> drawn(const SurfaceMotion& rub, double step_m, long steps, double edge_m,
                           SurfaceWalker walker, SurfaceWalk& walk) {
  Drawn way{{walker.p_P}, {walker.normal_P}, 0};
  Turning turning(rub);
  for (long k = 0; k < steps; ++k) {
    const SurfaceWalker before = walker;
    if (!walk.step(step_m, turning.of_step(step_m), walker)) return std::nullopt;
    if (edge_m > 0 && turns_sharp_edge(before, walker)) {
      const auto round = way_round_edge(before, walker, step_m, edge_m);
      if (round.empty()) return std::nullopt;
      ++way.edges;
      way.centres.insert(way.centres.end(), round.begin(), round.end());
      way.normals.resize(way.normals.size() + round.size() / 2, before.normal_P);
      way.normals.resize(way.centres.size(), walker.normal_P);
    }
    way.centres.push_back(walker.p_P);
    way.normals.push_back(walker.normal_P);
  }
  return way;
}

/// A rub's centres from outside to outside.
struct Walked {
  std::vector<Vec3> centres;
  int edges = 0;
};

/// At even steps; nothing where this place does not hold it.
std::optional<Walked> walked(const TriangleTree& tree, const SurfaceMotion& rub, double radius_m,
                             double depth_m, double rate_hz, const SurfaceWalker& walker, SurfaceWalk& walk) {
  const double out_m = lead_m(rub, depth_m);
  const Vec3 from_P = walker.p_P + out_m * walker.normal_P;
  if (!is_free(tree, walk, from_P, radius_m)) return std::nullopt;
  const long steps = steps_of(rub);
  const double step_m = length_m(rub) / static_cast<double>(steps);
  const bool is_line = rub.shape == SurfaceMotion::Shape::line;
  const long stroke = is_line ? std::min(steps, std::lround(rub.size_m / step_m)) : steps;
  // Far enough for a tick to fall there.
  const double edge_m = depth_m > radius_m ? std::max({step_m, tick_way_m(rub, rate_hz), radius_m / 4}) : 0;
  const auto way = drawn(rub, step_m, stroke, edge_m, walker, walk);
  if (!way) return std::nullopt;
  // A line goes back on its own way, round the edges too.
  const long turn = std::ssize(way->centres) - 1;
  const long end =
      std::lround(static_cast<double>(steps) / static_cast<double>(stroke) * static_cast<double>(turn));
  Walked all{{from_P}, way->edges};
  long at = 0;
  for (long k = 0; k <= end; ++k) {
    const long along = k % (2 * turn);
    at = along <= turn ? along : 2 * turn - along;
    all.centres.push_back(way->centres[static_cast<std::size_t>(at)]);
  }
  const auto last = static_cast<std::size_t>(at);
  all.centres.push_back(way->centres[last] + out_m * way->normals[last]);
  if (!is_free(tree, walk, all.centres.back(), radius_m)) return std::nullopt;
  return all;
}

/// The figure takes its time; what goes round sharp edges comes on top, at the same speed.
Motion timed(const Walked& walked, const SurfaceMotion& rub, double depth_m) {
  const std::vector<Vec3>& centres = walked.centres;
  const double lead_s = lead_m(rub, depth_m) / rub.speed_m_per_s;
  const double rub_s = length_m(rub) / rub.speed_m_per_s;
  const auto steps = static_cast<double>(steps_of(rub));
  Motion motion;
  motion.p_WQ.resize(3, static_cast<Eigen::Index>(centres.size()));
  for (std::size_t i = 0; i < centres.size(); ++i) motion.p_WQ.col(static_cast<Eigen::Index>(i)) = centres[i];
  motion.t_s = {0};
  for (std::size_t k = 0; k + 2 < centres.size(); ++k)
    motion.t_s.push_back(lead_s + rub_s * static_cast<double>(k) / steps);
  motion.t_s.push_back(walked.edges > 0 ? motion.t_s.back() + lead_s : duration_s(rub, depth_m));
  return motion;
}

std::string no_place_words(int tries, bool is_too_deep, const SurfaceMotion& rub, const Part& part) {
  const double across_m = (part.vertices.rowwise().maxCoeff() - part.vertices.rowwise().minCoeff()).norm();
  const std::string_view of_edges =
      is_too_deep ? "; at some a narrow edge would press it over a tenth deeper than asked, which a "
                    "finger.radius_m over twice the depth avoids, and shorter ticks or less speed may"
                  : "";
  const std::string of_unit =
      rub.size_m > across_m
          ? fmt::format("; the part is {} mm across: is its unit right?", rounded_text(1e3 * across_m, 3))
          : "";
  return fmt::format(
      "none of {} random places holds a rub of size_m {} for this finger: it would leave the part over an "
      "open rim, find no room or press through a thin wall{}; make size_m, the depth or the finger smaller{}",
      tries, rub.size_m, of_edges, of_unit);
}

}  // namespace

double duration_s(const SurfaceMotion& rub, double depth_m) noexcept {
  return (2 * lead_m(rub, depth_m) + length_m(rub)) / rub.speed_m_per_s;
}

LaidMotion lay_on_surface(const TriangleTree& tree, const SurfaceMotion& rub, double radius_m, double depth_m,
                          double rate_hz) {
  constexpr int most_tries = 300;
  constexpr double tolerance_of_size = 1e-6;
  constexpr double most_of_depth = 1.1;
  const RandomPlaces places(tree.part());
  RandomStream random(static_cast<std::uint64_t>(rub.place));
  bool is_too_deep = false;
  for (int tried = 1; tried <= most_tries; ++tried) {
    const int t = places.triangle(random);
    const Vec3 place_P = places.point(t, tree.part().centre_P, random);
    const double heading_rad = 2 * pi * random.uniform();
    SurfaceWalk walk(tree, radius_m - depth_m, tolerance_of_size * rub.size_m);
    SurfaceWalker walker;
    if (!walk.start(t, place_P, heading_rad, walker)) continue;
    const auto way = walked(tree, rub, radius_m, depth_m, rate_hz, walker, walk);
    if (!way) continue;
    Motion motion = timed(*way, rub, depth_m);
    // A shallow finger's centre is nearest to where its proxy is; a deep one may leave it behind an edge.
    if (depth_m > radius_m / 2 &&
        presses_deeper(tree, FingerPath(motion, rate_hz, Vec3::UnitX()), radius_m, most_of_depth * depth_m)) {
      is_too_deep = true;
      continue;
    }
    return {std::move(motion), place_P, tried, way->edges};
  }
  throw refused("", no_place_words(most_tries, is_too_deep, rub, tree.part()));
}

}  // namespace fingerpad
