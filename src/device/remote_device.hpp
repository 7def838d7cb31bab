#pragma once

#include <atomic>
#include <thread>

#include "device/device_clock.hpp"
#include "device/latest.hpp"
#include "device/live_device.hpp"
#include "device/remote_finger.hpp"
#include "device/wake_up.hpp"

namespace fingerpad {

/// A device with a place and motors outside of the program. A thread of the device's own speaks with it; the
/// servo only ever exchanges values with that thread. A device of this kind says in run() how it is spoken
/// with, calls start() at the end of its constructor and stop() in its destructor.
class RemoteDevice : public LiveDevice {
 public:
  FingerSample advance(double dt_s) noexcept final;
  void feel(const TickRecord& tick) noexcept final;
  bool has_motors() const noexcept final { return true; }
  Vec3 sent_W_n() const noexcept final { return finger_.sent_W_n(); }
  SampleParts gives() const noexcept final { return {.directions = true, .attitudes = true}; }
  void set_emergency_stop(bool on) noexcept final { finger_.guard().set_stopped(on); }
  bool emergency_stopped() const noexcept final { return finger_.guard().stopped(); }

 protected:
  /// Which ticks have an answer: the first after each reading, or all of them.
  enum class Answers { to_readings, every_tick };

  RemoteDevice(const DeviceSetup& setup, Answers answers, DeviceClock clock);

  void start();
  /// Ends the device's thread. A second call does nothing.
  void stop();
  /// On the device's thread: speaks with the device until is_stopping().
  virtual void run() = 0;

  // For the device's thread.
  bool is_stopping() const noexcept { return stopping_.load(std::memory_order_relaxed); }
  std::int64_t now_ns() const noexcept { return clock_(); }
  double watchdog_s() const noexcept { return watchdog_s_; }
  /// What lifts the finger, any thread.
  const TripWatch& trips() const noexcept { return finger_.trips(); }
  /// That silence has lifted the finger: now, a moment ago, or again and again. Any thread.
  /// @param what  that comes from the device: "packet on 127.0.0.1:47110"
  std::string silence_words(const std::string& what, bool is_silent) const;
  /// "; the emergency stop was on at the end"; empty where it was not.
  std::string stop_words() const;
  /// Woken by each tick that feels a reading for the first time.
  WakeUp& wake_up() noexcept { return wake_up_; }
  void hand_over(const DeviceReading& reading) noexcept { readings_.put(reading); }
  /// The servo's last answer; without force from the moment at which a stop was asked for.
  DeviceAnswer& newest_answer() noexcept;

 private:
  DeviceClock clock_;
  double watchdog_s_;
  Answers answers_wanted_;
  RemoteFinger finger_;  // servo's thread; its guard's stop: any
  WakeUp wake_up_;
  Latest<DeviceReading> readings_;  // to the servo
  Latest<DeviceAnswer> answers_;    // to the device's thread
  std::uint64_t answered_ = 0;      // servo's thread: readings that an answer was made for
  DeviceAnswer newest_;             // device's thread
  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

}  // namespace fingerpad
