#pragma once

#include <string>
#include <vector>

#include "study/measurement_format.hpp"
#include "study/profile_fit.hpp"
#include "study/recorded_trial.hpp"

namespace fingerpad {

/// What a fit tells beside its numbers and fit_notes, a line each: on the terminal, and in its report.
struct FitTold {
  std::vector<std::string> reading;   ///< how files were read
  std::string understood;             ///< measurement_words
  std::vector<std::string> warnings;  ///< in order
};

/// Of the files, before they are made clean.
FitTold told_of_reading(const RecordedMeasurement& recorded, const MeasurementFormat& format);

/// Of trials and files that are left out.
std::vector<std::string> left_out_warnings(const Measurement& measurement);

/// Of the fit: that the law does not fit, and that no scene takes the profile.
std::vector<std::string> fit_warnings(const ProfileFit& fit);

}  // namespace fingerpad
