#pragma once

#include <string>

namespace fingerpad {

/// The finger pad of one person: the stick ellipse against the finger's inclination (paper, figs. 4-7), and
/// what goes with it. Axes hold at `mu_static`; pad stiffness belongs to the finger, so they scale with a
/// part's mu.
struct PadProfile {
  double lateral_axis_m = 0;            ///< a at 45 deg
  double longitudinal_axis_m = 0;       ///< b at 45 deg
  double lateral_slope_per_deg = 0.01;  ///< a(alpha) = a45 (1 - s (alpha - 45 deg))
  double longitudinal_slope_per_deg = 0.01;
  double mu_static = 0.3;
  double v_min_m_per_s = 0.1;
  double vibration_hz = 89;
  std::string source;  ///< where the numbers come from

  double lateral_axis_at(double inclination_rad) const noexcept;
  double longitudinal_axis_at(double inclination_rad) const noexcept;
};

/// An axis at an inclination, from what it is at 45 degrees.
double pad_axis_at(double axis45_m, double slope_per_deg, double inclination_deg) noexcept;

/// The assumed pad when a scene names none: a = mu_static / stick_stiffness, b = 0.8 a, slopes 0.01 per
/// degree.
PadProfile assumed_profile(double mu_static, double stick_stiffness_per_m);

}  // namespace fingerpad
