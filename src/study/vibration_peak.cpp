#include "study/vibration_peak.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <map>
#include <numbers>
#include <unsupported/Eigen/FFT>
#include <utility>

namespace fingerpad {
namespace {

constexpr double lowest_hz = 20;
using Parameters = Eigen::Vector<double, 5>;  // ln frequency, ln bandwidth, ln power, ln floor, tilt

/// How far the tilt may be expected from 0: of a sensor's low pass at 300 Hz it is -0.15, of a vibration that
/// goes from sample to sample 0.1 at 89 Hz and 1 kHz and 0.4 at 500 Hz.
constexpr double usual_tilt = 0.3;

/// Of a Hann window with itself, per lag; 1 at none.
std::vector<double> window_overlap(std::size_t length) {
  std::vector<double> window(length), overlap(length);
  for (std::size_t i = 0; i < length; ++i)
    window[i] =
        0.5 - 0.5 * std::cos(2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(length));
  for (std::size_t lag = 0; lag < length; ++lag) {
    for (std::size_t i = 0; i + lag < length; ++i) overlap[lag] += window[i] * window[i + lag];
  }
  for (std::size_t lag = length; lag-- > 0;) overlap[lag] /= overlap[0];
  return overlap;
}

/// What Welch's windows are expected to show of the model.
class WindowedModel {
 public:
  WindowedModel(std::vector<double> overlap, double rate_hz)
      : length_(overlap.size()), rate_hz_(rate_hz), overlap_(std::move(overlap)) {}

  /// One-sided density of a vibration of variance 1, per bin: the transform of its correlation times the
  /// window's.
  std::vector<double> density(double frequency_hz, double bandwidth_hz) {
    // The correlation of a damped oscillation that noise drives, whose density peaks at frequency_hz.
    const double damping = std::numbers::pi * bandwidth_hz,
                 turning = std::hypot(2 * std::numbers::pi * frequency_hz, damping),
                 r = std::exp(-damping / rate_hz_), cosine = std::cos(turning / rate_hz_),
                 back_1 = 2 * r * cosine;
    std::vector<double> correlation(length_);
    correlation[0] = 1;
    correlation[1] = r * (cosine + damping / turning * std::sin(turning / rate_hz_));
    for (std::size_t k = 2; k < length_; ++k)
      correlation[k] = back_1 * correlation[k - 1] - r * r * correlation[k - 2];
    for (std::size_t k = 0; k < length_; ++k) correlation[k] *= overlap_[k];
    std::vector<double> folded(length_);
    folded[0] = 1;
    for (std::size_t k = 1; k < length_; ++k) folded[k] = correlation[k] + correlation[length_ - k];
    std::vector<std::complex<double>> transform;
    fft_.fwd(transform, folded);
    std::vector<double> density(length_ / 2 + 1);
    for (std::size_t k = 0; k < density.size(); ++k)
      density[k] = std::max(2 * transform[k].real() / rate_hz_, 1e-12 / rate_hz_);
    return density;
  }

 private:
  std::size_t length_;
  double rate_hz_;
  std::vector<double> overlap_;
  Eigen::FFT<double> fft_;  ///< which keeps its factors
};

/// How many times the median the highest of some hundred bins must be, so that noise alone is hardly ever as
/// high, even if it is not quite white: the mean of Welch's windows is a gamma variable, here by Wilson and
/// Hilferty (1931).
double least_height(long windows) {
  constexpr double usual = 3, deviations = 5;  // a tail of 3e-7 a bin
  // Hann windows that overlap by half are a little alike.
  const double spread = 1 / (9 * std::max(1.0, 0.9 * static_cast<double>(windows)));
  return std::max(usual, std::pow(1 + deviations * std::sqrt(spread) / (1 - spread), 3));
}

/// Whether a line that was left in may be what stands at a bin: the window smears it over two steps.
bool is_of_line(const SlipDensity& mean, double step_hz, std::size_t bin) {
  return std::any_of(mean.lines_hz.begin(), mean.lines_hz.end(), [&](double line_hz) {
    return std::abs(static_cast<double>(bin) * step_hz - line_hz) < 2.5 * step_hz;
  });
}

/// Why no vibration is told where one is left in.
std::string line_words(double line_hz) {
  return fmt::format(
      "a line near {0:.0f} Hz is left in the forces (see mains hum), which may be what stands there: --mains "
      "{0:.0f} takes it out, if it is hum; a second in the air in each trial tells",
      line_hz);
}

/// Lines are left in that are much of what stands there in slip.
/// @param squares  sum over windows of the square of each line's share of the normal force
std::vector<double> standing_lines(const SlipDensity& mean, const std::map<double, double>& squares) {
  constexpr double least_share = 0.25, hann_bins = 1.5;  // a sine's variance over its bin's density
  std::vector<double> found;
  const double step_hz = mean.rate_hz / (2 * static_cast<double>(mean.power.size() - 1));
  for (const auto& [line_hz, square] : squares) {
    const auto bin = static_cast<std::size_t>(std::lround(line_hz / step_hz));
    const double density = square / 2 / static_cast<double>(mean.windows) / (hann_bins * step_hz);
    if (bin < mean.power.size() && density > least_share * mean.power[bin]) found.push_back(line_hz);
  }
  return found;
}

/// One step of Fisher's scoring up Whittle's likelihood, sum of -ln E - P/E over bins, with what is expected
/// of the tilt beforehand.
Parameters scoring_step(WindowedModel& model, const SlipDensity& mean, const std::vector<std::size_t>& bins,
                        const Parameters& p) {
  constexpr double nudge = 1e-4;
  const auto at = [&](double ln_f, double ln_b) { return model.density(std::exp(ln_f), std::exp(ln_b)); };
  const std::vector<double> here = at(p[0], p[1]), other_f = at(p[0] + nudge, p[1]),
                            other_b = at(p[0], p[1] + nudge);
  const double power = std::exp(p[2]), floor = std::exp(p[3]),
               peak_bin = std::exp(p[0]) / mean.rate_hz * 2 * static_cast<double>(mean.power.size() - 1);
  Eigen::Matrix<double, 5, 5> fisher = Eigen::Matrix<double, 5, 5>::Zero();
  Parameters score = Parameters::Zero();
  for (const std::size_t k : bins) {
    const double off = static_cast<double>(k) / peak_bin - 1, tilted = power * std::exp(p[4] * off),
                 expected = tilted * here[k] + floor;
    Parameters slope;
    slope << tilted * (other_f[k] - here[k]) / nudge, tilted * (other_b[k] - here[k]) / nudge,
        tilted * here[k], floor, tilted * here[k] * off;
    slope /= expected;
    fisher += slope * slope.transpose();
    score += (mean.power[k] / expected - 1) * slope;
  }
  // Windows that overlap by half tell a little less than as many apart.
  const double windows = 0.9 * static_cast<double>(std::max(1L, mean.windows)),
               of_tilt = 1 / (windows * usual_tilt * usual_tilt);
  fisher(4, 4) += of_tilt;
  score[4] -= of_tilt * p[4];
  fisher.diagonal() *= 1 + 1e-9;
  Parameters step = fisher.ldlt().solve(score);
  step = step.cwiseMax(-0.3).cwiseMin(0.3);
  step[0] = std::clamp(step[0], -0.05, 0.05);
  return step;
}

}  // namespace

SlipDensity slip_density(const std::vector<TrialEvidence>& trials, const std::vector<int>& times) {
  SlipDensity mean;
  std::map<double, double> lines;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const TrialEvidence& trial = trials[i];
    if (times[i] == 0 || trial.pieces == 0) continue;
    if (mean.rate_hz > 0 && std::abs(trial.rate_hz / mean.rate_hz - 1) > 0.01) {
      mean.refusal = "trials have different rates";
      return mean;
    }
    if (!mean.power.empty() && trial.power.size() != mean.power.size()) {
      mean.refusal = fmt::format("trials have spectra of {} and of {} frequencies", mean.power.size(),
                                 trial.power.size());
      return mean;
    }
    mean.rate_hz = trial.rate_hz;
    mean.power.resize(trial.power.size(), 0.0);
    for (std::size_t k = 0; k < mean.power.size(); ++k) mean.power[k] += times[i] * trial.power[k];
    const double load_n = std::exp(trial.slip_log_load / static_cast<double>(trial.slip_samples));
    for (const LineLeftIn& line : trial.lines_left_in)
      lines[line.nominal_hz] +=
          static_cast<double>(times[i] * trial.pieces) * std::pow(line.amplitude_n / load_n, 2);
    mean.windows += times[i] * trial.pieces;
    mean.trials += times[i];
  }
  if (mean.trials == 0) mean.refusal = "no slip lasts for a window of its spectrum";
  for (double& power : mean.power) power /= static_cast<double>(mean.windows);
  if (mean.refusal.empty()) mean.lines_hz = standing_lines(mean, lines);
  return mean;
}

VibrationPeak vibration_peak(const SlipDensity& mean, const VibrationPeak* near) {
  VibrationPeak found;
  found.refusal = mean.refusal;
  found.windows = mean.windows;
  found.trials = mean.trials;
  found.rate_hz = mean.rate_hz;
  if (!found.refusal.empty()) return found;
  const std::size_t length = 2 * (mean.power.size() - 1);
  const double step_hz = mean.rate_hz / static_cast<double>(length);
  const auto first = static_cast<std::size_t>(std::ceil(lowest_hz / step_hz)),
             end = static_cast<std::size_t>(0.9 * static_cast<double>(mean.power.size()));
  if (first + 8 > end) {
    found.refusal = "the rate is too low to show a vibration";
    return found;
  }
  std::vector<std::size_t> bins;  // those that are looked at
  for (std::size_t k = first; k < end; ++k)
    if (!is_of_line(mean, step_hz, k)) bins.push_back(k);
  std::vector<double> sorted;
  sorted.reserve(bins.size());
  for (const std::size_t k : bins) sorted.push_back(mean.power[k]);
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2),
                   sorted.end());
  const double middle = sorted[sorted.size() / 2];
  const std::size_t peak = *std::max_element(
      bins.begin(), bins.end(), [&](std::size_t a, std::size_t b) { return mean.power[a] < mean.power[b]; });
  // A density that is highest at the lowest frequency falls with it and has no peak.
  const bool stands_out =
      mean.power[peak] >
      least_height(near != nullptr ? std::numeric_limits<long>::max() : mean.windows) * middle;
  if (!stands_out || (near == nullptr && peak == first)) {
    found.refusal = "no frequency stands out of the spectrum of slip";
    if (!mean.lines_hz.empty()) found.refusal += " elsewhere, and " + line_words(mean.lines_hz.front());
    return found;
  }
  // Around the peak alone: what else moves slowly or fast in slip is not the model's.
  constexpr double reach = 0.6;
  const auto low = std::max(first, static_cast<std::size_t>((1 - reach) * static_cast<double>(peak))),
             high = std::min(end, static_cast<std::size_t>((1 + reach) * static_cast<double>(peak)) + 1);
  found.overlap = near != nullptr && near->overlap.size() == length ? near->overlap : window_overlap(length);
  WindowedModel model(found.overlap, mean.rate_hz);
  const double begin_bandwidth_hz = std::max(4 * step_hz, 10.0);
  Parameters p;
  p << std::log(static_cast<double>(peak) * step_hz), std::log(begin_bandwidth_hz),
      std::log(mean.power[peak] * begin_bandwidth_hz), std::log(middle), 0;
  if (near != nullptr)
    p << std::log(near->frequency_hz), std::log(near->bandwidth_hz), std::log(near->power),
        std::log(near->floor), near->tilt;
  const int passes = near != nullptr ? 4 : 60;
  std::erase_if(bins, [&](std::size_t k) { return k < low || k >= high; });
  for (int pass = 0; pass < passes; ++pass) p += scoring_step(model, mean, bins, p);
  found.frequency_hz = std::exp(p[0]);
  found.bandwidth_hz = std::exp(p[1]);
  found.power = std::exp(p[2]);
  found.floor = std::exp(p[3]);
  found.tilt = p[4];
  const bool is_within = found.frequency_hz > lowest_hz && found.frequency_hz < 0.5 * mean.rate_hz;
  if (!p.allFinite() || !is_within || !(found.bandwidth_hz < 0.5 * mean.rate_hz))
    found.refusal = "the spectrum of slip has no single peak";
  const double near_hz = std::clamp(found.bandwidth_hz / 2, std::min(step_hz, 5.0), 5.0);
  for (const double line_hz : mean.lines_hz)
    if (found.refusal.empty() && std::abs(found.frequency_hz - line_hz) <= near_hz)
      found.refusal = fmt::format("it would be {:.0f} Hz, but {}", found.frequency_hz, line_words(line_hz));
  return found;
}

}  // namespace fingerpad
