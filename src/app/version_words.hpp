#pragma once

#include <string>

namespace fingerpad {

/// "fingerpad 0.1.0", and a line for each library that it works with.
std::string version_words();

}  // namespace fingerpad
