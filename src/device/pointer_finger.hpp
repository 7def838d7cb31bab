#pragma once

#include <mutex>

#include "device/live_device.hpp"

namespace fingerpad {

/// A finger that follows a pointer (mouse or keyboard) the way a hand would: critically damped, so that the
/// few positions a second that a window gives become a smooth motion at the servo rate. Exact between ticks,
/// whatever the rate: x'' = w^2 (target - x) - 2 w x'.
class PointerFinger final : public LiveDevice {
 public:
  /// @param start        where the finger is, at rest
  /// @param bandwidth_hz w / 2 pi; about 8 Hz feels direct and hides a screen's 60 Hz steps
  PointerFinger(const FingerSample& start, double bandwidth_hz);

  /// Where the pointer is now. Any thread.
  void set_target(const FingerSample& target) override;
  /// The finger dt_s later. One thread (the servo's); keeps the last target while set_target holds the lock.
  FingerSample advance(double dt_s) override;

 private:
  double omega_;
  std::mutex mutex_;
  FingerSample target_;       // guarded by mutex_
  FingerSample seen_target_;  // the follower's own copy
  FingerSample finger_;
  Vec3 velocity_m_per_s_ = Vec3::Zero();
};

}  // namespace fingerpad
