#pragma once

#include <string>
#include <vector>

#include "study/measurement_format.hpp"
#include "study/recorded_trial.hpp"

namespace fingerpad {

/// Asks where a measurement can hardly be what it was taken for: forces of more than 40 N or less than 10 mN,
/// ways of more than a metre, torques of forces over a metre from their sensor, rates under 20 Hz or over 200
/// kHz, while their unit was not said; a plate that pulls where it should press; friction that drives the
/// finger. Throws Error (refused, the file) with what to say, where most of a file's trials are so. Before
/// they are made clean: then what looks odd is gone.
/// @param delay_s  of force behind position, where it is known: a force that comes late may seem to drive
void refuse_doubtful(const RecordedMeasurement& recorded, const MeasurementFormat& format, double delay_s);

/// What of a measurement is not a finger's although its unit was said, or hardly is: a line a doubt, "FILE:
/// ...". Rates under 20 Hz or over 100 kHz, positions that reach over less than half a millimetre or more
/// than half a metre, over 1.5 m/s, forces of over 100 N and presses beyond those of refuse_doubtful.
/// What that refuses is not told here. And single trials that are not as the others (odd_trial_doubts).
std::vector<std::string> doubts_of(const RecordedMeasurement& recorded, const MeasurementFormat& format);

}  // namespace fingerpad
