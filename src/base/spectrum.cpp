#include "base/spectrum.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>

namespace fingerpad {
namespace {

/// A power of two: of a long record 32 windows or so, which overlap, so that a peak stands where it is; of a
/// short one eight, which still tell frequencies apart.
std::size_t window_length(std::size_t samples) {
  constexpr std::size_t fine = 1024, longest = 4096;
  std::size_t length = 32;
  while (length < longest && length * 2 <= samples / (length < fine ? 4 : 16)) length *= 2;
  return length;
}

}  // namespace

Spectrum welch_spectrum(std::span<const double> samples, double rate_hz) {
  if (samples.size() < 32) return {};
  return welch_spectrum(samples, rate_hz, window_length(samples.size()));
}

Spectrum welch_spectrum(std::span<const double> samples, double rate_hz, std::size_t length) {
  Spectrum spectrum;
  std::vector<double> window(length), piece(length);
  double window_power = 0;
  for (std::size_t i = 0; i < length; ++i) {
    const double phase = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(length);
    window[i] = 0.5 - 0.5 * std::cos(phase);
    window_power += window[i] * window[i];
  }

  Eigen::FFT<double> fft;
  std::vector<std::complex<double>> transform;
  std::vector<double> power(length / 2 + 1, 0.0);
  double pieces = 0;
  for (std::size_t start = 0; start + length <= samples.size(); start += length / 2) {
    double mean = 0;
    for (std::size_t i = 0; i < length; ++i) mean += samples[start + i] / static_cast<double>(length);
    for (std::size_t i = 0; i < length; ++i) piece[i] = window[i] * (samples[start + i] - mean);
    fft.fwd(transform, piece);
    for (std::size_t k = 0; k < power.size(); ++k) power[k] += std::norm(transform[k]);
    ++pieces;
  }

  for (std::size_t k = 0; k < power.size(); ++k) {
    const double sides = k == 0 || k == length / 2 ? 1 : 2;
    spectrum.frequency_hz.push_back(static_cast<double>(k) * rate_hz / static_cast<double>(length));
    spectrum.density.push_back(sides * power[k] / (pieces * rate_hz * window_power));
  }
  return spectrum;
}

}  // namespace fingerpad
