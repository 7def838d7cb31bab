#include "motion/simulated_hand.hpp"

#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>

namespace fingerpad {

SimulatedHand::SimulatedHand(const HandSettings& settings, double dt_s)
    : settings_(settings),
      dt_s_(dt_s),
      on_the_way_(static_cast<std::size_t>(settings.delay_ticks) + 1, Vec3::Zero()) {
  tick_flow_ = flow_over(dt_s);
}

SimulatedHand::Flow SimulatedHand::flow_over(double t_s) const noexcept {
  Flow rates = Flow::Zero();
  rates(0, 1) = 1;
  rates(1, 0) = -settings_.stiffness_n_per_m / settings_.mass_kg;
  rates(1, 1) = -settings_.damping_n_s_per_m / settings_.mass_kg;
  rates(1, 2) = 1;
  rates(2, 3) = 1;
  const Flow over_t = rates * t_s;
  return over_t.exp();
}

void SimulatedHand::start(const Vec3& p_W) {
  position_W_ = p_W;
  velocity_W_.setZero();
  for (Vec3& force : on_the_way_) force.setZero();
}

Vec3 SimulatedHand::encoded_W() const noexcept {
  const double quantum = settings_.encoder_m;
  if (!(quantum > 0)) return position_W_;
  const Vec3 steps = position_W_ / quantum;
  // So small a quantum is none: a double has no room for it.
  constexpr double countable = 0x1p52;
  if (!(steps.cwiseAbs().maxCoeff() < countable)) return position_W_;
  return steps.array().round().matrix() * quantum;
}

Vec3 SimulatedHand::push_W_n(const Vec3& intended_W) const noexcept {
  return settings_.stiffness_n_per_m * (intended_W - position_W_) - settings_.damping_n_s_per_m * velocity_W_;
}

Vec3 SimulatedHand::against_dry_friction_W_n(const Vec3& push_W_n) const noexcept {
  Vec3 against_W_n = Vec3::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    const double goes = velocity_W_[axis] != 0 ? velocity_W_[axis] : push_W_n[axis];
    if (goes != 0) against_W_n[axis] = std::copysign(settings_.coulomb_n, goes);
  }
  return against_W_n;
}

SimulatedHand::AxisState SimulatedHand::with_dry_friction(AxisState state) const noexcept {
  const double friction = settings_.coulomb_n / settings_.mass_kg;  // as an acceleration
  const double spring = settings_.stiffness_n_per_m / settings_.mass_kg;
  double left_s = dt_s_;
  // A tick is short against the hand's own motion: a few changes of sign are all it can hold.
  for (int piece = 0; piece < 8 && left_s > 0; ++piece) {
    const double push = state[2] - spring * state[0];
    if (state[1] == 0 && std::abs(push) <= friction) {
      // Stuck until the push, linear in time, leaves the band of dry friction.
      const double room = state[3] > 0 ? friction - push : friction + push;
      const double stuck_s = state[3] != 0 ? std::min(left_s, room / std::abs(state[3])) : left_s;
      state[2] += state[3] * stuck_s;
      left_s -= stuck_s;
      if (left_s <= 0 || stuck_s > 0) continue;
    }
    const double sign =
        state[1] != 0 ? std::copysign(1.0, state[1]) : std::copysign(1.0, push != 0 ? push : state[3]);
    AxisState slowed = state;
    slowed[2] -= sign * friction;
    double passed_s = left_s;
    AxisState after = flow_over(passed_s) * slowed;
    if (sign * after[1] < 0) {
      double early = 0;
      for (int i = 0; i < 52; ++i) {
        const double middle = 0.5 * (early + passed_s);
        (sign * (flow_over(middle) * slowed)[1] < 0 ? passed_s : early) = middle;
      }
      after = flow_over(passed_s) * slowed;
      after[1] = 0;
    }
    state << after[0], after[1], after[2] + sign * friction, state[3];
    left_s -= passed_s;
  }
  return state;
}

void SimulatedHand::advance(const Vec3& intended_W, const Vec3& next_intended_W,
                            const Vec3& force_W_n) noexcept {
  newest_ = (newest_ + 1) % on_the_way_.size();
  on_the_way_[newest_] = force_W_n;
  const Vec3& displayed = on_the_way_[(newest_ + 1) % on_the_way_.size()];  // the oldest
  const double spring = settings_.stiffness_n_per_m / settings_.mass_kg;
  for (int axis = 0; axis < 3; ++axis) {
    if (!settings_.free_axis[axis]) {
      velocity_W_[axis] = (next_intended_W[axis] - position_W_[axis]) / dt_s_;
      position_W_[axis] = next_intended_W[axis];
      continue;
    }
    AxisState state(position_W_[axis], velocity_W_[axis],
                    spring * intended_W[axis] + displayed[axis] / settings_.mass_kg,
                    spring * (next_intended_W[axis] - intended_W[axis]) / dt_s_);
    state = settings_.coulomb_n > 0 ? with_dry_friction(state) : AxisState(tick_flow_ * state);
    position_W_[axis] = state[0];
    velocity_W_[axis] = state[1];
  }
}

}  // namespace fingerpad
