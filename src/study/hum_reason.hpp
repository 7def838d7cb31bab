#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "study/hum_evidence.hpp"
#include "study/mains_hum.hpp"

namespace fingerpad {

/// A line of one of the trials.
struct TrialLine {
  std::size_t trial = 0;
  HumLine line;
  HumEvidence evidence;
};

/// What a line is taken for, and why.
enum class HumReason { open, hum, not_while_still, not_steady, beside_air, in_position };

/// Tells hum from what stands there of teeth or of a finger that vibrates.
/// @param found    one of `lines`
/// @param lines    near one frequency of the mains
/// @param showing  how many of the trials can show such a line
HumReason reason_of(const TrialLine& found, const std::vector<TrialLine>& lines,
                    const std::vector<RecordedTrial>& trials, std::size_t showing);

/// Why a line is left in.
std::string reason_words(HumReason reason, double nominal_hz);

}  // namespace fingerpad
