#pragma once

#include <string>

namespace fingerpad {

/// Throws Error (usage) where a file cannot be written by that name: it is empty, a folder stands there, its
/// own folder is missing, forbidden or none. Asked before long work, so that its result is not lost at the
/// end. Writes and opens nothing. A `-` is standard output, and a pipe or a device is for the writing itself
/// to try.
void refuse_unwritable(const std::string& path);

}  // namespace fingerpad
