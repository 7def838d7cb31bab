#pragma once

#include <optional>
#include <string>

#include "device/live_device.hpp"

namespace fingerpad {

/// Waits for the end of a touch without a window: for so many seconds, without end where none are given,
/// until SIGINT or SIGTERM comes, or until the device's motion is over. A second signal ends the program at
/// once. Where there is a terminal, `x` there is the emergency stop of a device with motors, and `q` ends.
/// @param name  of the device, for messages
void run_headless(std::optional<double> seconds, const std::string& name, LiveDevice& device);

}  // namespace fingerpad
