#pragma once

#include <cstdint>

#include "device/motor_guard.hpp"
#include "device/trip_watch.hpp"
#include "device/workspace.hpp"
#include "touch/tick_record.hpp"

namespace fingerpad {

/// What a device said of itself, as its own thread hands it to the servo.
struct DeviceReading {
  DevicePlace place;
  std::int64_t arrived_ns = 0;  ///< of the program's clock
  std::uint32_t sequence = 0;   ///< as the device counts
  std::uint64_t accepted = 0;   ///< how many readings there were with this one
};

/// What a tick has for a device.
struct DeviceAnswer {
  Vec3 force_D_n = Vec3::Zero();     ///< on the finger, within the limits
  Vec3 torque_D_n_m = Vec3::Zero();  ///< of friction about the finger's centre
  double depth_m = 0;                ///< as the device measures
  Phase phase = Phase::free;
  bool limited = false;           ///< the force is not the model's
  bool watchdog_tripped = false;  ///< since the last answer
  bool stopped = false;           ///< by the emergency stop
  std::int64_t made_ns = 0;       ///< of the program's clock
  std::uint32_t sequence = 0;     ///< of the last reading
  std::uint64_t accepted = 0;     ///< how many readings there were until then
};

/// The servo's side of a device that has a place and motors: where the finger is, and what the motors get.
/// A device that has been silent for watchdog_s, by the clock, lifts the finger: it rests above what can be
/// touched, without force, until the device speaks again. One thread; allocates nothing.
class RemoteFinger {
 public:
  /// @param rest  the finger while the device is silent
  RemoteFinger(const DeviceSettings& settings, const FingerSample& rest) noexcept;

  /// What the device has said since the last tick, the last of it.
  void hear(const DeviceReading& reading) noexcept;
  /// The finger dt_s later.
  FingerSample advance(std::int64_t now_ns, double dt_s) noexcept;
  /// What the tick at that finger gives the device. An answer that nobody gets is told so: what has happened
  /// since the last one is then kept for the next.
  DeviceAnswer feel(const TickRecord& tick, std::int64_t now_ns, bool is_sent) noexcept;

  MotorGuard& guard() noexcept { return guard_; }
  const MotorGuard& guard() const noexcept { return guard_; }
  bool lifted() const noexcept { return lifted_; }
  /// How often silence has lifted the finger.
  const TripWatch& trips() const noexcept { return trips_; }
  /// How many readings the device has given until the one that was heard last.
  std::uint64_t heard() const noexcept { return last_.accepted; }
  /// What the guard let through at the last tick, in the world's axes.
  const Vec3& sent_W_n() const noexcept { return sent_W_n_; }

 private:
  Vec3 torque_D_n_m(const TickRecord& tick, const Vec3& wanted_D_n, const Vec3& sent_D_n) const noexcept;

  MotorGuard guard_;
  Workspace workspace_;
  FingerSample rest_;
  double watchdog_s_, dt_s_ = 1;
  DeviceReading last_;
  std::int64_t felt_ns_ = 0;
  bool lifted_ = true, tripped_ = false;
  TripWatch trips_;
  Vec3 sent_W_n_ = Vec3::Zero();
};

}  // namespace fingerpad
