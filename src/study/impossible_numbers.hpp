#pragma once

#include "study/pad_numbers.hpp"

namespace fingerpad {

/// Refuses what came out as no number, or as a size that is none, in words that are always the same: those of
/// a bootstrap's draws nobody reads.
void refuse_impossible_numbers(PadValues& found);

/// Says of what was refused so which number it is, and what it came to.
void tell_impossible_numbers(PadValues& found);

}  // namespace fingerpad
