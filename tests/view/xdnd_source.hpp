#pragma once

#include <string>

namespace fingerpad::test {

/// Drags a file over the middle of an X window and drops it there, as a file manager does (XDND 5).
/// @returns what went wrong; empty: the window took it
std::string drop_file(const std::string& display, unsigned long window, const std::string& path);

}  // namespace fingerpad::test
