#include "base/csv_row_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <utility>

#include "base/csv_header.hpp"
#include "base/error.hpp"
#include "base/printable_text.hpp"

namespace fingerpad {
namespace {

using Wanted = CsvRowReader::Wanted;

/// One row of a table.
struct Row {
  const TextLines& lines;  ///< that it is the last read of
  const std::vector<std::string_view>& cells;
  std::string_view decimal_key;  ///< CsvRequest's
};

/// How the caller's user would say a decimal mark.
std::string said_decimal(std::string_view decimal_key, char mark) {
  return fmt::format(fmt::runtime(decimal_key), mark);
}

/// Whether all cells are numbers, without a decimal point in any.
bool hold_no_point(const std::vector<std::string_view>& cells) {
  return std::all_of(cells.begin(), cells.end(), [](std::string_view cell) {
    return cell.empty() || (csv_number(cell, '.') && cell.find('.') == std::string_view::npos);
  });
}

/// A row of more cells than the header names is some other row: a form feed that ends rows, a comma that is
/// a decimal mark. Blank ones at its end are a trailing separator.
void refuse_extra_cells(const Row& row, std::size_t header_cells, char separator) {
  for (std::size_t i = header_cells; i < row.cells.size(); ++i) {
    if (row.cells[i].empty()) continue;
    std::string mend;
    if (separator == ',' && hold_no_point(row.cells)) {
      mend =
          ": are its commas decimal marks, too? Those cannot be told from commas between cells: write "
          "decimal points";
      if (!row.decimal_key.empty())
        mend += ", or part the cells by ; and say " + said_decimal(row.decimal_key, ',');
    }
    throw refused(row.lines.place(),
                  fmt::format("has {} cells, but the header has {}{}", row.cells.size(), header_cells, mend));
  }
}

/// A cell in which nothing was recorded.
bool is_gap(std::string_view cell) {
  return cell.empty() || cell == "nan" || cell == "NaN" || cell == "NAN" || cell == "NA";
}

/// A dash, a one or nothing stands below a column without a unit.
bool is_without_unit(std::string_view cell) {
  return cell.empty() || cell == "-" || cell == "1";
}

/// "mm", "[N]", "m s^-1"; no number, and nothing that begins as one.
bool is_word(std::string_view cell, char decimal) {
  return !is_gap(cell) && !csv_number(cell, '.') && !csv_number(cell, decimal) &&
         std::string_view("0123456789+-.,").find(cell.front()) == std::string_view::npos;
}

/// A row of words below the header says in what its columns are measured. One that is too short counts here.
bool is_row_of_units(const std::vector<std::string_view>& cells, const std::vector<Wanted>& wanted,
                     char decimal) {
  std::size_t words = 0;
  for (const Wanted& column : wanted) {
    if (column.cell >= cells.size() || is_without_unit(cells[column.cell])) continue;
    if (!is_word(cells[column.cell], decimal)) return false;
    ++words;
  }
  return words >= 2;
}

/// "mm" of "[mm]", "(mm)" and "in mm".
std::string bare_unit(std::string_view word) {
  if (word.size() > 2 &&
      ((word.front() == '[' && word.back() == ']') || (word.front() == '(' && word.back() == ')')))
    word = word.substr(1, word.size() - 2);
  if (word.starts_with("in ")) word.remove_prefix(3);
  return std::string(trimmed(word));
}

/// Words that stand below other columns than their own say nothing.
void refuse_uneven_units(const Row& row, const std::vector<Wanted>& wanted, std::size_t header_cells) {
  bool is_even = true;
  for (std::size_t i = header_cells; i < row.cells.size(); ++i) is_even = is_even && row.cells[i].empty();
  for (const Wanted& column : wanted) is_even = is_even && column.cell < row.cells.size();
  if (is_even) return;
  throw refused(row.lines.place(),
                fmt::format("looks like a row of units, with {} cells where the header has {}: give each "
                            "column its unit, - where it has none, or put # before the line",
                            row.cells.size(), header_cells));
}

/// @param has_units  a row of units stands above it
void refuse_units(const Row& row, const std::vector<Wanted>& wanted, bool has_units) {
  throw refused(
      row.lines.place(),
      fmt::format("is {} line of words ('{}' in column '{}'){}", has_units ? "one more" : "a second",
                  printable(row.cells[wanted.front().cell], 40), wanted.front().name,
                  has_units ? ", below that of the units: put # before it"
                            : ", and a row of units is not read here: put # before it, and see that "
                              "the columns are in the units that are asked for"));
}

/// A row of fewer cells than one before may have been cut within its last, whose number is then another.
void refuse_short_row(const Row& row, const std::vector<Wanted>& wanted, std::size_t most_cells) {
  const std::size_t cells = row.cells.size();
  const auto last = std::ranges::find(wanted, cells - 1, &Wanted::cell);
  if (cells >= most_cells || last == wanted.end() || row.cells.back().empty()) return;
  throw refused(row.lines.place(),
                fmt::format("has {} cells, where rows above have {}, and the number in its last, of column "
                            "'{}', may be cut: leave the row out, or fill it",
                            cells, most_cells, printable(last->name, 60)));
}

/// "4,000" and "-12,345,678" with a comma: there may be no decimal mark in it.
bool parts_thousands(std::string_view cell, char mark) {
  if (cell.starts_with('-') || cell.starts_with('+')) cell.remove_prefix(1);
  const std::size_t first = cell.find(mark);
  if (first == 0 || first > 3 || cell.front() == '0') return false;
  for (std::size_t at = first; at < cell.size(); at += 4) {
    if (cell[at] != mark || cell.size() - at < 4) return false;
    for (std::size_t k = 1; k < 4; ++k)
      if (std::isdigit(static_cast<unsigned char>(cell[at + k])) == 0) return false;
  }
  return true;
}

/// What would mend a cell that is no number; empty where nothing is known.
std::string mend_of(std::string_view cell, char decimal, std::string_view decimal_key) {
  if (cell.find(':') != std::string_view::npos)
    return "; a time of day is not read: write seconds, from wherever you like";
  const char other = decimal == '.' ? ',' : '.';
  if (parts_thousands(cell, other))
    return fmt::format("; if {} parts thousands in it, take it out of all cells", other) +
           (decimal_key.empty()
                ? ""
                : fmt::format("; only if it is a decimal mark, say {}", said_decimal(decimal_key, other)));
  if (csv_number(cell, other))
    return decimal_key.empty() ? fmt::format("; its decimal mark must be {}", decimal)
                               : fmt::format("; with {} it would be one", said_decimal(decimal_key, other));
  const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  const auto end = std::find_if_not(cell.rbegin(), cell.rend(), is_letter).base();
  const std::string_view number = trimmed(cell.substr(0, static_cast<std::size_t>(end - cell.begin())));
  if (end == cell.end() || !csv_number(number, decimal)) return {};
  return fmt::format("; leave '{}' out: cells hold numbers alone",
                     printable(cell.substr(static_cast<std::size_t>(end - cell.begin())), 20));
}

/// Where a row is refused that a write may have left unfinished.
std::string cut_words(const Row& row) {
  return row.lines.ended()
             ? ""
             : "; it is the last line and has no line end, as where a file was cut off: leave the "
               "line out";
}

double number_in(const Row& row, const Wanted& column, char decimal, bool takes_gaps) {
  if (column.cell >= row.cells.size()) {
    throw refused(row.lines.place(),
                  fmt::format("has {} cells, but column '{}' is number {}{}", row.cells.size(), column.name,
                              column.cell + 1, cut_words(row)));
  }
  const std::string_view cell = row.cells[column.cell];
  if (takes_gaps && is_gap(cell)) return std::numeric_limits<double>::quiet_NaN();
  if (is_gap(cell))
    throw refused(
        row.lines.place(),
        fmt::format("holds nothing in column '{}' ('{}'), and what lay there is not guessed: leave such "
                    "rows out, or fill them{}",
                    printable(column.name, 60), printable(cell, 40), cut_words(row)));
  const auto value = csv_number(cell, decimal);
  if (!value) {
    throw refused(row.lines.place(), fmt::format("'{}' in column '{}' is no number{}{}", printable(cell, 40),
                                                 printable(column.name, 60),
                                                 mend_of(cell, decimal, row.decimal_key), cut_words(row)));
  }
  if (!std::isfinite(*value))
    throw refused(row.lines.place(), fmt::format("column '{}' is not finite", printable(column.name, 60)));
  return *value;
}

}  // namespace

CsvRowReader::CsvRowReader(const std::string& path, const CsvRequest& request)
    : lines_(path, {"a table", std::uint64_t{2} << 30, request.source == TableSource::file_or_stream}),
      decimal_(request.dialect.decimal),
      decimal_key_(request.decimal_key),
      takes_gaps_(request.takes_gaps),
      leaves_out_cut_row_(request.leaves_out_cut_row) {
  const CsvHeader header = read_csv_header(lines_, request);
  if (leaves_out_cut_row_ && !header.has_end && header.first_row.empty())
    throw refused(lines_.where(),
                  fmt::format("ends within its header (line {}): no row of it is left; make it again",
                              lines_.number()));
  separator_ = header.separator;
  first_row_ = header.first_row;
  above_ = header.above;
  header_cells_ = csv_cells(header.line, header.separator).size();
  std::vector<std::string_view> names = request.required;
  names.insert(names.end(), request.optional.begin(), request.optional.end());
  for (std::size_t k = 0; k < names.size(); ++k) {
    const auto cell = csv_column(header.line, names[k], header.place, header.separator, request.mark_mend);
    present_.push_back(cell.has_value());
    if (!cell && k < request.required.size()) throw missing_column(header, names[k], request);
    if (cell) wanted_.push_back({std::string(names[k]), *cell, k});
  }
  for (const std::string_view cell : csv_cells(header.line, header.separator)) {
    names_.emplace_back(cell);
    if (!cell.empty() && std::find(names.begin(), names.end(), cell) == names.end())
      unread_.push_back(printable(cell, 60));
  }
  numbers_.resize(names.size());
  if (request.takes_units) take_units();
}

/// The next line that counts.
bool CsvRowReader::next_line(std::string_view& line) {
  while (lines_.next(line))
    if (!is_passed_over(line)) return true;
  return false;
}

void CsvRowReader::take_units() {
  std::string_view line;
  if (!first_row_.empty() || !next_line(line)) return;  // what was read before is a row of numbers
  split_csv(line, separator_, cells_);
  if (!is_row_of_units(cells_, wanted_, decimal_)) {
    first_row_ = line;
    return;
  }
  refuse_uneven_units({lines_, cells_, decimal_key_}, wanted_, header_cells_);
  units_.words.resize(numbers_.size());
  for (const Wanted& column : wanted_) units_.words[column.index] = bare_unit(cells_[column.cell]);
  units_.place = lines_.place();
}

void CsvRowReader::take(std::string_view line) {
  split_csv(line, separator_, cells_);
  const Row row{lines_, cells_, decimal_key_};
  if (rows_ == 0 && wanted_.front().cell < cells_.size() && is_row_of_units(cells_, wanted_, decimal_))
    refuse_units(row, wanted_, !units_.place.empty());
  refuse_extra_cells(row, header_cells_, separator_);
  for (const Wanted& column : wanted_) numbers_[column.index] = number_in(row, column, decimal_, takes_gaps_);
  refuse_short_row(row, wanted_, most_cells_);
  most_cells_ = std::max(most_cells_, std::min(cells_.size(), header_cells_));
  ++rows_;
}

bool CsvRowReader::next() {
  constexpr std::size_t most_rows = 50'000'000;
  const std::string first = std::exchange(first_row_, {});  // the last that was read, if any
  std::string_view line = first;
  if (first.empty() && !next_line(line)) return false;
  if (leaves_out_cut_row_ && !lines_.ended()) {
    cut_ = fmt::format("ends within a row (line {}), which is left out: its last number may lack digits",
                       lines_.number());
    return false;
  }
  if (rows_ == most_rows)
    throw refused(lines_.place(), fmt::format("more than {} rows are not read", most_rows));
  take(line);
  return true;
}

}  // namespace fingerpad
