#include "rub.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace fingerpad::parts {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double steepest = 2.0;
constexpr double even_out_s = 0.010;  // standard deviation of the smoothing in time
constexpr double tremor_hz = 9.1, tremor_mm = 0.02;
constexpr double waver_hz = 0.43, waver_share = 0.15;

double radians(double degrees) {
  return degrees * M_PI / 180;
}

/// The finger as told, before it meets the surface.
struct Told {
  Vector2d point;
  double depth_mm, inclination_deg, heading_deg;
};

/// Minimum-jerk progress (Flash & Hogan 1985): 0 to 1 with zero speed and acceleration at both ends.
double minimum_jerk(double s) {
  return s * s * s * (10 - 15 * s + 6 * s * s);
}

Told within(const Stroke& stroke, const Told& from, double progress) {
  const auto blend = [&](double a, double b) { return a + (b - a) * progress; };
  Told told{from.point, blend(from.depth_mm, stroke.depth_mm),
            blend(from.inclination_deg, stroke.inclination_deg), blend(from.heading_deg, stroke.heading_deg)};
  if (stroke.kind == Stroke::Kind::straight) {
    told.point = from.point + (stroke.point - from.point) * progress;
  } else {
    const Vector2d arm = from.point - stroke.point;
    const double angle = 2 * M_PI * stroke.turns * progress;
    told.point = stroke.point + Vector2d(arm.x() * std::cos(angle) - arm.y() * std::sin(angle),
                                         arm.x() * std::sin(angle) + arm.y() * std::cos(angle));
  }
  return told;
}

std::vector<Told> follow(const Recipe& recipe, double rate_hz) {
  Told at{recipe.start.point, recipe.start.depth_mm, recipe.start.inclination_deg, recipe.start.heading_deg};
  std::vector<Told> all = {at};
  for (const Stroke& stroke : recipe.strokes) {
    const long ticks = std::lround(stroke.seconds * rate_hz);
    for (long k = 1; k <= ticks; ++k)
      all.push_back(within(stroke, at, minimum_jerk(double(k) / double(ticks))));
    at = all.back();
  }
  return all;
}

void tremble(std::vector<Told>& path, double rate_hz) {
  for (size_t i = 0; i < path.size(); ++i) {
    const double phase = 2 * M_PI * tremor_hz * double(i) / rate_hz;
    // Three incommensurate tones, so that no two strokes tremble alike.
    path[i].point += tremor_mm * Vector2d(std::sin(phase) + 0.5 * std::sin(1.37 * phase + 1),
                                          std::sin(1.13 * phase + 2) + 0.5 * std::sin(0.71 * phase));
    const double waver = 1 + waver_share * std::sin(2 * M_PI * waver_hz * double(i) / rate_hz);
    if (path[i].depth_mm > 0) path[i].depth_mm *= waver;
  }
}

/// Heights that never fall faster than `steepest` along the path, before or behind a crest.
void limit_slope(std::vector<double>& height, const std::vector<Told>& path) {
  const auto fall = [&](size_t i) { return steepest * (path[i].point - path[i - 1].point).norm(); };
  for (size_t i = 1; i < height.size(); ++i) height[i] = std::max(height[i], height[i - 1] - fall(i));
  for (size_t i = height.size() - 1; i > 0; --i) height[i - 1] = std::max(height[i - 1], height[i] - fall(i));
}

std::vector<double> evened_out(const std::vector<double>& values, double rate_hz) {
  const double sigma = even_out_s * rate_hz;
  const long reach = std::lround(3 * sigma);
  const long n = long(values.size());
  std::vector<double> out(values.size());
  for (long i = 0; i < n; ++i) {
    double sum = 0;
    double weights = 0;
    for (long k = -reach; k <= reach; ++k) {
      const double weight = std::exp(-0.5 * double(k * k) / (sigma * sigma));
      sum += weight * values[size_t(std::clamp(i + k, 0L, n - 1))];
      weights += weight;
    }
    out[size_t(i)] = sum / weights;
  }
  return out;
}

}  // namespace

std::vector<RubSample> rub(const Recipe& recipe, const RollingSphere& surface, double rate_hz) {
  std::vector<Told> path = follow(recipe, rate_hz);
  tremble(path, rate_hz);
  std::vector<double> height;
  for (const Told& told : path) {
    const auto z = surface.centre_height_mm(told.point.x(), told.point.y());
    if (!z) throw std::runtime_error(recipe.name + ": the path leaves the part");
    height.push_back(*z);
  }
  limit_slope(height, path);
  for (size_t i = 0; i < path.size(); ++i) height[i] -= path[i].depth_mm;
  height = evened_out(height, rate_hz);
  std::vector<RubSample> samples;
  for (size_t i = 0; i < path.size(); ++i) {
    const double inclination = radians(path[i].inclination_deg);
    const double heading = radians(path[i].heading_deg);
    const Vector3d direction(std::sin(heading) * std::cos(inclination),
                             std::cos(heading) * std::cos(inclination), -std::sin(inclination));
    samples.push_back({double(i) / rate_hz, {path[i].point.x(), path[i].point.y(), height[i]}, direction});
  }
  return samples;
}

}  // namespace fingerpad::parts
