#include "study/trial_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/spectrum.hpp"

namespace fingerpad {
namespace {

/// A run of samples of one phase, [from, to).
struct Stretch {
  std::size_t from, to;
};

std::vector<Stretch> stretches(const StickSegments& segments, PadPhase phase) {
  std::vector<Stretch> found;
  const std::size_t samples = segments.phase.size();
  for (std::size_t i = 0; i < samples;) {
    if (segments.phase[i] != phase) {
      ++i;
      continue;
    }
    Stretch stretch{i, i + 1};
    while (stretch.to < samples && segments.phase[stretch.to] == phase && !segments.begins_run[stretch.to])
      ++stretch.to;
    i = stretch.to;
    found.push_back(stretch);
  }
  return found;
}

/// Without the samples at its ends whose windows reach into another phase.
Stretch inner(Stretch stretch, const StickSegments& segments) {
  const auto half = static_cast<std::size_t>(segments.half_window);
  const std::size_t samples = segments.phase.size();
  if (!segments.begins_run[stretch.from]) stretch.from += half;
  const bool ends_run = stretch.to >= samples || segments.begins_run[stretch.to];
  if (!ends_run) stretch.to = stretch.to > half ? stretch.to - half : 0;
  stretch.to = std::max(stretch.to, stretch.from);
  return stretch;
}

void add_stiffness(const MeasuredTrial& trial, const StickSegments& segments, TrialEvidence& evidence) {
  const double noise_m2 = segments.position_noise_m * segments.position_noise_m;
  for (const Stretch& whole : stretches(segments, PadPhase::stick)) {
    const Stretch s = inner(whole, segments);
    if (s.to < s.from + 5) continue;
    const auto count = static_cast<double>(s.to - s.from);
    Vec2 mean_x(0, 0), mean_q(0, 0), spread(0, 0), pull(0, 0);
    for (std::size_t i = s.from; i < s.to; ++i) {
      mean_x += trial.position_m[i] / count;
      mean_q += trial.force_ratio[i] / count;
    }
    for (std::size_t i = s.from; i < s.to; ++i) {
      const Vec2 dx = trial.position_m[i] - mean_x;
      spread += dx.cwiseProduct(dx);
      pull -= dx.cwiseProduct(trial.force_ratio[i] - mean_q);
    }
    evidence.spread_m2 += spread - Vec2::Constant((count - 1) * noise_m2);
    evidence.pull_m += pull;
    evidence.stick_samples += static_cast<long>(s.to - s.from);
  }
}

/// |q| just before the rupture at sample i; nothing where the pad was not plainly pulled until then.
std::optional<double> ratio_at_rupture(const MeasuredTrial& trial, const StickSegments& segments,
                                       std::size_t i) {
  constexpr std::size_t most = 8, fewest = 6;
  std::size_t from = i - 1;
  while (from > 0 && i - from < most && !segments.begins_run[from]) --from;
  if (i - from < fewest) return std::nullopt;
  const Vec2 towards = (trial.force_ratio[i - 1] + trial.force_ratio[i - 2]).normalized();
  const auto count = static_cast<double>(i - from);
  const double middle = (count - 1) / 2;
  double mean = 0, slope = 0, squares = 0;
  for (std::size_t j = from; j < i; ++j) {
    const double t = static_cast<double>(j - from) - middle;
    mean += trial.force_ratio[j].dot(towards) / count;
    slope += t * trial.force_ratio[j].dot(towards);
    squares += t * t;
  }
  slope /= squares;
  if (!(slope > 0)) return std::nullopt;
  return mean + slope * (middle + 0.5);
}

void add_ruptures(const MeasuredTrial& trial, const StickSegments& segments, TrialEvidence& evidence) {
  for (std::size_t i = 2; i < trial.force_ratio.size(); ++i) {
    if (!segments.is_rupture[i]) continue;
    const auto ratio = ratio_at_rupture(trial, segments, i);
    if (!ratio) continue;
    evidence.rupture_ratio += *ratio;
    ++evidence.ruptures;
  }
}

double along_slip(const MeasuredTrial& trial, const StickSegments& segments, std::size_t i) {
  return -trial.force_ratio[i].dot(segments.velocity_m_per_s[i].normalized());
}

void add_slip(const MeasuredTrial& trial, const StickSegments& segments, TrialEvidence& evidence) {
  const std::size_t window = vibration_window(trial.rate_hz);
  for (const Stretch& whole : stretches(segments, PadPhase::slip)) {
    const Stretch s = inner(whole, segments);
    std::vector<double> ratios;
    for (std::size_t i = s.from; i < s.to; ++i) ratios.push_back(along_slip(trial, segments, i));
    for (const double ratio : ratios) evidence.slip_ratio += ratio;
    evidence.slip_samples += static_cast<long>(ratios.size());
    if (ratios.size() < window) continue;
    const Spectrum spectrum = welch_spectrum(ratios, trial.rate_hz, window);
    const auto pieces = static_cast<long>((ratios.size() - window) / (window / 2) + 1);
    evidence.power.resize(spectrum.density.size(), 0.0);
    for (std::size_t k = 0; k < evidence.power.size(); ++k)
      evidence.power[k] += static_cast<double>(pieces) * spectrum.density[k];
    evidence.pieces += pieces;
  }
}

/// What the pad does after a stretch of slip, along the motion at its end.
struct Stop {
  std::vector<double> way_m, ratio;
  double slip_ratio = 0;  ///< mean before it
};

Stop stop_after(const MeasuredTrial& trial, const StickSegments& segments, const Stretch& slip) {
  const auto half = static_cast<std::size_t>(segments.half_window);
  const Vec2 forward = segments.velocity_m_per_s[slip.to - 1].normalized();
  Stop stop;
  const std::size_t last = slip.to - half, first = last > slip.from + 6 * half ? last - 6 * half : slip.from;
  for (std::size_t i = first; i < last; ++i)
    stop.slip_ratio -= trial.force_ratio[i].dot(forward) / static_cast<double>(last - first);
  for (std::size_t i = last; i < trial.position_m.size() && i < slip.to + 6 * half; ++i) {
    if (i > slip.from && segments.begins_run[i]) break;
    if (!(segments.velocity_m_per_s[i].dot(forward) > 0)) break;
    stop.way_m.push_back(trial.position_m[i].dot(forward));
    stop.ratio.push_back(-trial.force_ratio[i].dot(forward));
  }
  return stop;
}

/// Where along the way slip ended: the rising samples, taken back along the spring.
std::optional<double> end_of_slip_m(const Stop& stop, double stiffness_per_m, double noise) {
  constexpr std::size_t fewest = 3;
  if (stop.ratio.size() < fewest) return std::nullopt;
  const double rise = *std::max_element(stop.ratio.begin(), stop.ratio.end()) - stop.slip_ratio;
  if (!(rise > 5 * noise) || !(rise > 0.15 * stop.slip_ratio)) return std::nullopt;
  double sum = 0, count = 0;
  for (std::size_t i = stop.ratio.size(); i-- > 0;) {
    const double above = stop.ratio[i] - stop.slip_ratio;
    if (above < 0.25 * rise) break;
    sum += stop.way_m[i] - above / stiffness_per_m;
    ++count;
  }
  if (count < fewest) return std::nullopt;
  return sum / count;
}

void add_stops(const MeasuredTrial& trial, const StickSegments& segments, TrialEvidence& evidence) {
  const auto half = static_cast<std::size_t>(segments.half_window);
  for (const Stretch& slip : stretches(segments, PadPhase::slip)) {
    if (slip.to < slip.from + 4 * half) continue;
    const Vec2 forward = segments.velocity_m_per_s[slip.to - 1].normalized();
    const Vec2 share = forward.cwiseProduct(forward);
    const double spread = share.dot(evidence.spread_m2), pull = share.dot(evidence.pull_m);
    if (!(spread > 0) || !(pull > 0)) continue;
    const Stop stop = stop_after(trial, segments, slip);
    const auto end_m = end_of_slip_m(stop, pull / spread, segments.ratio_noise);
    if (!end_m) continue;
    for (std::size_t i = slip.to > 8 * half ? slip.to - 8 * half : 1;
         i < std::min(trial.position_m.size(), slip.to + 6 * half); ++i) {
      // Positions as noisy as they are, the first sample past the place is as good as any between.
      if (trial.position_m[i].dot(forward) < *end_m) continue;
      evidence.stop_speed_m_per_s += segments.velocity_m_per_s[i].norm();
      ++evidence.stops;
      break;
    }
  }
}

}  // namespace

std::size_t vibration_window(double rate_hz) {
  std::size_t length = 32;
  while (static_cast<double>(length) * 1.5 < 0.25 * rate_hz) length *= 2;
  return length;
}

TrialEvidence trial_evidence(const MeasuredTrial& trial, const StickSegments& segments) {
  TrialEvidence evidence;
  evidence.subject = trial.subject;
  evidence.has_direction = trial.has_direction;
  evidence.inclination_deg = trial.inclination_deg;
  evidence.rate_hz = trial.rate_hz;
  add_stiffness(trial, segments, evidence);
  add_ruptures(trial, segments, evidence);
  add_slip(trial, segments, evidence);
  add_stops(trial, segments, evidence);
  return evidence;
}

}  // namespace fingerpad
