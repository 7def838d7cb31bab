#pragma once

#include <algorithm>

#include "friction/law.hpp"

namespace fingerpad {

/// Far beyond anything physical, and small enough that no product within a law overflows.
inline constexpr double huge = 1e100;

/// x within [low, high]; `low` for NaN.
inline double within(double x, double low, double high) noexcept {
  return std::min(std::max(low, x), high);  // in this order NaN becomes `low`
}

inline Vec2 within_huge(const Vec2& v) noexcept {
  return {within(v.x(), -huge, huge), within(v.y(), -huge, huge)};
}

/// The tick's input with every number brought into a range in which each law stays finite, and mu_s >= mu_d.
/// Every law starts with it; physical input passes unchanged.
inline TangentialMotion bounded(const TangentialMotion& motion) noexcept {
  constexpr double huge_mu = 1e50;
  TangentialMotion m;
  m.dt_s = within(motion.dt_s, 1e-12, 1e12);
  m.normal_force_n = within(motion.normal_force_n, 0, huge);
  m.mu_dynamic = within(motion.mu_dynamic, 0, huge_mu);
  m.mu_static = within(motion.mu_static, m.mu_dynamic, huge_mu);
  m.velocity_m_per_s = within_huge(motion.velocity_m_per_s);
  m.step_m = within_huge(motion.step_m);
  m.from_centre_m = within_huge(motion.from_centre_m);
  m.inclination_rad = within(motion.inclination_rad, 0, 1.6);
  m.longitudinal = {within(motion.longitudinal.x(), -1, 1), within(motion.longitudinal.y(), -1, 1)};
  m.applied_force_n = within_huge(motion.applied_force_n);
  m.surface_stiffness_n_per_m = within(motion.surface_stiffness_n_per_m, 1 / huge, huge);
  return m;
}

/// The memory brought into range likewise; a contact that begins starts without any.
inline void bound(FrictionState& state) noexcept {
  if (state.phase == Phase::free) {
    state = FrictionState{};
    return;
  }
  state.slip_direction = {within(state.slip_direction.x(), -1, 1), within(state.slip_direction.y(), -1, 1)};
  state.deflection_m = within_huge(state.deflection_m);
  state.last_speed_m_per_s = within(state.last_speed_m_per_s, 0, huge);
  state.slip_force_scale = within(state.slip_force_scale, 0, huge);
}

}  // namespace fingerpad
