#pragma once

#include "motion/finger_path.hpp"

namespace fingerpad {

/// What moves the finger live.
class LiveDevice {
 public:
  virtual ~LiveDevice() = default;

  /// The finger dt_s later. One thread, the servo's: allocates nothing, waits for nothing.
  virtual FingerSample advance(double dt_s) = 0;

  /// Where the window's pointer would have the finger. Any thread. A device with a place of its own does not
  /// listen.
  virtual void set_target(const FingerSample& /*target*/) {}
};

}  // namespace fingerpad
