#pragma once

#include <string>
#include <vector>

namespace fingerpad {

/// Throws Error (usage) where what is taken for an input is a column's name: `--columns fn_n mu` is two words
/// to the shell.
/// @param columns  that were asked for; nothing is looked at without any
void refuse_columns_as_inputs(const std::vector<std::string>& inputs, const std::string& columns);

}  // namespace fingerpad
