#pragma once

#include <vector>

#include "study/cleaning_settings.hpp"
#include "study/measurement.hpp"
#include "study/position_delay.hpp"
#include "study/trial_evidence.hpp"

namespace fingerpad {

/// Whether a trial's file is among those of a delay.
bool is_of(const FileDelay& delay, const RecordedTrial& trial);

/// Trials as they would be with the delays taken out, and what they say of what is left.
class MovedTrials {
 public:
  /// Both outlive it.
  MovedTrials(const std::vector<RecordedTrial>& trials, const CleaningSettings& settings);

  /// Moves all trials of a file, or of several, by so much more.
  void move(const FileDelay& delay, double by_s);

  /// What is left of a file's delay. Of too few trials it is drawn from parts of them how far it may be off.
  DelayEstimate estimate_of(const FileDelay& delay) const;

 private:
  MeasuredTrial measured_trial(std::size_t i) const;
  /// Of these, or of all where the axes' power of the load changes by them: the springs, then the sums, which
  /// take most of the time.
  void tell(std::vector<std::size_t> of);
  /// Nothing of those without stick, both.
  void tell_springs(std::size_t i);
  void tell_sums(std::size_t i);
  /// Springs that go with another power of the load than the pad's law has it would have the force follow the
  /// load beside the position, and pass for delayed. Whether the power is another now.
  bool settle_axes();
  /// Makes force ratios those that its springs, were they the law's, would have.
  void take_axes(MeasuredTrial& measured) const;

  const std::vector<RecordedTrial>& trials_;
  const CleaningSettings& settings_;
  std::vector<double> by_s_;
  std::vector<DelaySums> sums_;
  std::vector<TrialEvidence> springs_;
  double axes_exponent_ = 0;  ///< EvidencePoint's
};

}  // namespace fingerpad
