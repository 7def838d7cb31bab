#include "plane_strokes.hpp"

#include <algorithm>
#include <cmath>

namespace fingerpad::parts {
namespace {

constexpr double duration_s = 6;
constexpr double stroke_hz = 2.1, rhythm_drift_rad = 0.8, rhythm_drift_hz = 0.23;
constexpr double reach_mm = 47, reach_drift_mm = 7, reach_drift_hz = 0.31;
constexpr double depth_mm = 3, depth_drift_mm = 0.8, depth_drift_hz = 0.37, hover_mm = 5;
constexpr double press_s = 0.4, start_s = 0.2;  // it presses first, then begins to stroke

/// 0 before t0, 1 after t1, without a kink in speed or acceleration.
double rise(double t, double t0, double t1) {
  const double s = std::clamp((t - t0) / (t1 - t0), 0.0, 1.0);
  return s * s * s * (10 - 15 * s + 6 * s * s);
}

double wave(double hz, double t, double phase_rad) {
  return std::sin(2 * M_PI * hz * t + phase_rad);
}

}  // namespace

std::vector<RubSample> plane_strokes(double rate_hz) {
  std::vector<RubSample> samples;
  const long last = std::lround(duration_s * rate_hz);
  for (long k = 0; k <= last; ++k) {
    const double t = double(k) / rate_hz;
    const double stroking =
        rise(t, press_s, press_s + start_s) * (1 - rise(t, duration_s - 0.7, duration_s - 0.5));
    const double phase =
        2 * M_PI * stroke_hz * (t - press_s) + rhythm_drift_rad * wave(rhythm_drift_hz, t, 0);
    const double reach = reach_mm + reach_drift_mm * wave(reach_drift_hz, t, 1);
    const double pressing = rise(t, 0, press_s) * (1 - rise(t, duration_s - press_s, duration_s));
    const double depth =
        (depth_mm + depth_drift_mm * wave(depth_drift_hz, t, 2) + hover_mm) * pressing - hover_mm;
    samples.push_back({t, {0, stroking * reach * std::sin(phase), -depth}, Eigen::Vector3d::Zero()});
  }
  return samples;
}

}  // namespace fingerpad::parts
