#pragma once

#include "friction/law.hpp"
#include "friction/plane_vector.hpp"

namespace fingerpad {

/// Far beyond anything physical, and small enough that no product within a law overflows.
inline constexpr double huge = 1e100;

/// x within [low, high]; `low` for NaN.
inline double within(double x, double low, double high) noexcept {
  if (x >= low && x <= high) [[likely]]
    return x;
  return x > high ? high : low;
}

[[gnu::noinline, gnu::cold]] inline PlaneVector each_within_huge(const PlaneVector& v) noexcept {
  return {within(v.x(), -huge, huge), within(v.y(), -huge, huge)};
}

inline PlaneVector within_huge(const PlaneVector& v) noexcept {
  // A sum of squares below the square of the bound holds both parts within it; a length needs it anyway.
  if (v.square() < huge * huge) [[likely]]
    return v;
  return each_within_huge(v);
}

/// The tick's input, every number brought into a range in which each law stays finite, and mu_s >= mu_d;
/// physical input is read unchanged. Every law reads through it, and so pays for what it reads only.
class BoundedMotion {
 public:
  explicit BoundedMotion(const TangentialMotion& motion) noexcept : m_(motion) {}

  double dt_s() const noexcept { return within(m_.dt_s, 1e-12, 1e12); }
  double normal_force_n() const noexcept { return within(m_.normal_force_n, 0, huge); }
  double mu_dynamic() const noexcept { return within(m_.mu_dynamic, 0, huge_mu); }
  double mu_static() const noexcept { return within(m_.mu_static, mu_dynamic(), huge_mu); }
  PlaneVector velocity_m_per_s() const noexcept { return within_huge(m_.velocity_m_per_s); }
  PlaneVector step_m() const noexcept { return within_huge(m_.step_m); }
  double inclination_rad() const noexcept { return within(m_.inclination_rad, 0, 1.6); }
  PlaneVector longitudinal() const noexcept {
    return {within(m_.longitudinal.x(), -1, 1), within(m_.longitudinal.y(), -1, 1)};
  }
  PlaneVector applied_force_n() const noexcept { return within_huge(m_.applied_force_n); }
  double surface_stiffness_n_per_m() const noexcept {
    return within(m_.surface_stiffness_n_per_m, 1 / huge, huge);
  }

 private:
  static constexpr double huge_mu = 1e50;
  const TangentialMotion& m_;
};

/// A law's memory, read likewise.
class BoundedState {
 public:
  explicit BoundedState(const FrictionState& state) noexcept : state_(state) {}

  PlaneVector slip_direction() const noexcept {
    return {within(state_.slip_direction.x(), -1, 1), within(state_.slip_direction.y(), -1, 1)};
  }
  PlaneVector stretch_m() const noexcept { return within_huge(state_.stretch_m); }
  PlaneVector last_step_m() const noexcept { return within_huge(state_.last_step_m); }
  double event_share() const noexcept { return within(state_.event_share, 0, 1); }
  double softening() const noexcept { return within(state_.softening, 1e-3, 1); }
  PlaneVector last_velocity_m_per_s() const noexcept { return within_huge(state_.last_velocity_m_per_s); }
  double slip_force_scale() const noexcept { return within(state_.slip_force_scale, 0, huge); }

 private:
  const FrictionState& state_;
};

}  // namespace fingerpad
