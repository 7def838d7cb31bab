#pragma once

#include "study/pad_numbers.hpp"

namespace fingerpad {

/// Refuses what came out as no number, or as a size that is none.
void refuse_impossible_numbers(PadValues& found);

}  // namespace fingerpad
