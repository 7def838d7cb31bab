#pragma once

#include <vector>

#include "study/judged_runs.hpp"

namespace fingerpad {

/// What of a case the promise speaks of: of ticks those until which, since the finger was last free, the true
/// force has not been beyond the greatest, nor the finger so deep in a rounding that it slips round (what a
/// proxy has been pressed through stays with it); of ways those of such ticks alone.
struct Promised {
  std::vector<bool> ticks, ways;
};

Promised promised_of(const JudgedCase& one, const JudgedReference& reference);

/// How far a run is off what is true, of what the promise speaks of.
struct JudgedErrors {
  double share_99 = 0;  ///< of the larger of the true force and a tenth of the greatest; on 99 % of ticks no
                        ///< larger than this
  long ticks = 0;       ///< on which either is felt
  long pop_throughs = 0;  ///< on ways on which the force is anywhere off by half: else what was crossed
                          ///< unfelt is a facet that stands out over the surface
};

JudgedErrors judged_errors(const JudgedCase& one, const JudgedRun& run, const JudgedReference& reference,
                           const Promised& promised);

}  // namespace fingerpad
