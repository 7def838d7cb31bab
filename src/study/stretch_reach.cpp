#include "study/stretch_reach.hpp"

#include <limits>

#include "study/phase_stretch.hpp"

namespace fingerpad {
namespace {

constexpr std::size_t parts = 10;
constexpr double student_t = 2.262;  // 97.5 % of its distribution of nine degrees of freedom

/// A trial's stick in pieces of no more than a tenth of it.
std::vector<PhaseStretch> stick_pieces(const StickSegments& segments) {
  const std::vector<PhaseStretch> stretches = phase_stretches(segments, PadPhase::stick);
  std::size_t samples = 0;
  for (const PhaseStretch& s : stretches) samples += s.to - s.from;
  const std::size_t most = samples / parts + 1;
  std::vector<PhaseStretch> pieces;
  for (const PhaseStretch& s : stretches) {
    const std::size_t count = (s.to - s.from + most - 1) / most;
    for (std::size_t k = 0; k < count; ++k)
      pieces.push_back({s.from + k * (s.to - s.from) / count, s.from + (k + 1) * (s.to - s.from) / count});
  }
  return pieces;
}

/// The evidence without a part of each trial's stick. Its springs alone are others; the rest stays.
std::vector<TrialEvidence> evidence_without(std::size_t part, const Measurement& measurement,
                                            const std::vector<StickSegments>& segments,
                                            const std::vector<TrialEvidence>& whole,
                                            const EvidencePoint& about) {
  std::vector<TrialEvidence> evidence = whole;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    StickSegments rest = segments[i];
    const std::vector<PhaseStretch> pieces = stick_pieces(rest);
    for (std::size_t k = part; k < pieces.size(); k += parts)
      for (std::size_t sample = pieces[k].from; sample < pieces[k].to; ++sample)
        rest.phase[sample] = PadPhase::unknown;
    const TrialEvidence told = trial_evidence(measurement.trials[i], rest, about);
    evidence[i].spring = told.spring;
    evidence[i].spring_noise = told.spring_noise;
    evidence[i].stick_samples = told.stick_samples;
  }
  return evidence;
}

}  // namespace

NumberReaches reach_by_stretches(const Measurement& measurement, const std::vector<StickSegments>& segments,
                                 const ProfileFit& fit, const FitPoint& point) {
  const std::vector<int> once(segments.size(), 1);
  std::array<LeftOutSpread, pad_number_keys.size()> without;
  const LeftOut one_part{once, 0, static_cast<double>(parts)};
  for (std::size_t part = 0; part < parts; ++part) {
    const PadValues values =
        pad_numbers(evidence_without(part, measurement, segments, fit.evidence, point.evidence), once, point);
    for (const PadNumber number : spring_numbers)
      if (value_of(values, number).refusal.empty())
        without[static_cast<std::size_t>(number)].add(one_part, value_of(values, number).value);
  }
  NumberReaches reach{};
  for (const PadNumber number : spring_numbers) {
    const auto k = static_cast<std::size_t>(number);
    reach[k] = student_t * without[k].deviation(parts).value_or(std::numeric_limits<double>::infinity());
  }
  return reach;
}

}  // namespace fingerpad
