#pragma once

#include <string>

#include "base/error.hpp"

namespace fingerpad {

/// Why the system refused a path, in words that tell it apart and name the mend where there is one: which
/// folder is missing, which part of the path is no folder, a link that leads nowhere or back to itself.
/// @param problem  errno
std::string path_words(const std::string& path, int problem);

/// As path_words(), of a path that is to be a folder.
std::string folder_words(const std::string& path, int problem);

enum class Made { file, folder };

/// The same of what was to be made by that name; a folder with those that lead to it. The system may make
/// nothing new in a folder that is there (/proc).
/// @param problem  errno
std::string unmade_words(const std::string& path, int problem, Made made);

/// Whose fault it is that an output cannot be made there: usage where the caller's name leads to no place for
/// it, else the program's (a full disk, no memory).
/// @param problem  errno
ErrorKind output_fault(int problem) noexcept;

}  // namespace fingerpad
