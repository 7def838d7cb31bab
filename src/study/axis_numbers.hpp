#pragma once

#include <array>
#include <vector>

#include "study/pad_numbers.hpp"

namespace fingerpad {

/// Adds the numbers of both axes' springs, which end at the mu_static that `found` holds, or where that is
/// refused at a profile's default. Without any trial's direction stick_stiffness is that over all pushed
/// directions.
/// @param bend  that the springs' sums were taken about
void add_axes(const std::vector<TrialEvidence>& trials, const std::vector<int>& times,
              const std::array<SpringBend, 2>& bend, PadValues& found);

/// The springs that were found, for the next pass. The law's cubic shares begin at 0.
void take_bends(const PadValues& found, EvidencePoint& next);

}  // namespace fingerpad
