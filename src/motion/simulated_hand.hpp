#pragma once

#include <vector>

#include "base/types.hpp"
#include "motion/hand_settings.hpp"

namespace fingerpad {

/// A hand that closes the loop: mass, damping and a spring towards the intended motion, pushed by the
/// displayed force.
///
///   m x'' + b x' + k (x - x_intended(t)) = F_held - f_c sign(x')
///
/// integrated exactly between ticks (matrix exponential; F held, x_intended linear), dry friction included:
/// the moments at which a velocity passes zero are found, not stepped over.
class SimulatedHand {
 public:
  SimulatedHand(const HandSettings& settings, double dt_s);

  /// At rest at `p_W`, no force on the way.
  void start(const Vec3& p_W);
  /// Where the finger is [m].
  const Vec3& position_W() const noexcept { return position_W_; }
  const Vec3& velocity_W() const noexcept { return velocity_W_; }
  /// Where the device's encoders say it is [m].
  Vec3 encoded_W() const noexcept;
  /// What the hand pushes with now, spring and damper [N].
  Vec3 push_W_n(const Vec3& intended_W) const noexcept;
  /// What has to be added to a push so that it moves the hand as it would without dry friction [N].
  Vec3 against_dry_friction_W_n(const Vec3& push_W_n) const noexcept;

  /// One tick on: `force_W_n` is what was computed at this tick, on the finger; what is displayed is the one
  /// computed delay_ticks earlier. Along axes that are not free the finger goes to `next_intended_W`.
  void advance(const Vec3& intended_W, const Vec3& next_intended_W, const Vec3& force_W_n) noexcept;

 private:
  using Flow = Eigen::Matrix4d;
  /// One axis with its drive: position, velocity, (k x_intended + F)/m and that one's slope in time.
  using AxisState = Eigen::Vector4d;

  Flow flow_over(double t_s) const noexcept;
  AxisState with_dry_friction(AxisState state) const noexcept;

  HandSettings settings_;
  double dt_s_;
  Flow tick_flow_;
  Vec3 position_W_ = Vec3::Zero();
  Vec3 velocity_W_ = Vec3::Zero();
  std::vector<Vec3> on_the_way_;  // ring of delay_ticks + 1 forces
  std::size_t newest_ = 0;
};

}  // namespace fingerpad
