#include "study/few_trials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

#include "base/number_text.hpp"

namespace fingerpad {
namespace {

struct NoIntervalWords {
  NoInterval reason;
  std::string_view why, advice;
};
constexpr NoIntervalWords no_interval_table[] = {
    {NoInterval::few_trials, "too few trials for an interval", "record 3 or more"},
    {NoInterval::few_a_subject, "too few trials of each subject for an interval",
     "record several trials of each, or draw whole subjects with --blocks subjects"},
    {NoInterval::few_subjects, "too few subjects for an interval that draws whole subjects",
     "measure 3 or more, or draw trials with --blocks trials"},
    {NoInterval::draws_refused, "no interval, as many draws of the trials do not tell the number",
     "record more trials that tell it"},
    {NoInterval::no_spread, "no interval, as all draws of the trials say the same",
     "are there trials that differ?"},
};

const NoIntervalWords& words_of(NoInterval reason) {
  return *std::find_if(std::begin(no_interval_table), std::end(no_interval_table),
                       [&](const NoIntervalWords& words) { return words.reason == reason; });
}

bool has_interval(const ProfileFit& fit, PadNumber number) {
  return fit.interval[static_cast<std::size_t>(number)].has_value();
}

/// What to record so that a number of so many trials has an interval.
std::string more_trials_words(long trials) {
  return fmt::format("{} trial{} tell{} it, too few to say how far it may be off: record {} or more", trials,
                     trials == 1 ? "" : "s", trials == 1 ? "s" : "", fewest_trials);
}

/// Why what was found of a vibration is none; empty where it may be one.
std::string no_vibration_words(const ProfileFit& fit) {
  const auto k = static_cast<std::size_t>(PadNumber::vibration_bandwidth);
  const PadValue& bandwidth = fit.values[k];
  if (bandwidth.trials < fewest_trials) return more_trials_words(bandwidth.trials);
  if (!fit.interval[k] && fit.no_interval[k] == NoInterval::draws_refused)
    return "with other trials drawn of these no frequency stands out of the spectrum of slip: nothing is "
           "seen to "
           "vibrate for sure";
  if (!fit.interval[k] || fit.interval[k]->first > 0) return {};
  return fmt::format(
      "the peak of the spectrum of slip is {} Hz wide, give or take {}: nothing is seen to vibrate for sure",
      rounded_text(bandwidth.value, 2), rounded_text(fit.interval[k]->second - bandwidth.value, 2));
}

void refuse_number(PadNumber number, const std::string& words, ProfileFit& fit) {
  const auto k = static_cast<std::size_t>(number);
  fit.values[k].refuse(RefusalReason::vague, words);
  fit.interval[k].reset();
}

/// A finger's skin gives way by less than a centimetre: an axis of more is what one or two trials come to by
/// chance. What more trials come to is no chance (fit_notes asks for the unit).
void refuse_odd_axes(ProfileFit& fit) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const PadNumber number = spring_numbers[axis];
    const PadValue& value = value_of(fit.values, number);
    const bool is_odd = value.value > widest_axis_m || value.value < narrowest_axis_m;
    if (!value.refusal.empty() || has_interval(fit, number) || !is_odd || value.trials >= fewest_trials)
      continue;
    const std::string words =
        fmt::format("it would be {} mm, which is no finger's, and {}", rounded_text(1e3 * value.value, 2),
                    more_trials_words(value.trials));
    for (std::size_t n = axis; n < spring_numbers.size(); n += 2)
      refuse_number(spring_numbers[n], words, fit);
  }
}

/// What a number's reach is taken as a share of: where it may be 0, a bend of a half and a loop half as wide
/// as the axis is long.
double usual_size(const ProfileFit& fit, std::size_t number) {
  const auto key = static_cast<std::size_t>(spring_numbers[number]),
             axis = static_cast<std::size_t>(spring_numbers[number % 2]);
  switch (spring_numbers[number]) {
    case PadNumber::lateral_cubic_share:
    case PadNumber::longitudinal_cubic_share:
      return 0.5;
    case PadNumber::lateral_hysteresis_area:
    case PadNumber::longitudinal_hysteresis_area:
      return 2 * fit.values[axis].value * value_of(fit.values, PadNumber::mu_static).value;
    default:
      return std::abs(fit.values[key].value);
  }
}

std::string unsteady_words(long trials, double share) {
  return fmt::format(
      "{} trial{} tell{} it, and by chance within {} it may be off by {}: record {} or more, "
      "with more stick, or sample faster",
      trials, trials == 1 ? "" : "s", trials == 1 ? "s" : "", trials == 1 ? "it" : "them",
      share < 1 ? fmt::format("{:.0f} %", 100 * share) : "more than itself", fewest_trials);
}

}  // namespace

bool is_bare_spring(const ProfileFit& fit) {
  return std::any_of(spring_numbers.begin(), spring_numbers.end(), [&fit](PadNumber number) {
    return value_of(fit.values, number).refusal.empty() && !has_interval(fit, number);
  });
}

void refuse_unsteady_springs(const NumberReaches& reach, ProfileFit& fit) {
  constexpr double most_off = 0.2;
  for (std::size_t n = 0; n < spring_numbers.size(); ++n) {
    const PadValue& value = value_of(fit.values, spring_numbers[n]);
    if (!value.refusal.empty() || has_interval(fit, spring_numbers[n])) continue;
    const double share = reach[static_cast<std::size_t>(spring_numbers[n])] / usual_size(fit, n);
    if (share <= most_off) continue;
    const std::string words = unsteady_words(value.trials, share);
    const bool is_axis = n < 2;
    for (std::size_t of = n; of < spring_numbers.size(); of += 2)
      if (is_axis || of == n) refuse_number(spring_numbers[of], words, fit);
  }
}

void refuse_told_by_few(ProfileFit& fit) {
  const PadValue& v_min = value_of(fit.values, PadNumber::v_min);
  if (v_min.refusal.empty() && !has_interval(fit, PadNumber::v_min) && v_min.trials < fewest_trials)
    refuse_number(PadNumber::v_min,
                  fmt::format("{} in {} trial{} only, too few to say how far it may be off: record "
                              "until it does in {} or more",
                              fit.v_min_by_step ? "friction is seen to step as the finger slows"
                                                : "slip is seen to end",
                              v_min.trials, v_min.trials == 1 ? "" : "s", fewest_trials),
                  fit);
  if (const std::string words = no_vibration_words(fit); !words.empty()) {
    for (const PadNumber number : {PadNumber::vibration, PadNumber::vibration_bandwidth})
      refuse_number(number, words, fit);
  }
  refuse_odd_axes(fit);
}

void refuse_unsure_slip(ProfileFit& fit) {
  const auto k = static_cast<std::size_t>(PadNumber::mu_dynamic);
  if (!fit.values[k].refusal.empty() || fit.interval[k]) return;
  fit.values[k].refuse(RefusalReason::unseen_slip,
                       fmt::format("no slip is surely seen, and what passes for it and may be teeth tells no "
                                   "interval ({}): rub faster",
                                   no_interval_words(fit.no_interval[k])));
}

std::string no_interval_words(NoInterval why) {
  return std::string(words_of(why).why);
}

std::vector<std::string> without_interval_words(const ProfileFit& fit) {
  std::vector<std::string> told;
  for (const NoIntervalWords& words : no_interval_table) {
    std::string names;
    for (std::size_t k = 0; k < fit.values.size(); ++k) {
      if (!fit.values[k].refusal.empty() || fit.interval[k] || fit.no_interval[k] != words.reason) continue;
      names += fmt::format("{}{}", names.empty() ? "" : ", ", pad_number_keys[k]);
    }
    if (!names.empty())
      told.push_back(
          fmt::format("{}, so that these may be off by any amount ({}): {}", words.why, words.advice, names));
  }
  return told;
}

}  // namespace fingerpad
