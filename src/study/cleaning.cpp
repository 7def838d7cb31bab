#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>
#include <string_view>

#include "motion/low_pass.hpp"
#include "study/cleaning_words.hpp"
#include "study/file_delays.hpp"
#include "study/force_tare.hpp"
#include "study/hum_verdict.hpp"
#include "study/measurement.hpp"
#include "study/pad_axes.hpp"
#include "study/position_delay.hpp"
#include "study/six_axis_sensor.hpp"

namespace fingerpad {
namespace {

/// Samples of gaps that are too long to be filled become missing.
void limit_fills(RecordedTrial& trial, double longest_s, TrialCleaning& cleaning) {
  const auto longest = static_cast<std::size_t>(longest_s * trial.rate_hz + 1e-6);
  for (std::size_t from = 0, to = 0; from < trial.origin.size(); from = to) {
    to = from + 1;
    if (trial.origin[from] == SampleOrigin::missing) ++cleaning.missing;
    if (trial.origin[from] != SampleOrigin::filled) continue;
    while (to < trial.origin.size() && trial.origin[to] == SampleOrigin::filled) ++to;
    const bool is_short = to - from <= longest;
    (is_short ? cleaning.filled : cleaning.missing) += static_cast<long>(to - from);
    if (is_short) continue;
    for (std::size_t i = from; i < to; ++i) trial.origin[i] = SampleOrigin::missing;
  }
}

void low_pass(RecordedTrial& trial, double cutoff_hz) {
  if (!(cutoff_hz < 0.5 * trial.rate_hz)) return;
  const ZeroPhaseLowPass filter(cutoff_hz, trial.rate_hz);
  for (Points* points : {&trial.position_W, &trial.force_W}) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const Eigen::VectorXd row = points->row(axis);
      points->row(axis) = filter.filtered(row);
    }
  }
}

/// Takes mains hum out of all trials. Torques may hum where forces do not.
/// @param cleanings  of the trials
std::vector<std::string> remove_hum(std::vector<RecordedTrial>& trials, Mains mains,
                                    std::span<TrialCleaning> cleanings, std::string_view of_what = "") {
  if (trials.empty()) return {};
  if (mains == Mains::off) {
    const HumVerdict verdict = judge_hum(trials, &RecordedTrial::force_W, mains);
    for (std::size_t i = 0; i < trials.size(); ++i) trials[i].lines_left_in = verdict.lines_left_in[i];
    return {fmt::format("mains hum{}: left in (off)", of_what)};
  }
  std::vector<std::string> steps;
  for (const Sensed sensed : {&RecordedTrial::force_W, &RecordedTrial::torque_W_n_m}) {
    const bool are_forces = sensed == &RecordedTrial::force_W;
    const bool is_sensed =
        are_forces || std::any_of(trials.begin(), trials.end(),
                                  [](const RecordedTrial& t) { return t.sensor.has_value(); });
    if (!is_sensed) continue;
    const HumVerdict verdict = judge_hum(trials, sensed, mains);
    std::vector<MainsHum> taken;
    for (std::size_t i = 0; i < trials.size(); ++i) {
      if ((trials[i].*sensed).cols() == 0) continue;
      taken.push_back(take_off(verdict.lines[i], sensed, trials[i]));
      if (!are_forces) continue;
      trials[i].lines_left_in = verdict.lines_left_in[i];
      cleanings[i].hum_hz = taken.back().frequency_hz;
      cleanings[i].hum_n = taken.back().amplitude;
    }
    steps.push_back(hum_text(taken, verdict.left_in, are_forces, of_what));
  }
  return steps;
}

/// How trials come, with what is missing filled where that may be.
std::vector<TrialCleaning> begin_cleaning(std::vector<RecordedTrial>& trials,
                                          const CleaningSettings& settings) {
  std::vector<TrialCleaning> cleanings;
  cleanings.reserve(trials.size());
  for (RecordedTrial& trial : trials) {
    TrialCleaning cleaning;
    cleaning.name = trial_name(trial);
    cleaning.samples = static_cast<long>(trial.samples());
    cleaning.tells_contact =
        trial.sensor.has_value() && trial.lacks.empty() && !is_tracked_along_plate(trial);
    limit_fills(trial, settings.longest_fill_s, cleaning);
    cleanings.push_back(cleaning);
  }
  return cleanings;
}

/// Trials of which the normal force alone was measured, on their own: no hum, tare or delay of the others is
/// told by them.
std::vector<std::string> clean_pressed(std::vector<RecordedTrial> trials, const CleaningSettings& settings,
                                       Measurement& measurement) {
  std::vector<TrialCleaning> cleanings = begin_cleaning(trials, settings);
  const std::string_view of_what = measurement.cleanings.empty() ? "" : " of the normal force alone";
  std::vector<std::string> hum = remove_hum(trials, settings.mains, cleanings, of_what);
  for (std::size_t i = 0; i < trials.size(); ++i) {
    RecordedTrial& trial = trials[i];
    if (settings.takes_tare) take_tare(trial, cleanings[i]);
    if (settings.delay_s) shift_positions(trial, *settings.delay_s);
    if (settings.smoothing_hz > 0) low_pass(trial, settings.smoothing_hz);
    MeasuredTrial measured = in_pad_axes(trial);
    measured.lacks = trial.file + ": " + trial.lacks;
    measured.is_delay_told = measurement.knows_delay;
    measured.delay_unsure_s = measurement.knows_delay ? 0 : usual_delay_s;
    trial = RecordedTrial();
    if (measured.position_m.size() < fewest_touching_samples) {
      measurement.untouched.push_back(measured.name);
    } else {
      measurement.pressed.push_back(std::move(measured));
    }
  }
  measurement.cleanings.insert(measurement.cleanings.end(), cleanings.begin(), cleanings.end());
  return hum;
}

/// Parts the trials of which the normal force alone was measured from the others.
std::vector<RecordedTrial> taken_pressed(std::vector<RecordedTrial>& trials) {
  const auto pressed = std::stable_partition(trials.begin(), trials.end(),
                                             [](const RecordedTrial& trial) { return trial.lacks.empty(); });
  std::vector<RecordedTrial> taken(std::make_move_iterator(pressed), std::make_move_iterator(trials.end()));
  trials.erase(pressed, trials.end());
  return taken;
}

}  // namespace

Measurement clean(RecordedMeasurement recorded, const CleaningSettings& settings) {
  Measurement measurement;
  measurement.without_force = std::move(recorded.without_force);
  std::vector<RecordedTrial> pressed = taken_pressed(recorded.trials);
  measurement.cleanings = begin_cleaning(recorded.trials, settings);
  std::vector<std::string> hum = remove_hum(recorded.trials, settings.mains, measurement.cleanings);
  for (std::size_t i = 0; i < recorded.trials.size(); ++i) {
    if (settings.takes_tare) take_tare(recorded.trials[i], measurement.cleanings[i]);
    measurement.cleanings[i].is_tracked = is_tracked_along_plate(recorded.trials[i]);
    if (measurement.cleanings[i].is_tracked) {
      measurement.cleanings[i].contact_off_m = take_tracked_places(recorded.trials[i]);
    } else if (recorded.trials[i].sensor) {
      take_contact_points(recorded.trials[i]);
    }
  }
  measurement.delays = settle_delays(recorded.trials, settings);
  measurement.looks_for_tare = settings.takes_tare;
  measurement.knows_delay = settings.delay_s || !settings.takes_delay;
  for (RecordedTrial& trial : recorded.trials) {
    if (settings.smoothing_hz > 0) low_pass(trial, settings.smoothing_hz);
    MeasuredTrial measured = in_pad_axes(trial);
    measured.light_share = settings.light_share;
    if (!measurement.knows_delay) {
      measured.delay_unsure_s = delay_unsure_s(measurement.delays, trial.file);
      measured.is_delay_told = is_delay_told(measurement.delays, trial.file);
    }
    trial = RecordedTrial();
    if (measured.position_m.size() < fewest_touching_samples) {
      measurement.untouched.push_back(measured.name);
    } else {
      measurement.trials.push_back(std::move(measured));
    }
  }
  const std::vector<std::string> hum_of_pressed = clean_pressed(std::move(pressed), settings, measurement);
  hum.insert(hum.end(), hum_of_pressed.begin(), hum_of_pressed.end());
  measurement.contact_steps = contact_steps(measurement.cleanings);
  measurement.steps = steps_text(measurement, settings, hum);
  return measurement;
}

}  // namespace fingerpad
