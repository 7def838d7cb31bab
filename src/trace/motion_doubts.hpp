#pragma once

#include "trace/motion_reading.hpp"

namespace fingerpad {

// What is odd in a file that was read. Its clock is known.

/// Refuses a rate of its own that no ticks and no resampling go at.
void refuse_wild_rate(const MotionReading& reading, double least_hz);

/// Of a clock with steps of many lengths: said where it decides something.
void warn_of_odd_steps(MotionReading& reading);
/// Of a measured normal force that no finger rubs with.
void warn_of_odd_force(MotionReading& reading);
/// Of a measured force that drives the finger: the residual would be that of a wrong sign.
void warn_of_driving_force(MotionReading& reading);

}  // namespace fingerpad
