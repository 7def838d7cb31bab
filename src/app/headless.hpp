#pragma once

#include <optional>
#include <string>

#include "app/stop_signals.hpp"
#include "device/live_device.hpp"

namespace fingerpad {

/// Waits for the end of a touch without a window: for so many seconds, without end where none are given,
/// until a signal asks to stop, or until the device's motion is over. Where there is a terminal, `x` there is
/// the emergency stop of a device with motors, `g` gives the force back, and `q` ends.
/// Tells the device's trouble, and the emergency stop, also where the device itself asked for it.
/// @param name  of the device, for messages
void run_headless(std::optional<double> seconds, const std::string& name, LiveDevice& device,
                  const StopSignals& signals);

}  // namespace fingerpad
