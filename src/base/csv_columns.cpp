#include "base/csv_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/csv_header.hpp"
#include "base/error.hpp"
#include "base/printable_text.hpp"

namespace fingerpad {
namespace {

/// A column that is asked for, where it is there.
struct Wanted {
  std::string_view name;
  std::size_t cell;
};

/// One row of a table.
struct Row {
  const TextLines& lines;  ///< that it is the last read of
  std::vector<std::string_view> cells;
};

/// A row of more cells than the header names is some other row: a form feed that ends rows, a comma that is
/// a decimal mark. Blank ones at its end are a trailing separator.
void refuse_extra_cells(const Row& row, std::size_t header_cells) {
  for (std::size_t i = header_cells; i < row.cells.size(); ++i) {
    if (row.cells[i].empty()) continue;
    throw refused(row.lines.place(),
                  fmt::format("has {} cells, but the header has {}", row.cells.size(), header_cells));
  }
}

/// A row of words below the header says in what its columns are measured.
void refuse_units(const Row& row, const std::vector<Wanted>& wanted, char decimal) {
  const bool are_words = std::all_of(wanted.begin(), wanted.end(), [&](const Wanted& column) {
    return column.cell < row.cells.size() && !row.cells[column.cell].empty() &&
           !csv_number(row.cells[column.cell], '.') && !csv_number(row.cells[column.cell], decimal) &&
           row.cells[column.cell].find_first_of("0123456789") == std::string_view::npos;
  });
  if (!are_words || wanted.size() < 2) return;
  throw refused(row.lines.place(),
                fmt::format("is a second line of words ('{}' in column '{}'), and a row of units "
                            "is not read: put # before it, and say the units in the scene",
                            printable(row.cells[wanted.front().cell], 40), wanted.front().name));
}

double number_in(const Row& row, const Wanted& column, char decimal) {
  if (column.cell >= row.cells.size()) {
    throw refused(row.lines.place(), fmt::format("has {} cells, but column '{}' is number {}",
                                                 row.cells.size(), column.name, column.cell + 1));
  }
  const std::string_view cell = row.cells[column.cell];
  const auto value = csv_number(cell, decimal);
  if (!value) {
    const char other = decimal == '.' ? ',' : '.';
    throw refused(
        row.lines.place(),
        fmt::format(
            "'{}' in column '{}' is no number{}", printable(cell, 40), printable(column.name, 60),
            csv_number(cell, other) ? fmt::format("; with decimal = \"{}\" it would be one", other) : ""));
  }
  if (!std::isfinite(*value))
    throw refused(row.lines.place(), fmt::format("column '{}' is not finite", printable(column.name, 60)));
  return *value;
}

}  // namespace

std::optional<std::size_t> csv_column(std::string_view header, std::string_view name,
                                      const std::string& place, char separator) {
  std::optional<std::size_t> found;
  const auto cells = csv_cells(header, separator);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i] != name) continue;
    if (found) {
      throw refused(place, fmt::format("names the column '{}' twice, in cells {} and {}: leave one of them",
                                       printable(name, 60), *found + 1, i + 1));
    }
    found = i;
  }
  if (found) return found;
  for (const char mark : {',', ';', '\t', '|'}) {
    const auto others = csv_cells(header, mark);
    if (mark == separator || std::find(others.begin(), others.end(), name) == others.end()) continue;
    if (separator != ',')
      throw refused(place, fmt::format("its cells are parted by {}, not by {}", separator_words(mark),
                                       separator_words(separator)));
    throw refused(place, fmt::format("its cells are parted by {}, but those of CSV by ',': save it with "
                                     "commas, and numbers with decimal points",
                                     separator_words(mark)));
  }
  return std::nullopt;
}

CsvColumns read_csv_columns(const std::string& path, const CsvRequest& request) {
  constexpr std::size_t most_rows = 50'000'000;
  TextLines lines(path, {"a table", std::uint64_t{2} << 30, request.source == TableSource::file_or_stream});
  const CsvHeader header = read_csv_header(lines, request);

  CsvColumns table;
  table.separator = header.separator;
  std::vector<Wanted> wanted;
  std::vector<std::size_t> into;
  std::vector<std::string_view> names = request.required;
  names.insert(names.end(), request.optional.begin(), request.optional.end());
  for (std::size_t k = 0; k < names.size(); ++k) {
    const auto cell = csv_column(header.line, names[k], header.place, header.separator);
    table.present.push_back(cell.has_value());
    if (!cell && k < request.required.size()) throw missing_column(header, names[k], request);
    if (!cell) continue;
    wanted.push_back({names[k], *cell});
    into.push_back(k);
  }
  table.columns.resize(names.size());
  const std::size_t header_cells = csv_cells(header.line, header.separator).size();
  const auto take = [&](std::string_view line) {
    const Row row{lines, csv_cells(line, header.separator)};
    if (table.lines.empty()) refuse_units(row, wanted, request.dialect.decimal);
    refuse_extra_cells(row, header_cells);
    for (std::size_t k = 0; k < wanted.size(); ++k)
      table.columns[into[k]].push_back(number_in(row, wanted[k], request.dialect.decimal));
    table.lines.push_back(lines.number());
  };
  if (!header.first_row.empty()) take(header.first_row);
  for (std::string_view line; lines.next(line);) {
    if (is_passed_over(line)) continue;
    if (table.lines.size() == most_rows) {
      throw refused(lines.place(), fmt::format("more than {} rows are not read", most_rows));
    }
    take(line);
  }
  return table;
}

CsvColumns read_csv_columns(const std::string& path, const std::vector<std::string_view>& required,
                            const std::vector<std::string_view>& optional, TableSource source) {
  return read_csv_columns(path, {required, optional, {}, source, {}});
}

}  // namespace fingerpad
