#pragma once

#include <array>
#include <cstddef>

#include "trace/trace.hpp"

namespace fingerpad {

inline constexpr std::size_t trace_column_count = 26;

/// A row as numbers in column order; phase, part and triangle as whole numbers.
using TraceRow = std::array<double, trace_column_count>;

/// Columns that are no plain numbers, by their place.
inline constexpr std::size_t phase_column = 4, part_column = 24, triangle_column = 25;

TraceRow to_row(const TickRecord& record) noexcept;

/// What is wrong with numbers that should be a row (a phase that is none, a time or a position that is not
/// finite); empty if nothing.
std::string_view row_damage(const TraceRow& row) noexcept;

/// @pre row_damage(row) is empty
TickRecord to_record(const TraceRow& row) noexcept;

}  // namespace fingerpad
