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

}  // namespace

void add_slip_sums(const MeasuredTrial& trial, const StickSegments& segments, const std::vector<Vec2>& ratio,
                   double load_n, TrialEvidence& evidence) {
  const std::size_t window = vibration_window(trial.rate_hz);
  // A shorter one may be stick that hardly moves; and a vibration's mean takes some of its periods.
  const auto shortest = 4 * static_cast<std::size_t>(segments.half_window);
  const double sway = velocity_variance(trial, segments);
  std::vector<double> along;
  for (const PhaseStretch& whole : phase_stretches(segments, PadPhase::slip)) {
    const PhaseStretch s = inner_stretch(whole, segments);
    if (s.to - s.from < shortest) continue;
    along.clear();
    for (std::size_t i = s.from; i < s.to; ++i) {
      const Vec2& v = segments.velocity_m_per_s[i];
      // A direction with noise of angle e shortens what lies along it by e^2/2 on the average.
      const double shortened = 1 - std::min(0.1, sway / (2 * v.squaredNorm()));
      along.push_back(-ratio[i].dot(v.normalized()) / shortened);
      const double log_load = std::log(trial.normal_force_n[i]), load = log_load - std::log(load_n);
      evidence.slip_log_load += log_load;
      evidence.slip_ratio += along.back();
      evidence.slip_load += load;
      evidence.slip_load_2 += load * load;
      evidence.slip_load_ratio += load * along.back();
    }
    evidence.slip_samples += static_cast<long>(along.size());
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
