#include "base/csv_columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <fstream>
#include <optional>

#include "base/error.hpp"
#include "base/number_text.hpp"

namespace fingerpad {
namespace {

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  while (true) {
    const std::size_t comma = line.find(',');
    cells.push_back(line.substr(0, comma));
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

std::optional<std::size_t> column_of(const std::vector<std::string_view>& header, std::string_view name) {
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (trimmed(header[i]) == name) return i;
  }
  return std::nullopt;
}

double number_in(const std::string& where, const std::vector<std::string_view>& cells, std::size_t column,
                 std::string_view name) {
  if (column >= cells.size()) {
    throw refused(where,
                  fmt::format("has {} cells, but column '{}' is number {}", cells.size(), name, column + 1));
  }
  const auto value = parse_number(cells[column]);
  if (!value)
    throw refused(where, fmt::format("'{}' in column '{}' is no number", trimmed(cells[column]), name));
  if (!std::isfinite(*value)) throw refused(where, fmt::format("column '{}' is not finite", name));
  return *value;
}

}  // namespace

CsvColumns read_csv_columns(const std::string& path, const std::vector<std::string_view>& required,
                            const std::vector<std::string_view>& optional) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw refused(path, "cannot be read");
  std::string line;
  if (!std::getline(file, line)) throw refused(path, "is empty");
  std::string_view header_line = line;
  if (header_line.starts_with("\xef\xbb\xbf")) header_line.remove_prefix(3);
  const auto header = cells_of(header_line);

  std::vector<std::string_view> names = required;
  names.insert(names.end(), optional.begin(), optional.end());
  std::vector<std::optional<std::size_t>> places;
  CsvColumns table;
  for (std::size_t k = 0; k < names.size(); ++k) {
    places.push_back(column_of(header, names[k]));
    table.present.push_back(places[k].has_value());
    if (!places[k] && k < required.size()) {
      throw refused(path + ":1", fmt::format("no column '{}'; the first line must name the columns {}",
                                             names[k], fmt::join(required, ",")));
    }
  }
  table.columns.resize(names.size());
  for (long number = 2; std::getline(file, line); ++number) {
    if (trimmed(line).empty()) continue;
    const std::string where = fmt::format("{}:{}", path, number);
    const auto cells = cells_of(line);
    for (std::size_t k = 0; k < names.size(); ++k) {
      if (places[k]) table.columns[k].push_back(number_in(where, cells, *places[k], names[k]));
    }
    table.lines.push_back(number);
  }
  if (file.bad()) throw refused(path, "cannot be read to its end");
  return table;
}

}  // namespace fingerpad
