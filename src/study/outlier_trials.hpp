#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/pad_numbers.hpp"

namespace fingerpad {

/// A trial whose number is far from those of its subject's other trials. It is listed.
struct OutlierTrial {
  std::size_t trial = 0;  ///< its place among those that were judged
  std::string name;
  PadNumber number = PadNumber::mu_static;
  /// Its own, and the median of the subject's, both at the trial's load; stiffnesses along the plate at the
  /// fit's, where their axes go with the load (axes_exponent).
  double value = 0, usual = 0;
  bool is_counted = true;  ///< else the fit leaves it out of that number: its spring pushes on
};

/// Trials whose mu_static, mu_dynamic, v_min or stiffness, along the plate or into it (against the angle's
/// usual), is off their subject's median by more than a tenth (v_min a quarter) and five times the usual
/// distance from it (median absolute deviation, as a standard deviation). Of three or four alike that one is
/// taken that Dixon's test parts from the others; of fewer none.
///
/// How a pad's numbers go with the load is not known beforehand: trials are compared at one load, by the
/// exponents that the subject's other trials leave likely (exponents_beside), and one is named that is off to
/// one side by all of these.
/// @param names           of the trials of the evidence
/// @param press_exponent  that their presses' sums were taken about; nothing where no normal law is told
std::vector<OutlierTrial> outlier_trials(const std::vector<std::string>& names,
                                         const std::vector<TrialEvidence>& evidence,
                                         const std::optional<double>& press_exponent);

}  // namespace fingerpad
