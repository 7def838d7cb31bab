#pragma once

#include <array>
#include <optional>
#include <vector>

namespace fingerpad {

struct TrialEvidence;

/// Slip by its speed: sums over samples whose speed lies in a bin. Bins are 2.5 % wide, from 5 mm/s on.
struct SlipBySpeed {
  static constexpr std::size_t bins = 220;
  std::array<double, bins> ratio{};  ///< of r = -q.v/|v|
  std::array<double, bins> samples{};

  void add(double speed_m_per_s, double along);
  static constexpr double bin_width = 0.025;  ///< of the logarithm
  /// The least speed of a bin.
  static double speed_m_per_s(std::size_t bin);
};

/// Where friction in slip is lower above a speed than below it.
struct SpeedStep {
  double speed_m_per_s = 0;
  double rise = 0;               ///< of the ratio from above to below
  bool is_sharp = false;         ///< most of it lies within a fifth of that speed
  long samples = 0, trials = 0;  ///< that slip below it
};

/// The speed that parts the slip of all trials best: of each trial the mean below against that above, so that
/// trials of another friction do not count. Under the pad's law what slips below v_min is stick that gives
/// way within a few samples, whose friction is half way up to mu_static. Nothing where too little is below.
/// @param times  how often each trial counts
std::optional<SpeedStep> speed_step(const std::vector<TrialEvidence>& trials, const std::vector<int>& times);

}  // namespace fingerpad
