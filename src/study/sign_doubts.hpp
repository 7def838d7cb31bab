#pragma once

#include "study/file_trials.hpp"
#include "study/measurement_format.hpp"

namespace fingerpad {

/// Asks where most of a file's trials have a plate that pulls where it should press, or friction that drives
/// the finger. Throws Error (refused, the file) with what to say.
/// @param delay_s  of force behind position, where it is known: a force that comes late may seem to drive
void ask_for_signs(FileTrials trials, const MeasurementFormat& format, double delay_s);

}  // namespace fingerpad
