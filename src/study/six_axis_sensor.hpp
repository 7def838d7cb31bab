#pragma once

#include "study/measurement_format.hpp"
#include "study/trial_rows.hpp"

namespace fingerpad {

/// Where the line of the force on the finger meets the plate, at the height that is tracked; the tracked
/// place where hardly anything presses.
Vec3 contact_point(const ContactSensor& sensor, const Vec3& normal_W, const Vec3& force_W,
                   const Vec3& torque_W_n_m, const Vec3& tracked_W);

/// Tells a trial's contact points from its forces and torques as they are now. @pre it has a sensor
void take_contact_points(RecordedTrial& trial);

/// Turns a row's force, which is in the sensor's axes, into W; with a torque the row's position is where the
/// line of the force meets the plate.
/// @param torque_S_n_m  on the finger, about the sensor's origin, in its axes; nullptr: not recorded
void take_wrench(const SixAxisSensor& sensor, const Vec3* torque_S_n_m, RecordedRow& row);

}  // namespace fingerpad
