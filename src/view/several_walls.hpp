#pragma once

#include <algorithm>
#include <span>
#include <string_view>

#include "touch/tick_record.hpp"

namespace fingerpad {

/// What a normal force that is drawn over time is, of ticks that several walls hold.
inline constexpr std::string_view several_walls_words =
    "where several walls hold the finger, its normal force is all of theirs added up, no resultant";

inline bool any_held_by_several_walls(std::span<const TickRecord> rows) {
  return std::ranges::any_of(rows, [](const TickRecord& row) { return row.walls > 1; });
}

}  // namespace fingerpad
