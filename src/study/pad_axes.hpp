#pragma once

#include "study/measurement.hpp"

namespace fingerpad {

/// Samples that press with less are no contact [N]: a sensor's offset would be most of the ratio of forces.
inline constexpr double least_normal_force_n = 0.05;

/// A contact of fewer samples tells nothing.
inline constexpr std::size_t fewest_touching_samples = 16;

/// The samples of a trial with contact, in the pad's axes.
MeasuredTrial in_pad_axes(const RecordedTrial& trial);

}  // namespace fingerpad
