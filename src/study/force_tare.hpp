#pragma once

#include <vector>

#include "study/measurement.hpp"

namespace fingerpad {

/// When nothing touches a trial's sensor.
struct FreeMoments {
  std::vector<Eigen::Index> samples;  ///< in order; none where none is sure
  bool presses_on = false;            ///< none is, as the finger is on the plate even where it presses least
  bool falls_at_once = false;         ///< AirRuns'
};

/// Samples are without contact where the normal force is at its lowest for 50 ms and as still as its noise,
/// either hardly any lie between there and the press, or it is level for 75 ms and left in a corner, and
/// neither height nor friction tell that the finger presses on; or height tells that it is off the plate
/// (air_evidence.hpp).
FreeMoments moments_without_contact(const RecordedTrial& trial);

/// Takes off what the force sensor reads while nothing touches it: a straight line in time through the
/// samples without contact (a constant, where they do not span a third of the trial), on each axis,
/// and off its torques by the same samples. Where there are none the trial stays as it is, and
/// `free_samples` 0 says so.
void take_tare(RecordedTrial& trial, TrialCleaning& cleaning);

}  // namespace fingerpad
