#include "device/hand_finger.hpp"

#include "device/device_table.hpp"

namespace fingerpad {
namespace {

constexpr double landing_bandwidth_hz = 1.5;

}  // namespace

HandFinger::HandFinger(const DeviceSetup& setup, double dt_s)
    : settings_(setup.hand.value_or(HandSettings{})),
      hand_(settings_, dt_s),
      intended_(setup.start.p_WQ, pointer_bandwidth_hz),
      landing_(setup.start.p_WQ, landing_bandwidth_hz),
      dt_s_(dt_s),
      place_W_(setup.start.p_WQ),
      finger_(setup.start),
      seen_target_(setup.start) {
  hand_.start(setup.start.p_WQ);
}

void HandFinger::set_target(const FingerSample& target) {
  targets_.put(target);
}

FingerSample HandFinger::advance(double) noexcept {
  targets_.take(seen_target_);
  place_W_ = hand_.position_W();
  finger_.p_WQ = hand_.encoded_W();
  finger_.push_W_n = hand_.push_W_n(intended_.place_m());
  finger_.direction_W = seen_target_.direction_W;
  return finger_;
}

/// While it lands, the hand goes down more slowly than aside: a mass that comes down as fast as the mouse
/// clicks would meet the surface with more than it is to press with. So it does where it falls off a ledge.
Vec3 HandFinger::next_intended_W(const Vec3& wanted_W, const TickRecord& tick) noexcept {
  constexpr double most_landing_s = 0.6, near_share = 0.02, falls_s = 0.01;
  const double push_n = seen_target_.push_W_n.norm();
  const double near_m = near_share * push_n / settings_.stiffness_n_per_m;
  const auto left_m = [&](const Vec3& from_W) {
    return (wanted_W - from_W).dot(seen_target_.push_W_n) / push_n;
  };
  if (!(push_n > 0)) lands_ = true;
  free_s_ = tick.phase == Phase::free ? free_s_ + dt_s_ : 0;
  if (push_n > 0 && !lands_ && free_s_ > falls_s && left_m(intended_.place_m()) > near_m) {
    lands_ = true;
    landing_.put(intended_.place_m(), Vec3::Zero());
  }
  if (!(push_n > 0) || !lands_) {
    const Vec3 next_W = intended_.advance(wanted_W, dt_s_);
    landing_.put(next_W, intended_.velocity_m_per_s());
    landing_s_ = 0;
    return next_W;
  }
  const Vec3 down_W = seen_target_.push_W_n / push_n;
  const auto down_of_second = [&](const Vec3& aside, const Vec3& down) {
    return Vec3(aside + (down - aside).dot(down_W) * down_W);
  };
  const Vec3 aside_W = intended_.advance(wanted_W, dt_s_), lower_W = landing_.advance(wanted_W, dt_s_);
  const Vec3 next_W = down_of_second(aside_W, lower_W);
  const Vec3 velocity = down_of_second(intended_.velocity_m_per_s(), landing_.velocity_m_per_s());
  intended_.put(next_W, velocity);
  landing_.put(next_W, velocity);
  if (tick.phase != Phase::free) landing_s_ += dt_s_;
  lands_ = landing_s_ < most_landing_s && left_m(next_W) > near_m;
  return next_W;
}

/// The hand goes on under the force of this tick.
void HandFinger::feel(const TickRecord& tick) noexcept {
  const Vec3 intended_W = intended_.place_m();
  // A pointer that says what to press with is followed as deep as the hand's spring needs for that.
  const Vec3 wanted_W = seen_target_.p_WQ + seen_target_.push_W_n / settings_.stiffness_n_per_m;
  const Vec3 next_W = next_intended_W(wanted_W.allFinite() ? wanted_W : intended_W, tick);
  hand_.advance(intended_W, next_W, tick.force_W_n);
}

DeviceEntry hand_device() noexcept {
  return {.name = "hand",
          .doc = "a simulated hand (the scene's [hand]) that chases the mouse, in the window",
          .make = [](const DeviceSetup& setup) -> std::unique_ptr<LiveDevice> {
            return std::make_unique<HandFinger>(setup, 1 / setup.scene.motion.rate_hz);
          },
          .needs_window = true};
}

}  // namespace fingerpad
