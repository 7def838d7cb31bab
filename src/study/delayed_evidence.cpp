#include "study/delayed_evidence.hpp"

#include <algorithm>
#include <cmath>

namespace fingerpad {
namespace {

/// A trial's velocities of a moment later (or earlier), as far as it goes on without a gap.
std::vector<Vec2> later_velocities(const MeasuredTrial& trial, const StickSegments& segments, double by_s) {
  const double samples = by_s * trial.rate_hz, whole = std::floor(samples), rest = samples - whole;
  const std::vector<Vec2>& now = segments.velocity_m_per_s;
  std::vector<Vec2> later;
  later.reserve(now.size());
  std::ptrdiff_t from = 0, to = 0;  // of the run that a sample is of
  for (std::size_t k = 0; k < now.size(); ++k) {
    const auto here = static_cast<std::ptrdiff_t>(k);
    if (here >= to) {
      from = here;
      for (to = from + 1; to < static_cast<std::ptrdiff_t>(now.size()); ++to)
        if (trial.starts_anew[static_cast<std::size_t>(to)]) break;
    }
    const auto at = [&](std::ptrdiff_t i) {
      return now[static_cast<std::size_t>(std::clamp(i, from, to - 1))];
    };
    const std::ptrdiff_t moved = here + static_cast<std::ptrdiff_t>(whole);
    later.emplace_back(at(moved) + rest * (at(moved + 1) - at(moved)));
  }
  return later;
}

}  // namespace

void delay_heights(MeasuredTrial& trial, std::size_t half_window, double by_s) {
  const std::vector<double> heights = trial.height_m;
  for (std::size_t k = 0; k < heights.size(); ++k) {
    std::size_t from = k, to = k;
    while (k - from < half_window && from > 0 && !trial.starts_anew[from]) --from;
    while (to - k < half_window && to + 1 < heights.size() && !trial.starts_anew[to + 1]) ++to;
    if (to > from)
      trial.height_m[k] +=
          by_s * trial.rate_hz * (heights[to] - heights[from]) / static_cast<double>(to - from);
  }
}

std::vector<TrialEvidence> delayed_evidence(const Measurement& measurement,
                                            const std::vector<StickSegments>& segments,
                                            const EvidencePoint& about, double delay_left_s, double times) {
  std::vector<TrialEvidence> delayed;
  delayed.reserve(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    MeasuredTrial trial = measurement.trials[i];
    const double by_s = times * (trial.delay_unsure_s + std::abs(delay_left_s));
    for (std::size_t k = 0; k < trial.position_m.size(); ++k)
      trial.position_m[k] += by_s * segments[i].velocity_m_per_s[k];
    delay_heights(trial, static_cast<std::size_t>(segments[i].half_window), by_s);
    StickSegments moved = segments[i];
    moved.velocity_m_per_s = later_velocities(trial, segments[i], by_s);
    delayed.push_back(trial_evidence(trial, moved, about));
  }
  return delayed;
}

}  // namespace fingerpad
