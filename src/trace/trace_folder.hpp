#pragma once

#include <string>
#include <string_view>

namespace fingerpad {

/// Throws Error (refused) where a folder is named in place of a trace, with the first of the traces in it.
/// @param wanted  what could be named there
void refuse_trace_folder(const std::string& path, std::string_view wanted = "a trace");

}  // namespace fingerpad
