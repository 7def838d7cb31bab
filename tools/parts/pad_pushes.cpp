#include "pad_pushes.hpp"

#include <algorithm>
#include <cmath>

namespace fingerpad::parts {
namespace {

constexpr double lateral_axis_mm = 2, longitudinal_axis_mm = 1.6, slope_per_deg = 0.01;  // soft_pad.toml
constexpr double depth_mm = 2, hover_mm = 1;
constexpr double press_s = 0.2, out_s = 0.4, round_s = 1.6;

/// 0 before t0, 1 after t1, without a kink in speed.
double rise(double t, double t0, double t1) {
  const double s = std::clamp((t - t0) / (t1 - t0), 0.0, 1.0);
  return s * s * (3 - 2 * s);
}

Eigen::Vector3d pointing(double angle_deg) {
  const double angle = angle_deg * M_PI / 180;
  return {0, std::cos(angle), -std::sin(angle)};
}

/// Height of a finger that presses during [press_s, end - press_s].
double height_mm(double t, double end_s) {
  return hover_mm - (depth_mm + hover_mm) * rise(t, 0, press_s) * (1 - rise(t, end_s - press_s, end_s));
}

}  // namespace

std::vector<RubSample> pad_ellipses(double rate_hz) {
  constexpr double share = 0.97;
  constexpr double turn_s = 2 * press_s + 2 * out_s + round_s;
  std::vector<RubSample> samples;
  double start_s = 0;
  for (const double angle_deg : {15, 30, 45, 60, 75}) {
    const double size = share * (1 - slope_per_deg * (angle_deg - 45));
    const long last = std::lround(turn_s * rate_hz);
    for (long k = samples.empty() ? 0 : 1; k <= last; ++k) {
      const double t = double(k) / rate_hz;
      const double begin = press_s + out_s, end = begin + round_s;
      const double radius = size * rise(t, press_s, begin) * (1 - rise(t, end, end + out_s));
      const double turned = 2 * M_PI * rise(t, begin, end);
      samples.push_back({start_s + t,
                         {radius * lateral_axis_mm * std::cos(turned),
                          radius * longitudinal_axis_mm * std::sin(turned), height_mm(t, turn_s)},
                         pointing(angle_deg)});
    }
    start_s = samples.back().t_s;
  }
  return samples;
}

std::vector<RubSample> pad_pushes(double rate_hz) {
  constexpr double share = 0.9, push_s = 1, pushes = 2;
  constexpr double half_s = pushes * push_s, end_s = 2 * press_s + 2 * half_s;
  std::vector<RubSample> samples;
  const long last = std::lround(end_s * rate_hz);
  for (long k = 0; k <= last; ++k) {
    const double t = double(k) / rate_hz;
    const double pushing_s = std::clamp(t - press_s, 0.0, 2 * half_s);
    const double wave = share * std::sin(2 * M_PI * pushing_s / push_s);
    const bool lateral = pushing_s < half_s;
    samples.push_back({t,
                       {lateral ? lateral_axis_mm * wave : 0, lateral ? 0 : longitudinal_axis_mm * wave,
                        height_mm(t, end_s)},
                       pointing(45)});
  }
  return samples;
}

}  // namespace fingerpad::parts
