#pragma once

#include "study/measurement_format.hpp"
#include "study/trial_rows.hpp"

namespace fingerpad {

/// Turns a row's force, which is in the sensor's axes, into W; with a torque the row's position is where the
/// line of the force meets the plate.
/// @param torque_S_n_m  on the finger, about the sensor's origin, in its axes; nullptr: not recorded
void take_wrench(const SixAxisSensor& sensor, const Vec3* torque_S_n_m, RecordedRow& row);

}  // namespace fingerpad
