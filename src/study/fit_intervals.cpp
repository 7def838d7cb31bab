#include "study/fit_intervals.hpp"

#include "base/random_stream.hpp"

namespace fingerpad {
namespace {

constexpr int bootstrap_draws = 400;

/// Whether there are too few blocks for an interval, whatever they say.
std::optional<NoInterval> too_few_blocks(const PadValue& value, std::size_t subjects, Blocks blocks) {
  const bool are_subjects = blocks == Blocks::subjects;
  const auto blocks_here = are_subjects ? static_cast<double>(subjects) : static_cast<double>(value.trials);
  if (blocks_here - (are_subjects ? 1 : static_cast<double>(subjects)) >= least_freedom) return std::nullopt;
  if (value.trials < fewest_trials) return NoInterval::few_trials;
  return are_subjects ? NoInterval::few_subjects : NoInterval::few_a_subject;
}

}  // namespace

void add_intervals(const std::vector<int>& subject_of, const NumberReaches& by_delay,
                   const FitSettings& settings, FitPoint point, ProfileFit& fit) {
  const bool has_slow_slip = point.slow_slip.has_value();
  point.slow_slip.reset();  // whether it is told is settled for all draws
  std::array<DrawSpread, pad_number_keys.size()> spreads;
  RandomStream random(settings.seed);
  for (int draw = 0; draw < bootstrap_draws; ++draw) {
    const PadValues values =
        pad_numbers(fit.evidence, drawn_times(subject_of, settings.blocks, random), point);
    for (std::size_t k = 0; k < values.size(); ++k)
      if (values[k].refusal.empty()) spreads[k].add(values[k].value);
  }
  std::array<LeftOutSpread, pad_number_keys.size()> without;
  const std::size_t left_out = each_left_out(subject_of, settings.blocks, [&](const LeftOut& one) {
    const PadValues values = pad_numbers(fit.evidence, one.times, point);
    for (std::size_t k = 0; k < values.size(); ++k)
      if (values[k].refusal.empty()) without[k].add(one, values[k].value);
  });
  const auto subjects = static_cast<double>(fit.subjects);
  const auto unsure = moved_by_sampling(fit, by_delay, point, has_slow_slip);
  for (std::size_t k = 0; k < spreads.size(); ++k) {
    constexpr double most_missing = 0.05;
    if (!fit.values[k].refusal.empty()) continue;
    const auto too_few = too_few_blocks(fit.values[k], fit.subjects, settings.blocks);
    if (too_few) {
      fit.no_interval[k] = *too_few;
    } else {
      fit.no_interval[k] = spreads[k].count < (1 - most_missing) * bootstrap_draws ? NoInterval::draws_refused
                                                                                   : NoInterval::no_spread;
    }
    if (fit.no_interval[k] == NoInterval::draws_refused) continue;
    const double drawn = settings.blocks == Blocks::subjects
                             ? interval_reach(spreads[k], without[k].deviation(left_out), subjects, 1)
                             : interval_reach(spreads[k], without[k].deviation(left_out),
                                              static_cast<double>(fit.values[k].trials), subjects);
    const double reach = drawn + unsure[k];
    // Draws that all step in the same bin of speed are as sure as that bin is wide, if there are any to
    // differ.
    const bool is_step = !too_few && point.v_min_by_step && k == static_cast<std::size_t>(PadNumber::v_min);
    if (drawn > 0 || is_step) fit.interval[k] = {fit.values[k].value - reach, fit.values[k].value + reach};
  }
}

}  // namespace fingerpad
