#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fingerpad {

/// One-sided power spectral density. The sum over density times the spacing of frequencies is the variance.
struct Spectrum {
  std::vector<double> frequency_hz;
  std::vector<double> density;  ///< [signal unit squared / Hz]
};

/// Welch's estimate (Welch 1967): Hann windows that overlap by half, each without its mean.
/// @param rate_hz  of the samples, > 0
/// @returns empty for fewer than 32 samples
Spectrum welch_spectrum(std::span<const double> samples, double rate_hz);

/// As above with windows of `length` samples.
/// @pre length is even, at least 2 and at most the samples
Spectrum welch_spectrum(std::span<const double> samples, double rate_hz, std::size_t length);

}  // namespace fingerpad
