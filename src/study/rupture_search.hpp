#pragma once

#include "study/stick_segments.hpp"

namespace fingerpad {

/// Ratio of the noise of q to friction above which ruptures cannot be seen, not even between means of
/// samples.
inline constexpr double most_noise_share = 2.0 * 0.15 / 4.5 / 1.414;

/// Standard deviation of q at a sample. The sensor's noise is one of forces: the lighter the press, the more
/// of it is in the ratio.
double ratio_noise_at(const MeasuredTrial& trial, const StickSegments& segments, std::size_t i);

/// The least drop of the ratio that is seen as a rupture.
double least_drop(double noise, double friction);

/// Friction of samples that are pressed, near its greatest.
double most_friction(const MeasuredTrial& trial, double least_n);

/// Finds where the force ratio drops, and parts the runs there (StickSegments::is_rupture, begins_run,
/// usual_normal_n). Some may be the slip's vibration.
/// @pre  half_window and ratio_noise are known
void find_ruptures(const MeasuredTrial& trial, StickSegments& found);

/// Whether the ratio was surely greater within the same tooth and under about the same load than where it
/// drops before sample i: stick gives way where it is pulled most. A spring that is pushed back through its
/// middle drops so too, and so does one in a thousand samples' noise, which a filter of the force joins
/// together.
/// @param from  the tooth's first sample
bool drops_below_its_tooth(const MeasuredTrial& trial, const StickSegments& segments, std::size_t from,
                           std::size_t i);

}  // namespace fingerpad
