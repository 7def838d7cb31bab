#pragma once

#include "study/measurement_format.hpp"
#include "study/recorded_trial.hpp"

namespace fingerpad {

/// Asks where a measurement can hardly be what it was taken for: forces of more than 40 N or less than 10 mN,
/// ways of more than a metre, rates under 20 Hz or over 200 kHz, while their unit was not said; a plate that
/// pulls where it should press; friction that drives the finger. Throws Error (refused, the file) with what
/// to say, where most of a file's trials are so. Before they are made clean: then what looks odd is gone.
/// @param delay_s  of force behind position, where it is known: a force that comes late may seem to drive
void refuse_doubtful(const RecordedMeasurement& recorded, const MeasurementFormat& format, double delay_s);

}  // namespace fingerpad
