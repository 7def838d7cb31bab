#pragma once

#include <string>

namespace fingerpad::test {

/// Asks an X window to close, as the button of its frame does (WM_DELETE_WINDOW).
/// @returns what went wrong; empty: it was asked
std::string ask_to_close(const std::string& display, unsigned long window);

}  // namespace fingerpad::test
