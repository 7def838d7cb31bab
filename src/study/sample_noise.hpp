#pragma once

#include <span>

namespace fingerpad {

/// Standard deviation of white noise on evenly sampled numbers, from their second differences: the variance
/// of those is six times its. What moves smoothly cancels in them; those beyond four deviations are events,
/// and are left out.
double sample_noise(std::span<const double> samples);

/// How many times as much noise every other sample shows as all of them do: 1 of white noise, more of noise
/// that a low pass has joined from sample to sample.
double joined_noise(std::span<const double> samples);

/// sample_noise of the sizes of second differences that were taken elsewhere, as within stretches alone.
double noise_of_bends(std::span<const double> bends);

/// The value below which a share of the samples lies.
/// @pre samples are not empty; 0 <= share <= 1
double quantile(std::span<const double> samples, double share);

/// The one in the middle; 0 of none.
double median_of(std::span<const double> samples);

}  // namespace fingerpad
