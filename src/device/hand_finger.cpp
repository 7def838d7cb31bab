#include "device/hand_finger.hpp"

#include "device/device_table.hpp"

namespace fingerpad {
HandFinger::HandFinger(const DeviceSetup& setup, double dt_s)
    : settings_(setup.hand.value_or(HandSettings{})),
      hand_(settings_, dt_s),
      intended_(setup.start.p_WQ, pointer_bandwidth_hz),
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

/// The hand goes on under the force of this tick.
void HandFinger::feel(const TickRecord& tick) noexcept {
  const Vec3 intended_W = intended_.place_m();
  // A pointer that says what to press with is followed as deep as the hand's spring needs for that.
  const Vec3 wanted_W = seen_target_.p_WQ + seen_target_.push_W_n / settings_.stiffness_n_per_m;
  const Vec3 next_W = intended_.advance(wanted_W.allFinite() ? wanted_W : intended_W, dt_s_);
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
