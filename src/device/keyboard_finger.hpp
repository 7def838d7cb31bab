#pragma once

#include <atomic>

#include "device/follower.hpp"
#include "device/latest.hpp"
#include "device/live_device.hpp"
#include "device/terminal_keys.hpp"

namespace fingerpad {

/// A finger moved by keys alone, those of the terminal that the program was started in, with a window or
/// without: the arrow keys along x and y, the page keys along z, by a step a key; `+` and `-` double and
/// halve the step, `q` ends the touch. [device] turns and scales these axes.
class KeyboardFinger final : public LiveDevice {
 public:
  /// Throws Error (usage) where standard input is no terminal.
  explicit KeyboardFinger(const DeviceSetup& setup);

  FingerSample advance(double dt_s) noexcept override;
  bool has_ended() const noexcept override { return ended_.load(std::memory_order_relaxed); }
  std::string opening_words() const override;

 private:
  void take(std::string_view key);

  Mat3 axes_W_;  ///< columns: where a metre of right, up and page up leads
  FingerSample finger_;
  Follower follower_;
  Vec3 target_W_;        // keys' thread
  double step_m_;        // keys' thread
  Latest<Vec3> wanted_;  // to the servo
  Vec3 seen_target_W_;   // servo thread
  std::atomic<bool> ended_{false};
  TerminalKeys keys_;  // last: its thread ends first
};

}  // namespace fingerpad
