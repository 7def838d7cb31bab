#pragma once

#include <string>
#include <vector>

#include "study/pad_numbers.hpp"

namespace fingerpad {

/// A trial whose number is far from those of its subject's other trials. It is listed, and counted all the
/// same.
struct OutlierTrial {
  std::size_t trial = 0;  ///< of Measurement::trials
  std::string name;
  PadNumber number = PadNumber::mu_static;
  double value = 0, usual = 0;  ///< its own, and the median of the subject's
};

/// Trials whose mu_static, mu_dynamic, v_min or stiffness (against the angle's usual) is off their subject's
/// median by more than a tenth (v_min a quarter) and five times the usual distance from it (median absolute
/// deviation, as a standard deviation). Subjects of fewer than five trials with the number are passed over.
std::vector<OutlierTrial> outlier_trials(const Measurement& measurement,
                                         const std::vector<TrialEvidence>& evidence);

}  // namespace fingerpad
