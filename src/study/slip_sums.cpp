#include "study/slip_sums.hpp"

#include <algorithm>
#include <cmath>

#include "base/spectrum.hpp"
#include "study/phase_stretch.hpp"

namespace fingerpad {
namespace {

/// Variance of a component of the velocity that a window tells [m^2/s^2].
double velocity_variance(const MeasuredTrial& trial, const StickSegments& segments) {
  const double n = 2.0 * segments.half_window + 1;
  return 12 * std::pow(segments.position_noise_m * trial.rate_hz, 2) / (n * (n * n - 1));
}

/// Adds a stretch's ratios and loads, as means over groups: of single samples the load's noise would stand in
/// the load and, turned round, in the ratio over it, and pass for friction that falls with the load.
/// @param along  the ratio against the motion, per sample of the stretch
void add_loads(const MeasuredTrial& trial, const PhaseStretch& s, const std::vector<double>& along,
               double load_n, TrialEvidence& evidence) {
  constexpr double group_s = 20e-3;
  const std::size_t samples = along.size(),
                    wanted = static_cast<std::size_t>(std::max(1L, std::lround(group_s * trial.rate_hz))),
                    groups = std::max<std::size_t>(1, samples / wanted);
  for (std::size_t k = 0; k < groups; ++k) {
    const std::size_t from = k * samples / groups, to = (k + 1) * samples / groups;
    double normal_n = 0, friction_n = 0;
    for (std::size_t i = from; i < to; ++i) {
      normal_n += trial.normal_force_n[s.from + i];
      friction_n += trial.normal_force_n[s.from + i] * along[i];
    }
    const auto count = static_cast<double>(to - from);
    const double ratio = friction_n / normal_n, log_load = std::log(normal_n / count),
                 load = log_load - std::log(load_n);
    evidence.slip_log_load += count * log_load;
    evidence.slip_ratio += count * ratio;
    evidence.slip_load += count * load;
    evidence.slip_load_2 += count * load * load;
    evidence.slip_load_ratio += count * load * ratio;
  }
  evidence.slip_samples += static_cast<long>(samples);
}

}  // namespace

PhaseStretch fast_part(PhaseStretch stretch, const StickSegments& segments, double v_min_m_per_s) {
  constexpr double above = 1.1;
  const auto is_slow = [&](std::size_t i) {
    return segments.velocity_m_per_s[i].norm() < above * v_min_m_per_s;
  };
  while (stretch.from < stretch.to && is_slow(stretch.from)) ++stretch.from;
  while (stretch.to > stretch.from && is_slow(stretch.to - 1)) --stretch.to;
  return stretch;
}

void add_slip_sums(const MeasuredTrial& trial, const StickSegments& segments, const std::vector<Vec2>& ratio,
                   const EvidencePoint& about, TrialEvidence& evidence) {
  const std::size_t window = vibration_window(trial.rate_hz);
  // A shorter one may be stick that hardly moves; and a vibration's mean takes some of its periods.
  const auto shortest = 4 * static_cast<std::size_t>(segments.half_window);
  const double sway = velocity_variance(trial, segments);
  std::vector<double> along;
  for (const PhaseStretch& whole : phase_stretches(segments, PadPhase::slip)) {
    const PhaseStretch inner = inner_stretch(whole, segments);
    for (std::size_t i = inner.from; inner.to - inner.from >= shortest && i < inner.to; ++i) {
      const Vec2& v = segments.velocity_m_per_s[i];
      evidence.slip_by_speed.add(v.norm(), -ratio[i].dot(v.normalized()));
    }
    const PhaseStretch s = fast_part(inner, segments, about.v_min_m_per_s);
    if (s.to - s.from < shortest) continue;
    along.clear();
    for (std::size_t i = s.from; i < s.to; ++i) {
      const Vec2& v = segments.velocity_m_per_s[i];
      // A direction with noise of angle e shortens what lies along it by e^2/2 on the average.
      const double shortened = 1 - std::min(0.1, sway / (2 * v.squaredNorm()));
      along.push_back(-ratio[i].dot(v.normalized()) / shortened);
    }
    add_loads(trial, s, along, about.load.load_n, evidence);
    if (along.size() < window) continue;
    const Spectrum spectrum = welch_spectrum(along, trial.rate_hz, window);
    const auto pieces = static_cast<long>((along.size() - window) / (window / 2) + 1);
    evidence.power.resize(spectrum.density.size(), 0.0);
    for (std::size_t k = 0; k < evidence.power.size(); ++k)
      evidence.power[k] += static_cast<double>(pieces) * spectrum.density[k];
    evidence.pieces += pieces;
  }
}

}  // namespace fingerpad
