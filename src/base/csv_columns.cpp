#include "base/csv_columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <optional>

#include "base/error.hpp"
#include "base/number_text.hpp"
#include "base/printable_text.hpp"
#include "base/text_lines.hpp"

namespace fingerpad {
namespace {

std::vector<std::string_view> cells_of(std::string_view line, char separator = ',') {
  std::vector<std::string_view> cells;
  while (true) {
    const std::size_t end = line.find(separator);
    cells.push_back(line.substr(0, end));
    if (end == std::string_view::npos) return cells;
    line.remove_prefix(end + 1);
  }
}

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

/// A row of more cells than the header names is some other row: a form feed that ends rows, a comma within
/// quotes. Blank ones at its end are a trailing comma.
void refuse_extra_cells(const TextLines& lines, const std::vector<std::string_view>& cells,
                        std::size_t header_cells) {
  for (std::size_t i = header_cells; i < cells.size(); ++i) {
    if (trimmed(cells[i]).empty()) continue;
    throw refused(lines.place(),
                  fmt::format("has {} cells, but the header has {}", cells.size(), header_cells));
  }
}

double number_in(const TextLines& lines, const std::vector<std::string_view>& cells, std::size_t column,
                 std::string_view name) {
  if (column >= cells.size()) {
    throw refused(lines.place(),
                  fmt::format("has {} cells, but column '{}' is number {}", cells.size(), name, column + 1));
  }
  const auto value = parse_number(cells[column]);
  if (!value)
    throw refused(lines.place(), fmt::format("'{}' in column '{}' is no number",
                                             printable(trimmed(cells[column]), 40), name));
  if (!std::isfinite(*value)) throw refused(lines.place(), fmt::format("column '{}' is not finite", name));
  return *value;
}

/// The first line that is not blank: the header's cells. The line must outlive them.
std::vector<std::string_view> header_of(TextLines& lines, std::string& line) {
  std::string_view text;
  while (lines.next(text)) {
    if (trimmed(text).empty()) continue;
    if (text.find('\0') != std::string_view::npos) {
      throw refused(lines.where(), "is no text: it holds a zero byte");
    }
    line = std::string(text);
    return cells_of(line);
  }
  throw refused(lines.where(), "is empty");
}

}  // namespace

std::optional<std::size_t> csv_column(std::string_view header, std::string_view name,
                                      const std::string& place) {
  std::optional<std::size_t> found;
  const auto cells = cells_of(header);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (trimmed(cells[i]) != name) continue;
    if (found) {
      throw refused(place, fmt::format("names the column '{}' twice, in cells {} and {}: leave one of them",
                                       name, *found + 1, i + 1));
    }
    found = i;
  }
  if (found) return found;
  for (const char separator : {';', '\t', '|'}) {
    for (const std::string_view cell : cells_of(header, separator)) {
      if (trimmed(cell) != name) continue;
      throw refused(place, fmt::format("its cells are parted by {}, but those of CSV by ',': save it with "
                                       "commas, and numbers with decimal points",
                                       separator == '\t' ? "tabs" : fmt::format("'{}'", separator)));
    }
  }
  return std::nullopt;
}

CsvColumns read_csv_columns(const std::string& path, const std::vector<std::string_view>& required,
                            const std::vector<std::string_view>& optional, TableSource source) {
  constexpr std::size_t most_rows = 50'000'000;
  TextLines lines(path, {"a table", std::uint64_t{2} << 30, source == TableSource::file_or_stream});
  std::string header_line;
  const auto header = header_of(lines, header_line);

  std::vector<std::string_view> names = required;
  names.insert(names.end(), optional.begin(), optional.end());
  std::vector<std::optional<std::size_t>> places;
  CsvColumns table;
  for (std::size_t k = 0; k < names.size(); ++k) {
    places.push_back(csv_column(header_line, names[k], lines.place()));
    table.present.push_back(places[k].has_value());
    if (!places[k] && k < required.size()) {
      throw refused(lines.place(), fmt::format("no column '{}'; the first line must name the columns {}",
                                               names[k], fmt::join(required, ",")));
    }
  }
  table.columns.resize(names.size());
  for (std::string_view line; lines.next(line);) {
    if (trimmed(line).empty()) continue;
    if (table.lines.size() == most_rows) {
      throw refused(lines.place(), fmt::format("more than {} rows are not read", most_rows));
    }
    const auto cells = cells_of(line);
    refuse_extra_cells(lines, cells, header.size());
    for (std::size_t k = 0; k < names.size(); ++k) {
      if (places[k]) table.columns[k].push_back(number_in(lines, cells, *places[k], names[k]));
    }
    table.lines.push_back(lines.number());
  }
  return table;
}

}  // namespace fingerpad
