#include "study/hann_line.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unsupported/Eigen/FFT>

#include "study/sample_noise.hpp"

namespace fingerpad {
namespace {

/// What was sensed, less its means over a period of the mains (in samples): what moves slowly is gone, the
/// hum stays.
Points without_slow(const Points& sensed, double period_samples) {
  const Eigen::Index n = sensed.cols();
  const auto half = static_cast<Eigen::Index>(std::lround((period_samples - 1) / 2));
  Points rest = Points::Zero(3, n);
  Vec3 sum = Vec3::Zero();
  for (Eigen::Index i = 0; i < std::min(2 * half, n); ++i) sum += sensed.col(i);
  for (Eigen::Index i = half; i + half < n; ++i) {
    sum += sensed.col(i + half);
    rest.col(i) = sensed.col(i) - sum / static_cast<double>(2 * half + 1);
    sum -= sensed.col(i - half);
  }
  return rest;
}

}  // namespace

HannLine::HannLine(const RecordedTrial& trial, Sensed sensed, double mains_hz)
    : rate_hz_(trial.rate_hz),
      rest_(without_slow(trial.*sensed, trial.rate_hz / mains_hz)),
      weighted_(rest_) {
  constexpr double stands_out = 3;  // of what two thirds of the samples keep within
  const Eigen::Index n = trial.samples();
  Eigen::VectorXd hann(n);
  std::vector<double> sizes(static_cast<std::size_t>(n));
  for (Eigen::Index i = 0; i < n; ++i)
    hann[i] =
        0.5 - 0.5 * std::cos(2 * std::numbers::pi * (static_cast<double>(i) + 0.5) / static_cast<double>(n));
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    for (Eigen::Index i = 0; i < n; ++i) sizes[static_cast<std::size_t>(i)] = std::abs(rest_(axis, i));
    const double most = stands_out * quantile(sizes, 0.667);
    counts_[static_cast<std::size_t>(axis)].reserve(static_cast<std::size_t>(n));
    for (Eigen::Index i = 0; i < n; ++i) {
      const bool counts = trial.origin[static_cast<std::size_t>(i)] == SampleOrigin::recorded &&
                          sizes[static_cast<std::size_t>(i)] <= most;
      counts_[static_cast<std::size_t>(axis)].push_back(counts);
      const double weight = counts ? hann[i] : 0;
      weighted_(axis, i) *= weight;
      sums_[axis] += weight;
    }
  }
}

Phasors HannLine::at(double frequency_hz) const {
  const std::complex<double> turn = std::polar(1.0, -2 * std::numbers::pi * frequency_hz / rate_hz_);
  std::complex<double> phase = 1;
  Phasors sums{};
  for (Eigen::Index i = 0; i < weighted_.cols(); ++i) {
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      sums[static_cast<std::size_t>(axis)] += weighted_(axis, i) * phase;
    phase *= turn;
    if (i % 1024 == 0) phase /= std::abs(phase);
  }
  for (Eigen::Index axis = 0; axis < 3; ++axis) sums[static_cast<std::size_t>(axis)] *= 2 / sums_[axis];
  return sums;
}

/// Sums over blocks of samples, turned back by a frequency: what is near it moves slowly in them.
std::vector<std::complex<double>> HannLine::block_sums(Eigen::Index axis, double at_hz,
                                                       Eigen::Index block) const {
  const std::complex<double> turn = std::polar(1.0, -2 * std::numbers::pi * at_hz / rate_hz_);
  std::complex<double> phase = 1;
  std::vector<std::complex<double>> sums(static_cast<std::size_t>((weighted_.cols() - 1) / block + 1));
  for (Eigen::Index i = 0; i < weighted_.cols(); ++i) {
    sums[static_cast<std::size_t>(i / block)] += weighted_(axis, i) * phase;
    phase *= turn;
    if (i % 1024 == 0) phase /= std::abs(phase);
  }
  return sums;
}

/// The powers of at() over a band, by one transform of block sums: n log n, where asking for each frequency
/// grows with the square of the duration. Blocks of 20 ms take 0.1 % off a line at 0.8 Hz from the first. At
/// least two frequencies for each that the window parts.
HumScan HannLine::scan(double first_hz, double width_hz) const {
  constexpr double block_s = 0.02;
  const Eigen::Index block = std::max<Eigen::Index>(1, static_cast<Eigen::Index>(block_s * rate_hz_));
  std::size_t length = 2;
  while (static_cast<Eigen::Index>(length) * block < 2 * weighted_.cols()) length *= 2;
  HumScan found{first_hz, rate_hz_ / static_cast<double>(static_cast<Eigen::Index>(length) * block), {}};
  found.power.assign(std::min(length, static_cast<std::size_t>(width_hz / found.step_hz) + 1), 0.0);
  Eigen::FFT<double> fft;
  std::vector<std::complex<double>> transform;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    std::vector<std::complex<double>> sums = block_sums(axis, first_hz, block);
    sums.resize(length);
    fft.fwd(transform, sums);
    for (std::size_t k = 0; k < found.power.size(); ++k)
      found.power[k] += std::norm(transform[k] * 2.0 / sums_[axis]);
  }
  return found;
}

}  // namespace fingerpad
