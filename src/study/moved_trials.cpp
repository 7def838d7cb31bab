#include "study/moved_trials.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "study/axes_exponent.hpp"
#include "study/delay_estimate.hpp"
#include "study/pad_axes.hpp"
#include "study/spring_sums.hpp"

namespace fingerpad {

bool is_of(const FileDelay& delay, const RecordedTrial& trial) {
  return std::find(delay.files.begin(), delay.files.end(), trial.file) != delay.files.end();
}

MovedTrials::MovedTrials(const std::vector<RecordedTrial>& trials, const CleaningSettings& settings)
    : trials_(trials),
      settings_(settings),
      by_s_(trials.size(), 0),
      sums_(trials.size()),
      springs_(trials.size()) {
  std::vector<std::size_t> all(trials.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  tell(all);
}

void MovedTrials::move(const FileDelay& delay, double by_s) {
  std::vector<std::size_t> moved;
  for (std::size_t i = 0; i < trials_.size(); ++i) {
    if (!is_of(delay, trials_[i])) continue;
    by_s_[i] += by_s;
    moved.push_back(i);
  }
  tell(moved);
}

DelayEstimate MovedTrials::estimate_of(const FileDelay& delay) const {
  DelayBlocks blocks;
  for (std::size_t i = 0; i < trials_.size(); ++i)
    if (is_of(delay, trials_[i])) blocks.add({sums_[i]});
  if (blocks.tell_spread()) return estimate_delay(blocks, 1);
  DelayBlocks parts;
  parts.are_parts = true;
  for (std::size_t i = 0; i < trials_.size(); ++i) {
    if (sums_[i].samples == 0 || !is_of(delay, trials_[i])) continue;
    MeasuredTrial measured = measured_trial(i);
    const StickSegments segments = stick_segments(measured, axes_exponent_);
    take_axes(measured);
    parts.add(delay_sums_by_part(measured, segments));
  }
  return estimate_delay(parts, 1);
}

MeasuredTrial MovedTrials::measured_trial(std::size_t i) const {
  RecordedTrial moved;
  if (by_s_[i] != 0) {
    moved = trials_[i];
    shift_positions(moved, by_s_[i]);
  }
  MeasuredTrial measured = in_pad_axes(by_s_[i] == 0 ? trials_[i] : moved);
  measured.light_share = settings_.light_share;
  return measured;
}

void MovedTrials::tell(std::vector<std::size_t> of) {
  for (const std::size_t i : of) tell_springs(i);
  if (settle_axes()) {
    of.resize(trials_.size());
    std::iota(of.begin(), of.end(), std::size_t{0});
    for (const std::size_t i : of) tell_springs(i);
  }
  for (const std::size_t i : of) tell_sums(i);
}

void MovedTrials::tell_springs(std::size_t i) {
  const MeasuredTrial measured = measured_trial(i);
  springs_[i] = TrialEvidence();
  if (measured.position_m.size() < fewest_touching_samples) return;
  springs_[i] = spring_evidence(measured, stick_segments(measured, axes_exponent_));
}

void MovedTrials::tell_sums(std::size_t i) {
  MeasuredTrial measured = measured_trial(i);
  sums_[i] = DelaySums();
  if (measured.position_m.size() < fewest_touching_samples) return;
  const StickSegments segments = stick_segments(measured, axes_exponent_);
  take_axes(measured);
  sums_[i] = delay_sums(measured, segments);
}

bool MovedTrials::settle_axes() {
  if (!settings_.takes_axes_exponent) return false;
  const auto found = axes_exponent(springs_, 0);
  const double exponent = found ? found->value : 0;
  return std::exchange(axes_exponent_, exponent) != exponent;
}

void MovedTrials::take_axes(MeasuredTrial& measured) const {
  if (axes_exponent_ == 0) return;
  EvidencePoint about;
  about.axes_exponent = axes_exponent_;
  for (std::size_t k = 0; k < measured.force_ratio.size(); ++k)
    measured.force_ratio[k] *= about.axes_at(measured.normal_force_n[k]);
}

}  // namespace fingerpad
