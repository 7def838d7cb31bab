#pragma once

#include <string>
#include <string_view>

namespace fingerpad {

/// A word as a CSV cell: printable, and quoted where it must be (RFC 4180).
std::string csv_cell(std::string_view words);

}  // namespace fingerpad
