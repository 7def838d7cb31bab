#pragma once

#include <optional>

#include "study/measurement_format.hpp"
#include "study/trial_rows.hpp"

namespace fingerpad {

/// Where the line of the force on the finger meets the plate, at the height that is tracked; the tracked
/// place where hardly anything presses.
Vec3 contact_point(const ContactSensor& sensor, const Vec3& normal_W, const Vec3& force_W,
                   const Vec3& torque_W_n_m, const Vec3& tracked_W);

/// Whether something else than the sensor saw the finger move along the plate: more than a tenth of the
/// samples lie farther from the trial's middle than noise puts them. Then that is where the finger is: a
/// contact point is where the skin holds on to the plate, and hardly moves in stick while the finger does.
bool is_tracked_along_plate(const RecordedTrial& trial);

/// Where the finger went: as it was tracked along the plate, or else the contact points.
const Points& finger_W(const RecordedTrial& trial);

/// Takes the tracked positions for the finger's and leaves the sensor's place out of the trial.
/// @returns  how far the contact points lie from them along the plate, RMS, where it presses with half of its
///           usual force or more [m]; none where it never presses
/// @pre      is_tracked_along_plate
std::optional<double> take_tracked_places(RecordedTrial& trial);

/// Tells a trial's contact points from its forces and torques as they are now. @pre it has a sensor
void take_contact_points(RecordedTrial& trial);

/// Turns a row's force, which is in the sensor's axes, into W; with a torque the row's position is where the
/// line of the force meets the plate.
/// @param torque_S_n_m  on the finger, about the sensor's origin, in its axes; nullptr: not recorded
void take_wrench(const SixAxisSensor& sensor, const Vec3* torque_S_n_m, RecordedRow& row);

}  // namespace fingerpad
