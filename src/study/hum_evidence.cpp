#include "study/hum_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>
#include <vector>

#include "study/air_hum.hpp"
#include "study/force_tare.hpp"
#include "study/sample_noise.hpp"

namespace fingerpad {
namespace {

constexpr double hum_window_s = 0.2;

using Samples = std::vector<Eigen::Index>;

/// How much of a line is in some samples of a trial. Only samples that HannLine counts are looked at.
struct InSamples {
  std::complex<double> ratio;  ///< 1: the line as it is in the whole trial
  double weight = 0;           ///< 1 over the variance of the ratio's real part; 0: they tell nothing
};

InSamples line_in(const HannLine& whole, const HumLine& line, double rate_hz,
                  std::span<const Eigen::Index> samples) {
  constexpr double fewest_periods = 2;
  const double turn = 2 * std::numbers::pi * line.hz / rate_hz;
  InSamples found{};
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const std::complex<double> phasor = line.phasors[static_cast<std::size_t>(axis)];
    if (!line.hums[static_cast<std::size_t>(axis)]) continue;
    std::complex<double> sum = 0;
    double power = 0, count = 0;
    for (const Eigen::Index i : samples) {
      if (!whole.counts(axis, i)) continue;
      const double value = whole.rest()(axis, i);
      sum += value * std::polar(1.0, -turn * static_cast<double>(i));
      power += value * value;
      ++count;
    }
    if (count * line.hz < fewest_periods * rate_hz) continue;
    sum *= 2 / count;
    // Of a sine half of the power is its own.
    const double noise2 = std::max(power / count - 0.5 * std::norm(sum), 1e-6 * std::norm(phasor));
    const double weight = count * std::norm(phasor) / (2 * noise2);
    found.ratio += weight * sum / phasor;
    found.weight += weight;
  }
  if (found.weight > 0) found.ratio /= found.weight;
  return found;
}

/// How a finger moves through a window.
struct WindowMotion {
  double speed_m_per_s;
  bool turns;  ///< it goes some of the way back
};

WindowMotion motion_of(const RecordedTrial& trial, Eigen::Index from, Eigen::Index window) {
  constexpr Eigen::Index quarters = 4;
  const Points& place = trial.seen_W();
  const Eigen::Index quarter = window / quarters;
  Vec3 first = Vec3::Zero(), before = Vec3::Zero();
  double way_m = 0;
  for (Eigen::Index k = 0; k < quarters; ++k) {
    const Vec3 mean = place.middleCols(from + k * quarter, quarter).rowwise().mean();
    if (k == 0) first = mean;
    if (k > 0) way_m += (mean - before).norm();
    before = mean;
  }
  constexpr double straight = 0.9;
  return {way_m * trial.rate_hz / static_cast<double>((quarters - 1) * quarter),
          (before - first).norm() < straight * way_m};
}

/// Samples at which nothing touches the sensor, window by window.
std::vector<Samples> windows_without_contact(const RecordedTrial& trial, Sensed sensed, const HumLine& line,
                                             Eigen::Index window) {
  Samples free = moments_without_contact(trial).samples;
  if (sensed == &RecordedTrial::force_W &&
      (free.empty() || 2 * (free.back() - free.front()) < trial.samples())) {
    // With hum in them they may not be as still as such moments are, nor with teeth's taken off: what of the
    // line is there where hardly anything presses is.
    const AirHum light(trial, sensed, lightest_samples(trial, line.nominal_hz), line.nominal_hz);
    if (const auto bounded = light.bounded(line, line.hz)) {
      RecordedTrial without = trial;
      take_off({*bounded}, sensed, without);
      Samples more = moments_without_contact(without).samples;
      if (more.size() > free.size()) free = std::move(more);
    }
  }
  std::vector<Samples> windows;
  Eigen::Index begin = -window;
  for (const Eigen::Index i : free) {
    if (i >= begin + window) {
      windows.emplace_back();
      begin = i;
    }
    windows.back().push_back(i);
  }
  return windows;
}

}  // namespace

HumEvidence& HumEvidence::operator+=(const HumEvidence& other) {
  still += other.still;
  in_air += other.in_air;
  windows.insert(windows.end(), other.windows.begin(), other.windows.end());
  return *this;
}

HumEvidence hum_evidence(const RecordedTrial& trial, Sensed sensed, const HumLine& line) {
  constexpr double stands_m_per_s = 1e-3;  // teeth at 50 Hz would be 20 micrometres long
  constexpr double surest = 0.25, near = 0.5;
  const auto window = std::max<Eigen::Index>(4, static_cast<Eigen::Index>(hum_window_s * trial.rate_hz));
  const HannLine whole(trial, sensed, line.nominal_hz);
  HumEvidence found;
  const auto share_of = [](const InSamples& here) {
    return HumShare{here.weight * here.ratio.real(), here.weight};
  };
  std::vector<bool> is_free(static_cast<std::size_t>(trial.samples()));
  for (const Samples& free : windows_without_contact(trial, sensed, line, window)) {
    found.in_air += share_of(line_in(whole, line, trial.rate_hz, free));
    for (const Eigen::Index i : free) is_free[static_cast<std::size_t>(i)] = true;
    found.free.insert(found.free.end(), free.begin(), free.end());
  }
  found.still = found.in_air;
  std::vector<double> speeds;
  for (Eigen::Index from = 0; from + window <= trial.samples(); from += window) {
    Samples samples(static_cast<std::size_t>(window));
    std::iota(samples.begin(), samples.end(), from);
    std::erase_if(samples, [&](Eigen::Index i) { return is_free[static_cast<std::size_t>(i)]; });
    const InSamples here = line_in(whole, line, trial.rate_hz, samples);
    if (!(here.weight > 0)) continue;
    const WindowMotion motion = motion_of(trial, from, window);
    speeds.push_back(motion.speed_m_per_s);
    if (motion.speed_m_per_s < stands_m_per_s) {
      found.still += share_of(here);
    } else if (here.weight * surest * surest > 1) {
      found.windows.push_back({motion.speed_m_per_s, std::abs(here.ratio - 1.0) < near, motion.turns});
    }
  }
  found.speed_m_per_s = median_of(speeds);
  return found;
}

}  // namespace fingerpad
