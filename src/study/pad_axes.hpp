#pragma once

#include "study/measurement.hpp"

namespace fingerpad {

/// A contact of fewer samples tells nothing.
inline constexpr std::size_t fewest_touching_samples = 16;

/// The samples of a trial with contact, in the pad's axes.
MeasuredTrial in_pad_axes(const RecordedTrial& trial);

}  // namespace fingerpad
