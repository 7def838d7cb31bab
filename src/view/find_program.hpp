#pragma once

#include <string>

namespace fingerpad {

/// The first program of this name in PATH; empty if there is none.
std::string find_program(const std::string& name);

}  // namespace fingerpad
