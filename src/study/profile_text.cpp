#include "study/profile_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "base/number_text.hpp"
#include "base/printable_text.hpp"
#include "scene/toml_tree.hpp"
#include "study/few_trials.hpp"
#include "study/fit_refusals.hpp"

namespace fingerpad {
namespace {

std::string decimal_text(double number) {
  const std::string text = number_text(number);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

/// The values that stand above all tables.
std::string numbers_text(const ProfileFit& fit) {
  std::string text;
  for (std::size_t k = 0; k < pad_number_keys.size(); ++k) {
    if (fit.values[k].refusal.empty())
      text += fmt::format("{} = {}\n", pad_number_keys[k], decimal_text(fit.values[k].value));
  }
  if (fit.mu_load_n > 0)
    text += fmt::format("mu_load_n = {}  # at which mu_static and mu_dynamic hold\n",
                        decimal_text(fit.mu_load_n));
  return text;
}

/// What is to be measured so that the axis is told.
std::string axis_mend(const ProfileFit& fit, PadNumber axis) {
  const RefusalReason reason = value_of(fit.values, axis).reason;
  if (reason == RefusalReason::no_friction) return "measure the force along the plate too, as fx_n and fy_n";
  const bool has_direction = std::any_of(fit.evidence.begin(), fit.evidence.end(),
                                         [](const TrialEvidence& trial) { return trial.has_direction; });
  if (!has_direction) return "give the finger's direction in the columns dx, dy, dz";
  if (reason == RefusalReason::vague)
    return fmt::format("{}add trials whose finger sticks before it slips {} the finger, pushed alike",
                       odd_spring_words(fit, axis).empty()
                           ? ""
                           : "leave the trial out that is unlike the others (--leave-out), "
                             "if it is another finger's or went wrong, or ",
                       axis == PadNumber::lateral_axis ? "across" : "along");
  if (reason == RefusalReason::unknown_delay) return "give the delay of force behind position (--delay)";
  if (reason == RefusalReason::unseen_slip) return "rub faster";
  if (reason == RefusalReason::hidden_stick) return "sample faster";
  if (reason == RefusalReason::one_angle)
    return "add a trial with the finger at about 45 degrees to the plate, or at two angles";
  // A rub goes some way: where no stick was seen along either axis, another way to rub is no help.
  if (value_of(fit.values, PadNumber::lateral_slope).samples == 0 &&
      value_of(fit.values, PadNumber::longitudinal_slope).samples == 0)
    return "let the finger be seen to stick before it slips: press harder, start and reverse slower, and "
           "measure forces with less noise";
  return axis == PadNumber::lateral_axis ? "add a trial that rubs across the finger"
                                         : "add a trial that rubs along the finger";
}

struct UsedElsewhere {
  PadNumber number;
  std::string_view where;
};
/// Numbers that a scene takes without a profile.
constexpr UsedElsewhere used_elsewhere[] = {
    {PadNumber::mu_static, "mu_static of a part or plane"},
    {PadNumber::mu_dynamic, "mu_dynamic of a part or plane"},
    {PadNumber::stick_stiffness, "stick_stiffness_per_m of [friction]"},
    {PadNumber::v_min, "v_min_m_per_s of [friction]"},
    {PadNumber::vibration, "vibration.frequency_hz of [friction]"},
};

}  // namespace

std::string missing_axes_words(const ProfileFit& fit) {
  std::string missing, mend;
  for (const PadNumber axis : {PadNumber::lateral_axis, PadNumber::longitudinal_axis}) {
    const PadValue& value = value_of(fit.values, axis);
    if (value.refusal.empty()) continue;
    missing += fmt::format("{}{} ({})", missing.empty() ? "" : " and ",
                           pad_number_keys[static_cast<std::size_t>(axis)], value.refusal);
    const std::string step = axis_mend(fit, axis);
    if (mend.find(step) == std::string::npos) mend += (mend.empty() ? "" : ", and ") + step;
  }
  if (missing.empty()) return {};
  std::string usable;
  for (const UsedElsewhere& use : used_elsewhere) {
    const PadValue& value = value_of(fit.values, use.number);
    if (value.refusal.empty())
      usable +=
          fmt::format("{}{} as {}", usable.empty() ? "" : ", ", rounded_text(value.value, 4), use.where);
  }
  return fmt::format("no scene takes this profile: it lacks {}. To have it, {}.{}", missing, mend,
                     usable.empty() ? "" : fmt::format(" What a scene can use of it: {}", usable));
}

std::vector<std::string> outlier_notes(const ProfileFit& fit) {
  std::vector<std::string> notes;
  for (const OutlierTrial& outlier : fit.outliers)
    notes.push_back(
        fmt::format("outlier: {}: its {} is {}, the usual one {}; {}", outlier.name,
                    pad_number_keys[static_cast<std::size_t>(outlier.number)], rounded_text(outlier.value, 4),
                    rounded_text(outlier.usual, 4),
                    outlier.is_counted
                        ? "counted all the same"
                        : "left out of that number, as its force drives the finger where it should hold it "
                          "back: is its sign right?"));
  return notes;
}

std::vector<std::string> fit_notes(const ProfileFit& fit) {
  std::vector<std::string> notes = fit.steps;
  for (std::vector<std::string> (*more)(const ProfileFit&) : {outlier_notes, fit_remarks}) {
    const std::vector<std::string> own = more(fit);
    notes.insert(notes.end(), own.begin(), own.end());
  }
  return notes;
}

std::vector<std::string> fit_remarks(const ProfileFit& fit) {
  std::vector<std::string> notes;
  if (fit.offset.off > 0)
    notes.push_back(fmt::format(
        "force's zero: no tare was taken off {} trials, and of {} that rub to and fro {} have an offset, of "
        "{} N on the median and at most {} N along the plate (or friction that differs by direction): "
        "coefficients and springs rest on it, and what it is along the normal is not told. Record a second "
        "without contact in each trial{}, or zero the sensor",
        fit.offset.untared, fit.offset.told, fit.offset.off, rounded_text(fit.offset.usual_n, 2),
        rounded_text(fit.offset.most_n, 2), fit.looks_for_tare ? "" : " and do without --no-tare"));
  for (const PadNumber axis : {PadNumber::lateral_axis, PadNumber::longitudinal_axis}) {
    const auto k = static_cast<std::size_t>(axis);
    if (fit.values[k].refusal.empty() && fit.values[k].value > widest_axis_m)
      notes.push_back(fmt::format(
          "{} is {} mm, further than the skin of a finger gives way: is the positions' unit right?",
          pad_number_keys[k], rounded_text(1e3 * fit.values[k].value, 3)));
  }
  if (fit.tells_delay_left && fit.residual.misfit.empty())
    notes.push_back(fmt::format(
        "delay: {}the springs tell {} {} ms{}, which bent springs (or a loop) hide from the "
        "cross-correlation: it may be off by as much; axes and stiffnesses allow for it",
        fit.took_delay ? "" : "none was taken out, and ", fit.took_delay ? "another" : "one of",
        rounded_text(1e3 * fit.delay_left_s, 2), fit.took_delay ? " beside what was taken out" : ""));
  const PadValue &lateral = value_of(fit.values, PadNumber::lateral_axis),
                 &longitudinal = value_of(fit.values, PadNumber::longitudinal_axis);
  if (lateral.refusal.empty() && longitudinal.refusal.empty() &&
      std::max(lateral.value, longitudinal.value) < narrowest_axis_m)
    notes.push_back(
        fmt::format("the axes are {} and {} mm, stiffer than the skin of a finger: is the "
                    "positions' unit right?",
                    rounded_text(1e3 * lateral.value, 3), rounded_text(1e3 * longitudinal.value, 3)));
  notes.insert(notes.end(), fit.doubts.begin(), fit.doubts.end());
  for (const std::string& words : without_interval_words(fit)) notes.push_back(words);
  const LawResidual& residual = fit.residual;
  if (residual.samples == 0 && residual.untold.empty()) return notes;
  if (!residual.untold.empty()) {
    notes.push_back("whether the pad's law fits cannot be told: " + residual.untold);
    return notes;
  }
  for (const std::string& odd : residual.odd_trials)
    notes.push_back("the pad's law fits most trials, but not " + odd + "; it counts all the same");
  if (!residual.misfit.empty()) {
    if (fit.took_delay)
      notes.push_back(
          "delay: it was told by the springs of the pad's law, which does not fit: it may be 10 ms off, and "
          "the "
          "normal law with it; give it (--delay 7ms) where it is known");
    notes.push_back("the pad's law does not fit: " + residual.misfit);
  } else {
    notes.push_back(
        fmt::format("the pad's law fits: it leaves {:.1f} % of the friction in stick and about its ends "
                    "(RMS), {} explain {:.1f} %",
                    100 * residual.share,
                    fit.offset.off > 0 ? "noise, vibration and the force's offset" : "noise and vibration",
                    100 * residual.expected));
  }
  return notes;
}

std::string profile_text(const ProfileFit& fit, const std::string& source) {
  std::string intervals, samples, refusals, notes;
  for (std::size_t k = 0; k < pad_number_keys.size(); ++k) {
    const PadValue& value = fit.values[k];
    const std::string_view key = pad_number_keys[k];
    if (!value.refusal.empty()) {
      refusals += fmt::format("{} = {}\n", key, write_toml_value(toml_text(value.refusal)));
      continue;
    }
    samples += fmt::format("{} = {}\n", key, value.samples);
    if (const auto& both = fit.interval[k])
      intervals += fmt::format("{} = [{}, {}]\n", key, decimal_text(both->first), decimal_text(both->second));
  }
  for (const std::string& note : fit_notes(fit)) notes += fmt::format("# {}\n", printable(note, 1000));
  if (const std::string missing = missing_axes_words(fit); !missing.empty())
    notes += fmt::format("# {}\n", printable(missing, 1000));
  return fmt::format(
      "{}{}source = {}\n\n[interval]  # 95 %, over the trials of these subjects\n{}"
      "\n[samples]  # of stick, slip or contact; of mu_static ruptures, of v_min ends of slip, of vibrations "
      "windows\n{}\n[refused]\n{}",
      notes, numbers_text(fit), write_toml_value(toml_text(source)), intervals, samples, refusals);
}

}  // namespace fingerpad
