#pragma once

#include <string>

#include "base/csv_columns.hpp"
#include "base/error.hpp"
#include "base/text_lines.hpp"

namespace fingerpad {

/// The line of a table that names its columns, and what had to be read to find it.
struct CsvHeader {
  std::string line;
  std::string place;  ///< "table.csv:1"
  char separator = ',';
  std::string first_row;  ///< a row that was read too, the last line of `lines`; empty: none
  std::string above;      ///< CsvColumns::above
  bool has_end = true;    ///< its line, and not the file's last that just stops
};

/// Whether a line is one that no table counts: blank, or a comment.
bool is_passed_over(std::string_view line) noexcept;

/// Reads up to a table's header, see read_csv_columns.
CsvHeader read_csv_header(TextLines& lines, const CsvRequest& request);

/// What is said where a table lacks a required column.
Error missing_column(const CsvHeader& header, std::string_view name, const CsvRequest& request);

}  // namespace fingerpad
