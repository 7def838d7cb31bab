#pragma once

#include <optional>
#include <vector>

#include "study/pad_numbers.hpp"

namespace fingerpad {

/// The exponent of mu(n) = mu (n/load)^exponent in slip: the mean of the subjects' own.
///
/// A trial's ratios follow the load within the trial, and its own coefficient, which differs from that of
/// another trial (moisture, place), stands in its mean alone. So each subject's exponent is the least squares
/// one of a law with a random factor a trial: what a trial's ratio does about its mean counts in full, and
/// the trials' means by 1/(1 + scatter N), N being a trial's samples. Did they count in full, the
/// scatter of some trials would pass for an effect of their loads.
/// @param about    the exponent that the trials' ratios were taken to the load by
/// @param scatter  trial_scatter
PadValue mu_load_exponent(const std::vector<TrialEvidence>& trials, const std::vector<int>& times,
                          double about, double scatter);

/// Variance of the trials' own factors over that of what one sample of slip adds to a trial's exponent, both
/// told by the trials: the first from how the means lie about each subject's line, the second from how the
/// trials' own exponents differ. 0 where the trials are too few to tell.
double trial_scatter(const std::vector<TrialEvidence>& trials);

/// Mean of ln(n/1 N) in slip, each subject weighing the same; nothing without slip.
std::optional<double> mean_log_load(const std::vector<TrialEvidence>& trials);

}  // namespace fingerpad
