#pragma once

#include <string_view>
#include <vector>

namespace fingerpad {

/// What csv_cells() gives, into room that the caller keeps from line to line: tables have millions.
void split_csv(std::string_view line, char separator, std::vector<std::string_view>& cells);

}  // namespace fingerpad
