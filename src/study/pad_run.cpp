#include "study/pad_run.hpp"

#include <algorithm>
#include <numbers>

#include "fingerpad/surface_properties.hpp"
#include "friction/law_table.hpp"
#include "study/profile_fit.hpp"

namespace fingerpad {
namespace {

constexpr double built_in_stiffness_per_m = 1000;  // stick_stiffness_per_m of the finger-pad law

bool is_given(const ProfileFit& fit, PadNumber number) {
  return value_of(fit.values, number).refusal.empty();
}

}  // namespace

PadOnPlate built_in_pad() {
  const SurfaceProperties plate;
  return {assumed_profile(plate.mu_static, built_in_stiffness_per_m), plate.mu_static, plate.mu_dynamic};
}

bool is_runnable(const ProfileFit& fit) {
  const bool has_axes = is_given(fit, PadNumber::lateral_axis) && is_given(fit, PadNumber::longitudinal_axis);
  return is_given(fit, PadNumber::mu_static) && is_given(fit, PadNumber::mu_dynamic) &&
         (has_axes || is_given(fit, PadNumber::stick_stiffness));
}

PadOnPlate fitted_pad(const ProfileFit& fit) {
  PadOnPlate pad;
  pad.mu_static = value_of(fit.values, PadNumber::mu_static).value;
  pad.mu_dynamic = std::min(value_of(fit.values, PadNumber::mu_dynamic).value, pad.mu_static);
  const bool has_axes = is_given(fit, PadNumber::lateral_axis) && is_given(fit, PadNumber::longitudinal_axis);
  pad.profile = assumed_profile(pad.mu_static, is_given(fit, PadNumber::stick_stiffness)
                                                   ? value_of(fit.values, PadNumber::stick_stiffness).value
                                                   : built_in_stiffness_per_m);
  if (has_axes) {
    pad.profile.lateral_axis_m = value_of(fit.values, PadNumber::lateral_axis).value;
    pad.profile.longitudinal_axis_m = value_of(fit.values, PadNumber::longitudinal_axis).value;
  }
  if (is_given(fit, PadNumber::lateral_slope))
    pad.profile.lateral_slope_per_deg = value_of(fit.values, PadNumber::lateral_slope).value;
  if (is_given(fit, PadNumber::longitudinal_slope))
    pad.profile.longitudinal_slope_per_deg = value_of(fit.values, PadNumber::longitudinal_slope).value;
  if (is_given(fit, PadNumber::v_min))
    pad.profile.v_min_m_per_s = value_of(fit.values, PadNumber::v_min).value;
  return pad;
}

std::vector<Vec2> pad_force_n(const MeasuredTrial& trial, const StickSegments& segments,
                              const PadOnPlate& pad) {
  LawSettings settings;
  settings.profile = pad.profile;
  const auto law = find_law("finger-pad")->make(settings);
  FrictionState state;
  std::vector<Vec2> force_n;
  force_n.reserve(trial.position_m.size());
  for (std::size_t i = 0; i < trial.position_m.size(); ++i) {
    const bool begins = i == 0 || trial.starts_anew[i];
    if (begins) state = FrictionState();
    TangentialMotion motion;
    motion.dt_s = 1 / trial.rate_hz;
    motion.normal_force_n = trial.normal_force_n[i];
    motion.mu_static = pad.mu_static;
    motion.mu_dynamic = pad.mu_dynamic;
    motion.inclination_rad = angle_deg(trial) * std::numbers::pi / 180;
    motion.velocity_m_per_s = segments.velocity_m_per_s[i];
    if (!begins) motion.step_m = trial.position_m[i] - trial.position_m[i - 1];
    force_n.push_back(law->tick(motion, state).force_n);
  }
  return force_n;
}

}  // namespace fingerpad
