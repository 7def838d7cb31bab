#include "study/evidence_reach.hpp"

namespace fingerpad {
namespace {

NumberReaches moved_about(const Measurement& measurement, const std::vector<StickSegments>& segments,
                          const ProfileFit& fit, const FitPoint& other) {
  std::vector<TrialEvidence> evidence;
  evidence.reserve(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i)
    evidence.push_back(trial_evidence(measurement.trials[i], segments[i], other.evidence));
  return moved_by(evidence, fit, other);
}

}  // namespace

NumberReaches moved_by_load(const Measurement& measurement, const std::vector<StickSegments>& segments,
                            const ProfileFit& fit, const FitPoint& point) {
  constexpr double of_hertz_pad = -1.0 / 3;
  FitPoint rising = point;
  rising.evidence.load.exponent = of_hertz_pad;
  return moved_about(measurement, segments, fit, rising);
}

NumberReaches moved_by_axes(const Measurement& measurement, const std::vector<StickSegments>& segments,
                            const ProfileFit& fit, const FitPoint& point) {
  FitPoint more = point;
  more.evidence.axes_exponent += 2 * fit.axes_exponent->deviation;
  return moved_about(measurement, segments, fit, more);
}

NumberReaches moved_by_tail(const Measurement& measurement, std::vector<StickSegments> segments,
                            const ProfileFit& fit, const FitPoint& point) {
  for (StickSegments& trial : segments) ++trial.drop_tail;
  return moved_about(measurement, segments, fit, point);
}

}  // namespace fingerpad
