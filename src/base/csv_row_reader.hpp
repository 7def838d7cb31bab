#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/csv_columns.hpp"
#include "base/text_lines.hpp"

namespace fingerpad {

/// The rows of a table one at a time, for tables that are too large to be held: what read_csv_columns holds.
class CsvRowReader {
 public:
  /// A column that is asked for and there: its cell, and its place among the names asked for.
  struct Wanted {
    std::string name;
    std::size_t cell, index;
  };

  /// Reads the header. Throws Error as read_csv_columns.
  CsvRowReader(const std::string& path, const CsvRequest& request);

  /// Goes on to the next row; false after the last. Throws Error (refused, `file:line`) as read_csv_columns.
  bool next();

  const std::vector<bool>& present() const noexcept { return present_; }         ///< per asked-for name
  double number(std::size_t column) const noexcept { return numbers_[column]; }  ///< of this row
  long line() const noexcept { return lines_.number(); }                         ///< of this row, from 1
  std::string place() const { return lines_.place(); }                           ///< "table.csv:12"
  char separator() const noexcept { return separator_; }
  const UnitRow& units() const noexcept { return units_; }
  const std::string& cut() const noexcept { return cut_; }      ///< CsvColumns::cut, after the last row
  const std::string& above() const noexcept { return above_; }  ///< CsvColumns::above
  const std::vector<std::string>& names() const noexcept { return names_; }  ///< CsvColumns::names
  /// What the header names that is not asked for, for people.
  const std::vector<std::string>& unread() const noexcept { return unread_; }

 private:
  bool next_line(std::string_view& line);
  void take(std::string_view line);
  void take_units();

  TextLines lines_;
  char decimal_;
  std::string_view decimal_key_;
  bool takes_gaps_, leaves_out_cut_row_;
  std::string cut_, above_;
  char separator_ = ',';
  std::string first_row_;  // that was read to look at it
  UnitRow units_;
  std::size_t header_cells_ = 0, rows_ = 0;
  std::size_t most_cells_ = 0;  // of a row so far
  std::vector<Wanted> wanted_;
  std::vector<bool> present_;
  std::vector<std::string> names_, unread_;
  std::vector<std::string_view> cells_;  // of the row under way
  std::vector<double> numbers_;
};

}  // namespace fingerpad
