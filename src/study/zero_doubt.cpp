#include "study/zero_doubt.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/number_text.hpp"

namespace fingerpad {
namespace {

constexpr double steepest_exponent = -1.0 / 3;  // a finger's friction over its load
constexpr double most_moved = 0.2, told_share = 0.02;

/// What a number is if coefficients are so many times what they are told to be.
struct RestsOnZero {
  PadNumber number;
  double (*with)(double told, double times, const ProfileFit& fit);
  double beyond = 0;  ///< by what share of that it may move further
};

double as_coefficient(double told, double times, const ProfileFit& /*fit*/) {
  return told * times;
}

/// 1/w of depth ~ n^w, told of n + o: w - 1 is told as many times too large as the load is.
double as_normal_exponent(double told, double times, const ProfileFit& /*fit*/) {
  return 1 / (1 + (1 / told - 1) / times);
}

/// Of two laws that have one slope and one bend at the usual load, N of n + o: at 1 N they differ by as many
/// times as (N/times)^(w-1) / N^(w'-1).
double as_normal_stiffness(double told, double times, const ProfileFit& fit) {
  const double told_exponent = value_of(fit.values, PadNumber::normal_exponent).value,
               exponent = as_normal_exponent(told_exponent, times, fit);
  return told * std::pow(times, 1 - 1 / exponent) * std::pow(fit.mu_load_n, 1 / exponent - 1 / told_exponent);
}

constexpr double wide_loads = 0.2;  // what these two miss of loads that change by two thirds either way

constexpr RestsOnZero rest_on_zero[] = {
    {PadNumber::mu_static, as_coefficient},
    {PadNumber::mu_dynamic, as_coefficient},
    {PadNumber::stick_stiffness, as_coefficient},
    {PadNumber::longitudinal_stiffness, as_coefficient},
    {PadNumber::lateral_hysteresis_area, as_coefficient},
    {PadNumber::longitudinal_hysteresis_area, as_coefficient},
    {PadNumber::normal_stiffness, as_normal_stiffness, wide_loads},
    {PadNumber::normal_exponent, as_normal_exponent, wide_loads},
};

constexpr const char* remedy =
    "record a second without contact in each trial, or zero the sensor and say --no-tare";

/// How friction that changes with the load may be shared by an offset.
void take_load(const PadValue& exponent, const std::pair<double, double>& interval, ZeroDoubt& doubt) {
  constexpr double least = 0.05, hardly = 0.1;
  doubt.is_likely = std::abs(exponent.value) > hardly;
  doubt.is_seen = doubt.is_likely && (interval.first > 0 || interval.second < 0);
  const double low = std::max(least, 1 + interval.first), high = std::max(least, 1 + interval.second);
  doubt.least = std::min(1.0, low);
  doubt.most = std::max(1.0, doubt.is_seen ? high / (1 + steepest_exponent) : high);
  doubt.words = fmt::format(
      "friction that changes with the load (here by an exponent of {}) and a force sensor's offset along the "
      "normal look alike",
      rounded_text(exponent.value, 2));
}

/// What an offset of so many newtons along the normal does, either way of it.
/// @param load_n  as it is told, with the offset in it
void take_offset(double offset_n, double load_n, ZeroDoubt& doubt) {
  constexpr double most_share = 0.9;
  const double share = std::min(most_share, offset_n / load_n);
  doubt.least = 1 / (1 + share);
  doubt.most = 1 / (1 - share);
}

/// With an offset o along the plate ruptures seem to need up to F (1 + (o/F)^2) of a friction F: across the
/// way sqrt(F^2 + o^2) does half of that, and along it as much comes of pushes that give way one way alone.
/// Axes, where the spring yields to F, are told as many times too long; (o/F)^2 counts as often as trials
/// have no tare.
void doubt_axes(double untared_share, ProfileFit& fit) {
  const PadValue& mu_static = value_of(fit.values, PadNumber::mu_static);
  const bool is_seen = mu_static.refusal.empty() || mu_static.reason == RefusalReason::unknown_zero;
  if (fit.offset.off == 0 || !is_seen || !(mu_static.value > 0)) return;
  std::string widened;
  const double offset_share = fit.offset.typical_n / (mu_static.value * fit.mu_load_n),
               times = 1 + untared_share * offset_share * offset_share;
  for (const PadNumber number : {PadNumber::lateral_axis, PadNumber::longitudinal_axis}) {
    const auto k = static_cast<std::size_t>(number);
    PadValue& axis = fit.values[k];
    const double below = axis.value / times;
    if (!axis.refusal.empty()) continue;
    if (below < (1 - most_moved) * axis.value) {
      axis.refuse(RefusalReason::unknown_zero,
                  fmt::format("the force is off by {} N along the plate, which makes ruptures seem to need "
                              "more: it may be {} to {} ({})",
                              rounded_text(fit.offset.typical_n, 2), rounded_text(below, 3),
                              rounded_text(axis.value, 3), remedy));
      fit.interval[k].reset();
    } else if (fit.interval[k]) {
      if (below < (1 - told_share) * axis.value)
        widened += fmt::format("{}{}", widened.empty() ? "" : ", ", pad_number_keys[k]);
      fit.interval[k]->first -= axis.value - below;
    }
  }
  if (!widened.empty())
    fit.doubts.push_back(
        fmt::format("force's zero: the force is off by {} N along the plate, which makes ruptures seem to "
                    "need more: the intervals of {} allow for it ({})",
                    rounded_text(fit.offset.typical_n, 2), widened, remedy));
}

}  // namespace

ZeroDoubt zero_doubt(const ProfileFit& fit, bool knows_zero) {
  constexpr double untold_exponent = 0.1;  // that one without an interval is given to be off
  // Along the plate an offset shows in strokes to and fro; along the normal, under one load, in nothing.
  constexpr double along_normal = 3, usual_n = 0.2;
  ZeroDoubt doubt;
  if (knows_zero || fit.offset.untared == 0 || fit.trials == 0 || !(fit.mu_load_n > 0)) return doubt;
  doubt.untared_share = static_cast<double>(fit.offset.untared) / static_cast<double>(fit.trials);
  const auto k = static_cast<std::size_t>(PadNumber::mu_load_exponent);
  const PadValue& exponent = fit.values[k];
  if (exponent.refusal.empty()) {
    take_load(exponent,
              fit.interval[k].value_or(
                  std::pair(exponent.value - untold_exponent, exponent.value + untold_exponent)),
              doubt);
  } else if (fit.offset.off > 0) {
    doubt.is_likely = doubt.is_seen = true;
    take_offset(std::max(along_normal * fit.offset.typical_n, usual_n), fit.mu_load_n, doubt);
    doubt.words = fmt::format(
        "the force is off by {} N along the plate, and by what along the normal nothing tells (nor how "
        "friction changes with the load)",
        rounded_text(fit.offset.typical_n, 2));
  } else {
    take_offset(usual_n, fit.mu_load_n, doubt);
    doubt.words = "what the force is off by where nothing presses is not told";
  }
  doubt.least = 1 + doubt.untared_share * (doubt.least - 1);
  doubt.most = 1 + doubt.untared_share * (doubt.most - 1);
  return doubt;
}

void doubt_zero(const ZeroDoubt& doubt, ProfileFit& fit) {
  if (doubt.words.empty()) return;
  const ProfileFit told = fit;
  std::string widened;
  for (const RestsOnZero& rests : rest_on_zero) {
    const auto k = static_cast<std::size_t>(rests.number);
    const double value = told.values[k].value;
    if (!told.values[k].refusal.empty()) continue;
    const auto with = [&](double times) {
      return value + (1 + rests.beyond) * (rests.with(value, times, told) - value);
    };
    const double one = with(doubt.least), other = with(doubt.most);
    const double below = std::min({one, other, value}), above = std::max({one, other, value});
    const bool is_bare = !fit.interval[k];
    const bool speaks = doubt.is_seen || (is_bare && (doubt.is_likely || rests.beyond > 0));
    if (speaks && above - below > most_moved * std::abs(value)) {
      fit.values[k].refuse(
          RefusalReason::unknown_zero,
          fmt::format(
              "no moment in the air tells the force's zero in {} of {} trials, and {}: it may be {} to "
              "{} ({})",
              fit.offset.untared, fit.trials, doubt.words, rounded_text(below, 3), rounded_text(above, 3),
              remedy));
      fit.interval[k].reset();
    } else if (fit.interval[k]) {
      if (above - below > told_share * std::abs(value))
        widened += fmt::format("{}{}", widened.empty() ? "" : ", ", pad_number_keys[k]);
      fit.interval[k]->first -= value - below;
      fit.interval[k]->second += above - value;
    }
  }
  if (!widened.empty())
    fit.doubts.push_back(
        fmt::format("force's zero: no moment in the air tells it in {} of {} trials, and {}: the intervals "
                    "of {} allow for it ({})",
                    fit.offset.untared, fit.trials, doubt.words, widened, remedy));
  doubt_axes(doubt.untared_share, fit);
  const auto k = static_cast<std::size_t>(PadNumber::mu_load_exponent);
  if (!fit.values[k].refusal.empty()) return;
  if (!doubt.is_seen) {
    if (fit.interval[k])
      fit.interval[k] = {std::min(fit.interval[k]->first, 0.0), std::max(fit.interval[k]->second, 0.0)};
    return;
  }
  fit.values[k].refuse(
      RefusalReason::unknown_zero,
      fmt::format("no moment in the air tells the force's zero in {} of {} trials, and {} ({})",
                  fit.offset.untared, fit.trials, doubt.words, remedy));
  fit.interval[k].reset();
}

}  // namespace fingerpad
