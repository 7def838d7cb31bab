#include "study/fit_refusals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/number_text.hpp"
#include "study/file_delays.hpp"
#include "study/static_friction.hpp"

namespace fingerpad {

void refuse_springs(RefusalReason reason, const std::string& words, PadValues& values) {
  for (const PadNumber number : spring_numbers) value_of(values, number).refuse(reason, words);
}

namespace {

/// What a number is as a finger has it, where it may be 0.
double usual_size(PadNumber number) {
  if (number == PadNumber::mu_load_exponent) return 1.0 / 3;
  return number == PadNumber::lateral_cubic_share || number == PadNumber::longitudinal_cubic_share ? 0.5 : 0;
}

}  // namespace

void refuse_by_delay(const NumberReaches& moved, ProfileFit& fit) {
  constexpr double most_moved = 0.2, without_interval = 0.05;
  for (std::size_t k = 0; k < moved.size(); ++k) {
    const double size = std::max(std::abs(fit.values[k].value), usual_size(static_cast<PadNumber>(k))),
                 share = moved[k] / size;
    if (!fit.values[k].refusal.empty() || !(share > (fit.interval[k] ? most_moved : without_interval)))
      continue;
    fit.values[k].refuse(
        RefusalReason::unknown_delay,
        fmt::format("it rests on the delay of force behind position, which is not told: one of {} ms, as "
                    "sensors' filters have it, would move it by {:.0f} %: give --delay 7ms, or record more "
                    "that tells it",
                    rounded_text(1e3 * usual_delay_s, 3), std::min(999.0, 100 * share)));
    fit.interval[k].reset();
  }
}

void refuse_law_lost_by_delay(const DelayReach& reach, ProfileFit& fit) {
  for (const PadNumber number : {PadNumber::normal_stiffness, PadNumber::normal_exponent}) {
    const auto k = static_cast<std::size_t>(number);
    const bool is_drawn = fit.interval[k] || fit.no_interval[k] != NoInterval::draws_refused;
    if (!fit.values[k].refusal.empty() || (is_drawn && !reach.is_lost[k])) continue;
    fit.values[k].refuse(
        RefusalReason::unknown_delay,
        fmt::format(
            "it rests on the delay of force behind position, which is not told, and {} the finger's "
            "height does not follow the normal force: give --delay 7ms, or press and lift more slowly",
            is_drawn ? fmt::format("with one of {} ms more or less, as sensors' filters have it,",
                                   rounded_text(1e3 * usual_delay_s, 3))
                     : "in many draws of the trials"));
    fit.interval[k].reset();
  }
}

void tell_teeth(double reach, ProfileFit& fit) {
  constexpr double hardly = 0.05;
  const auto k = static_cast<std::size_t>(PadNumber::mu_dynamic);
  const double value = fit.values[k].value;
  if (!fit.values[k].refusal.empty() || !(reach > hardly * value)) return;
  fit.doubts.push_back(fmt::format(
      "mu_dynamic: what passes for slip may hold teeth of stick and slip that are too short or drop "
      "too little to be seen, which its interval allows {} for either way: rub faster, or sample "
      "faster",
      rounded_text(reach, 2)));
}

void doubt_misfit(LawResidual& residual) {
  constexpr double surely_left = 0.15;  // which no delay alone leaves
  if (residual.misfit.empty() || residual.share > surely_left || 2 * residual.drops < residual.gives) return;
  residual.untold = residual.misfit +
                    ": the delay of force behind position, which is not told and so was left in, may be why: "
                    "give --delay 7ms";
  residual.misfit.clear();
}

std::string odd_spring_words(const ProfileFit& fit, PadNumber axis) {
  constexpr std::size_t most = 3;
  const PadNumber stiffness =
      axis == PadNumber::lateral_axis ? PadNumber::stick_stiffness : PadNumber::longitudinal_stiffness;
  std::string words;
  std::size_t named = 0;
  for (const OutlierTrial& one : fit.outliers) {
    if (one.number != stiffness || !one.is_counted || ++named > most) continue;
    words +=
        fmt::format("{}{} is unlike the others: its {} is {}, the usual one {}", words.empty() ? "" : ", ",
                    one.name, pad_number_keys[static_cast<std::size_t>(stiffness)],
                    rounded_text(one.value, 4), rounded_text(one.usual, 4));
  }
  return words;
}

void refuse_vague_springs(bool keeps_told_by_few, ProfileFit& fit) {
  constexpr double vaguest = 0.5, hardly = 0.05;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    // A number of the other axis stands beside each.
    const auto k = static_cast<std::size_t>(spring_numbers[axis]);
    const double value = fit.values[k].value;
    if (!fit.values[k].refusal.empty() || !fit.interval[k]) continue;
    const double reach = fit.interval[k]->second - value;
    const long slip = value_of(fit.values, PadNumber::mu_dynamic).samples;
    if (!(reach > vaguest * value)) continue;
    const bool hardly_sticks =
        static_cast<double>(fit.values[k].samples) <= hardly * static_cast<double>(slip);
    if (keeps_told_by_few && !hardly_sticks) continue;
    const std::string odd = odd_spring_words(fit, spring_numbers[axis]),
                      words =
                          fmt::format("{} along this axis tells it to -+ {:.0f} % only{}{}",
                                      hardly_sticks ? "the finger hardly sticks: what is seen of its stick"
                                                    : "the trials are too few or too unlike: their stick",
                                      100 * reach / value, odd.empty() ? "" : "; ", odd);
    for (std::size_t n = axis; n < spring_numbers.size(); n += 2) {
      const auto other = static_cast<std::size_t>(spring_numbers[n]);
      fit.values[other].refuse(RefusalReason::vague, words);
      fit.interval[other].reset();
    }
  }
}

void refuse_odd_cubic_shares(ProfileFit& fit) {
  for (const PadNumber number : {PadNumber::lateral_cubic_share, PadNumber::longitudinal_cubic_share}) {
    const auto k = static_cast<std::size_t>(number);
    PadValue& share = fit.values[k];
    constexpr double as_straight = 0.02;
    if (share.refusal.empty() && share.value < 0 && share.value > -as_straight && fit.interval[k])
      fit.interval[k]->second = std::max(fit.interval[k]->second, 0.0);
    const auto [least, most] = fit.interval[k].value_or(std::pair(share.value, share.value));
    if (!share.refusal.empty() || (most >= -as_straight && least <= 1)) continue;
    share.refuse(RefusalReason::other,
                 fmt::format("the measurement gives a {} of {}; the finger-pad law's spring takes 0 to 1",
                             pad_number_keys[k], rounded_text(share.value, 4)));
    fit.interval[k].reset();
  }
}

void doubt_straight_springs(ProfileFit& fit) {
  const PadValue& mu_static = value_of(fit.values, PadNumber::mu_static);
  if (mu_static.refusal.empty() || mu_static.reason == RefusalReason::unknown_zero) return;
  std::string names;
  for (const PadNumber number : {PadNumber::lateral_axis, PadNumber::longitudinal_axis,
                                 PadNumber::stick_stiffness, PadNumber::longitudinal_stiffness}) {
    const auto k = static_cast<std::size_t>(number);
    if (fit.values[k].refusal.empty())
      names += fmt::format("{}{}", names.empty() ? "" : ", ", pad_number_keys[k]);
  }
  if (names.empty()) return;
  fit.doubts.push_back(fmt::format(
      "straight springs: where stick ends is not known, as mu_static is not, and so whether the spring bends "
      "on the way: with a cubic share of 0.3 axes are some 30 % shorter and stiffnesses 43 % higher than {}",
      names));
}

void tell_unlike_friction(const std::vector<std::string>& names, const FitPoint& point, ProfileFit& fit) {
  constexpr double unlike = 1.1, surely_unlike = 1.5;
  PadValue &mu_static = value_of(fit.values, PadNumber::mu_static),
           &mu_dynamic = value_of(fit.values, PadNumber::mu_dynamic);
  const bool is_refused = mu_static.reason == RefusalReason::contradiction,
             is_paired = point.pairs_friction && mu_static.refusal.empty();
  const std::string words =
      unlike_trials_words(names, fit.evidence, is_refused || is_paired ? unlike : surely_unlike);
  if (is_refused) {
    for (PadValue* one : {&mu_static, &mu_dynamic})
      one->refusal = fmt::format(
          "the measurement gives a mu_static of {} and a mu_dynamic of {}, and no pad slips with more than "
          "it sticks with: {}",
          rounded_text(mu_static.value, 3), rounded_text(mu_dynamic.value, 3),
          words.empty()
              ? fmt::format(
                    "ruptures are counted of {} of {} trials, and of others than those that slip with "
                    "more friction: rub these slower, or leave them out (--leave-out)",
                    mu_static.trials, fit.evidence.size())
              : "its trials are " + words);
    return;
  }
  if (!words.empty())
    fit.doubts.push_back(
        "the trials are " + words +
        "; mu_static and mu_dynamic are means of them, and axes and stiffnesses may be farther "
        "off than their intervals reach");
  if (!is_paired) return;
  const std::vector<int> once(fit.evidence.size(), 1);
  fit.doubts.push_back(fmt::format(
      "mu_static: the trials whose ruptures are counted slip otherwise than all do, so that it is told "
      "against each trial's own slip; without that it would be {}",
      rounded_text(static_friction(fit.evidence, once, false).value, 3)));
}

void tell_noise(const std::vector<StickSegments>& segments, ProfileFit& fit) {
  const auto noisy = std::count_if(segments.begin(), segments.end(),
                                   [](const StickSegments& trial) { return trial.is_too_noisy; });
  if (noisy == 0) return;
  for (const PadNumber number : {PadNumber::mu_static, PadNumber::mu_dynamic}) {
    std::string& refusal = value_of(fit.values, number).refusal;
    if (!refusal.empty())
      refusal += fmt::format(
          "; in {} of {} trials the forces' noise is so large for their load that ruptures cannot be seen in "
          "it",
          noisy, segments.size());
  }
}

}  // namespace fingerpad
