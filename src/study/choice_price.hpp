#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/force_comparison.hpp"
#include "study/rate_figures.hpp"

namespace fingerpad {

/// One choice, held against the model: what it costs and what it loses.
struct ChoicePrice {
  TouchChoice choice;
  ForceFigures figures;
  RateFigures rate;
  double tick_ns = 0;   ///< mean time of a tick on this machine, without the slowest in a thousand; the best
                        ///< of a few passes where there are few ticks
  long late_ticks = 0;  ///< that took longer than the rate leaves them
  std::vector<std::string> broken;  ///< promises, in words; none: it keeps them all

  bool keeps() const noexcept { return broken.empty(); }
  /// Processor time per time touched, as a share of one core.
  double load() const noexcept { return 1e-9 * tick_ns * choice.rate_hz; }
};

/// Mean of the times of ticks [ns], without the slowest in a thousand: those are the machine's.
double mean_tick_ns(std::vector<float> tick_ns);

/// What broken_promises says, and whether the rate shows friction's teeth (touch/rate_choice.hpp), measured
/// on the model.
std::vector<std::string> broken_promises(const ForceFigures& figures, const RateFigures& rate,
                                         const Promises& promises);

/// The cheapest choice that keeps all promises: of those whose load is within a tenth of the least, which no
/// measurement of times tells apart, the one of the least error. Where none keeps them, the one that breaks
/// the fewest, and of these the one of the least error.
const ChoicePrice& cheapest(const std::vector<ChoicePrice>& prices);

/// The dearest of those that are cheaper than `chosen` by more than a tenth; null: there is none.
const ChoicePrice* next_cheaper(const std::vector<ChoicePrice>& prices, const ChoicePrice& chosen);

}  // namespace fingerpad
