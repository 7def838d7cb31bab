#pragma once

#include <string_view>

#include "scene/toml_table.hpp"

namespace fingerpad {

/// What the number of a scene key may be: wide enough for every finger, part and device there is, and narrow
/// enough that nothing which a tick computes from such numbers leaves what a double can hold.
/// @param dotted_key  as in a set, "hand.mass_kg"; a plane's keys are those of a part
/// @pre the table has a row for it
NumberRange key_range(std::string_view dotted_key) noexcept;

/// The range of a number of [friction] that a law has named its own limits for.
/// @param above_min  must be larger than min
NumberRange law_range(double min, bool above_min, double max) noexcept;

}  // namespace fingerpad
