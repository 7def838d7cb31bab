#pragma once

#include <string>

#include "study/recorded_trial.hpp"

namespace fingerpad {

/// What a measurement was understood to hold, in SI, in a line: "6 trials of 2 subjects, 2.1 s each at 1000
/// Hz; positions reach over 57 x 57 x 3.5 mm, at up to 0.25 m/s; forces up to 1.5 N". Empty where it has no
/// trials.
std::string measurement_words(const RecordedMeasurement& recorded);

}  // namespace fingerpad
