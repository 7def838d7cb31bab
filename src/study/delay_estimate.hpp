#pragma once

#include <cstdint>
#include <vector>

#include "study/position_delay.hpp"

namespace fingerpad {

/// What an estimate rests on: a block is what is drawn as one, a trial or a part of one.
struct DelayBlocks {
  bool are_parts = false;  ///< of trials that are too few
  std::vector<DelaySums> sums;
  std::vector<int> trial;  ///< of each; those of one trial stand together, and have one spring
  /// What is drawn is drawn within each: subjects, of whole trials; of parts, trials.
  std::vector<int> group;

  /// @param of_trial  a trial's sums, or those of its parts
  void add(std::vector<DelaySums> of_trial);
  /// Whether there are enough to tell how far an estimate may be off.
  bool tell_spread() const;
};

/// The lag of the highest cross-correlation: the one at which a spring, of first, third or fifth order and of
/// its own for each trial and axis, explains most (without the higher orders its bend would pass for a
/// delay), refined by the parabola through the highest three. Within 50 ms either way. A spring that yields
/// late (hysteresis) looks like a delay: what they share is taken for delay.
DelayEstimate estimate_delay(const DelayBlocks& blocks, std::uint64_t seed);

}  // namespace fingerpad
