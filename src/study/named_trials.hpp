#pragma once

#include <string>
#include <vector>

#include "study/measurement_format.hpp"
#include "study/recorded_trial.hpp"

namespace fingerpad {

/// How the command line names a trial: as messages do, "FILE, subject 1, trial 3", or by some of that, as
/// "trial 3" and "subject 1, trial 3", which then stands for all trials of which it holds. This is its
/// shortest such name that says its subject and trial and is no other's.
std::string option_name(const RecordedTrial& trial, const std::vector<RecordedTrial>& all);

/// Leaves out the trials that are named. Throws Error (usage) where a name is no trial's, or none is left.
/// @returns what was left out, a line; empty where nothing was named
std::string leave_out_trials(const std::vector<std::string>& named, RecordedMeasurement& recorded);

/// Takes forces or positions of single trials to be in another unit than their file's.
/// @param said    "NAME=UNIT": "trial 3=mN"
/// @param format  that they were read in, by the program's own readers
/// @returns what was taken so, a line each. Throws Error (usage) for what names no trial or no unit, for two
/// units of one trial, and for one of a six-axis sensor.
std::vector<std::string> take_trial_units(const std::vector<std::string>& said,
                                          const MeasurementFormat& format, RecordedMeasurement& recorded);

}  // namespace fingerpad
