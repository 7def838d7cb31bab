#pragma once

#include <string>
#include <vector>

#include "study/profile_fit.hpp"
#include "study/report.hpp"

namespace fingerpad {

/// What a pad's law leaves of the tangential force of one trial that its fit has not seen.
struct HeldOutTrial {
  std::string name;
  int subject = 0;
  long samples = 0;
  double measured_rms_n = 0;      ///< of the tangential force itself
  double built_in_rms_n = 0;      ///< left by the built-in pad
  double own_friction_rms_n = 0;  ///< left by the built-in pad with the fit's coefficients of friction
  double fitted_rms_n = 0;        ///< left by the pad fitted to the other trials
};

/// How well a fit foretells trials that it has not seen.
struct CrossValidation {
  std::vector<HeldOutTrial> trials;
  /// Over all trials, each subject with the same weight [N].
  double measured_rms_n = 0, built_in_rms_n = 0, own_friction_rms_n = 0, fitted_rms_n = 0;
  long not_foretold = 0;  ///< trials left out, because the others' fit gives no pad that can be run
  std::string refusal;    ///< why there is none; empty where there is
};

/// Parts the trials into up to four folds, so that each subject's trials are spread over them; fits the pad
/// to all folds but one, and runs it and the built-in pad along the trials of that one (pad_force_n). Both
/// are told the same positions, velocities and normal forces.
CrossValidation cross_validate(const Measurement& measurement, const FitSettings& settings);

/// A row a trial.
StudyTable cross_validation_table(const CrossValidation& checked);

/// "on trials that a fit has not seen the fitted pad leaves ...", for people.
std::string cross_validation_words(const CrossValidation& checked);

}  // namespace fingerpad
