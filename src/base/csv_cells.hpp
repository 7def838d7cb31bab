#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace fingerpad {

/// How the cells of a table are written.
struct CsvDialect {
  char separator = ',';  ///< between cells; a blank: any run of blanks and tabs
  char decimal = '.';    ///< of numbers
};

/// As CsvDialect::separator: the mark under which the header names the columns that are asked for.
inline constexpr char found_separator = '\0';

/// A separator as messages name it: "';'", "tabs".
std::string_view separator_words(char separator) noexcept;

/// A text without the blanks around it.
std::string_view trimmed(std::string_view text) noexcept;

/// The cells of a line without the blanks and the quotes around them; a separator between quotes is part of
/// its cell.
std::vector<std::string_view> csv_cells(std::string_view line, char separator);
/// The same, into room that the caller keeps from line to line: tables have millions.
void split_csv(std::string_view line, char separator, std::vector<std::string_view>& cells);

/// The number that a cell spells in full; nothing if anything else stands in it. Digits are not grouped.
std::optional<double> csv_number(std::string_view cell, char decimal) noexcept;

}  // namespace fingerpad
