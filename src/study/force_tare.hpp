#pragma once

#include "study/measurement.hpp"

namespace fingerpad {

/// The samples at which nothing touches the sensor for sure, as take_tare finds them, in order; none where it
/// finds none.
std::vector<Eigen::Index> samples_without_contact(const RecordedTrial& trial);

/// Takes off what the force sensor reads while nothing touches it: a straight line in time through the
/// samples without contact (a constant, where they do not span a third of the trial), on each axis,
/// and off its torques by the same samples.
///
/// Samples are without contact where the normal force is at its lowest for 50 ms and as still as its noise,
/// and either hardly any lie between there and the press, or it is level for 75 ms and left in a corner: a
/// finger that only presses less does not count. Where there are none the trial stays as it is, and
/// `free_samples` 0 says so.
void take_tare(RecordedTrial& trial, TrialCleaning& cleaning);

}  // namespace fingerpad
