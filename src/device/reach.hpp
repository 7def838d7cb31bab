#pragma once

namespace fingerpad {

/// No device is farther from its origin than this along any axis, and none leads the finger farther [m].
inline constexpr double device_reach_m = 1e3;

}  // namespace fingerpad
