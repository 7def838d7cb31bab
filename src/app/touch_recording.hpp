#pragma once

#include <memory>
#include <string>

#include "device/live_device.hpp"
#include "touch/touch_swap.hpp"
#include "touch/world.hpp"
#include "trace/live_recorder.hpp"

namespace fingerpad {

/// Throws Error (usage) where a touch cannot be recorded there. Asked before the touch, which could not be
/// made again.
/// @param force  an older file of that name may be written over
void refuse_unrecordable(const std::string& path, const Scene& scene, bool force);

/// Starts the trace of a touch; null where no path is given. What goes wrong with it while the touch goes on
/// is told at once.
std::unique_ptr<LiveRecorder> start_recording(const std::string& path, const Scene& scene, const World& world,
                                              const LiveDevice& device, TouchSwap& swap);

/// A tick as its trace keeps it: with what the sample said beyond the finger's place, and with what a
/// device's motors got of the force.
TickRecord as_recorded(TickRecord tick, const FingerSample& sample, const LiveDevice& device) noexcept;

}  // namespace fingerpad
