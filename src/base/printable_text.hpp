#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace fingerpad {

/// A text as one line that a terminal or a table's cell can show: control characters, bytes that are no
/// UTF-8, and characters that turn the direction of writing are spelt out (\x1b, \n, \u202e), and what is
/// longer than `longest` bytes is cut. Other text, in whatever language, stays as it is.
std::string printable(std::string_view text, std::size_t longest = 4000);

/// A text of at most `most` characters: of a longer one the middle is left out, "plate...0003 45%", since
/// what tells names apart stands at their ends.
/// @pre most >= 8
std::string middle_left_out(std::string_view text, std::size_t most);

/// Whether a text is UTF-8 throughout.
bool is_utf8(std::string_view text) noexcept;

}  // namespace fingerpad
