#pragma once

#include <string_view>

namespace fingerpad {

/// What a trace of this program is taken for where a measurement is asked for.
inline constexpr std::string_view own_trace_words =
    "is a trace of this program, and is taken for a recording of its finger on a flat plate: the forces are "
    "a model's, and no fit of them tells of a finger";

}  // namespace fingerpad
