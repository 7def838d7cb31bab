#pragma once

#include <atomic>

#include "base/types.hpp"
#include "scene/device_settings.hpp"

namespace fingerpad {

/// Stands between the model's force and a device's motors; always on. What it lets through
/// - is finite and never more than the force limit;
/// - differs from tick to tick by no more than the rate limit, but where it must be 0 at once: after a
///   release or an emergency stop;
/// - starts softly: whenever the finger has touched nothing, the limit begins at 0 and grows to the force
///   limit over the soft start. A tap at a usual speed stays below it and is felt as it is; a finger that
///   comes back deep inside a part is not thrown out.
class MotorGuard {
 public:
  /// What goes to the motors, in the device's axes.
  struct Sent {
    Vec3 force_D_n = Vec3::Zero();
    bool limited = false;  ///< it is not the force that was wanted
  };

  explicit MotorGuard(const DeviceSettings& settings) noexcept;

  /// The force for one tick. Servo thread; allocates nothing.
  /// @param wanted_D_n  any numbers
  /// @param touching    whether the finger touches; where it does not, nothing is wanted
  /// @param dt_s        tick, > 0
  Sent next(const Vec3& wanted_D_n, bool touching, double dt_s) noexcept;

  /// No force from now on until the next tick asks for one, and then softly. Servo thread.
  void release() noexcept;

  /// The emergency stop holds the force at 0 until it is taken back. Any thread.
  void set_stopped(bool on) noexcept { stopped_.store(on, std::memory_order_relaxed); }
  bool stopped() const noexcept { return stopped_.load(std::memory_order_relaxed); }

 private:
  double limit_n_, rate_limit_n_per_s_, soft_start_s_;
  double ceiling_n_ = 0;  ///< of the soft start
  Vec3 sent_D_n_ = Vec3::Zero();
  std::atomic<bool> stopped_{false};
};

}  // namespace fingerpad
