#include "friction/pad_profile.hpp"

#include <numbers>

namespace fingerpad {

double pad_axis_at(double axis45_m, double slope_per_deg, double inclination_deg) noexcept {
  return axis45_m * (1 - slope_per_deg * (inclination_deg - 45));
}

double PadProfile::lateral_axis_at(double inclination_rad) const noexcept {
  return pad_axis_at(lateral_axis_m, lateral_slope_per_deg, inclination_rad * 180 / std::numbers::pi);
}

double PadProfile::longitudinal_axis_at(double inclination_rad) const noexcept {
  return pad_axis_at(longitudinal_axis_m, longitudinal_slope_per_deg,
                     inclination_rad * 180 / std::numbers::pi);
}

PadProfile assumed_profile(double mu_static, double stick_stiffness_per_m) {
  PadProfile profile;
  profile.mu_static = mu_static;
  profile.lateral_axis_m = mu_static / stick_stiffness_per_m;
  profile.longitudinal_axis_m = 0.8 * profile.lateral_axis_m;
  profile.source = "assumption: b = 0.8 a, slopes 0.01 per degree; the paper's figures give no numbers";
  return profile;
}

}  // namespace fingerpad
