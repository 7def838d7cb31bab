#pragma once

#include <string>

namespace fingerpad {

/// Why the system refused a path, in words that tell it apart and name the mend where there is one: which
/// folder is missing, which part of the path is no folder, a link that leads nowhere or back to itself.
/// @param problem  errno
std::string path_words(const std::string& path, int problem);

}  // namespace fingerpad
