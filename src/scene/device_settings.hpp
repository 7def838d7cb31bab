#pragma once

#include "base/types.hpp"

namespace fingerpad {

/// How a live device's own space lies in the world, and what its motors may do; keys of [device].
struct DeviceSettings {
  Mat3 rotation = Mat3::Identity();  ///< R_WD, device axes to world axes
  double scale = 1;                  ///< metres in the world for a metre of the device
  Vec3 offset_m = Vec3::Zero();      ///< p_WD, where the device's origin lies
  double force_scale = 1;            ///< newtons of the device for a newton of the world
  double force_limit_n = 5;          ///< of the device, at any time
  double force_rate_limit_n_per_s = 2000;
  double watchdog_s = 0.02;    ///< silence of the device that lifts the finger
  double soft_start_s = 0.05;  ///< after a loss of contact the limit grows from 0 over this; 0: at once

  bool operator==(const DeviceSettings&) const = default;
};

}  // namespace fingerpad
