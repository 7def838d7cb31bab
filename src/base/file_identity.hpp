#pragma once

#include <optional>
#include <string>
#include <vector>

namespace fingerpad {

/// What tells one file from another, whatever the path: its device and number, symbolic links followed, hard
/// links alike. Nothing where no regular file is.
std::optional<std::string> file_identity(const std::string& path);

/// Throws Error (refused) if writing `out` would overwrite one of the inputs, by whatever path or link. A
/// file is written as `out`.part first, so that this must be none of them either.
void refuse_overwriting(const std::string& out, const std::vector<std::string>& inputs);

}  // namespace fingerpad
