#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/unit_row.hpp"
#include "motion/joined_clocks.hpp"
#include "motion/open_layout.hpp"

namespace fingerpad {

/// What the user calls a column; empty where it was not named.
std::string_view named_column(const RecordingFormat& format, std::string_view key);

/// What the values of a column are, by its key.
Quantity quantity_of(std::string_view key);

/// Columns of one table, in SI; tells the recording the units that the table says.
ClockedValues clocked_columns(const std::string& path, const RecordingFormat& format,
                              const OpenLayout& layout, const std::vector<std::string_view>& wanted,
                              std::string what, FieldRecording& recording);

}  // namespace fingerpad
