#include "base/csv_columns.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/csv_row_reader.hpp"
#include "base/error.hpp"
#include "base/printable_text.hpp"

namespace fingerpad {

std::optional<std::size_t> csv_column(std::string_view header, std::string_view name,
                                      const std::string& place, char separator, std::string_view mend) {
  std::optional<std::size_t> found;
  const auto cells = csv_cells(header, separator);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i] != name) continue;
    if (found) {
      throw refused(place, fmt::format("names the column '{}' twice, in cells {} and {}: rename one of them",
                                       printable(name, 60), *found + 1, i + 1));
    }
    found = i;
  }
  if (found) return found;
  for (const char mark : {',', ';', '\t', '|'}) {
    const auto others = csv_cells(header, mark);
    if (mark == separator || std::find(others.begin(), others.end(), name) == others.end()) continue;
    throw refused(place, fmt::format("its cells are parted by {}, not by {}: {}", separator_words(mark),
                                     separator_words(separator), mend));
  }
  return std::nullopt;
}

CsvColumns read_csv_columns(const std::string& path, const CsvRequest& request) {
  CsvRowReader reader(path, request);
  CsvColumns table;
  table.present = reader.present();
  table.separator = reader.separator();
  table.units = reader.units();
  table.columns.resize(table.present.size());
  while (reader.next()) {
    for (std::size_t k = 0; k < table.columns.size(); ++k)
      if (table.present[k]) table.columns[k].push_back(reader.number(k));
    table.lines.push_back(reader.line());
  }
  table.cut = reader.cut();
  table.above = reader.above();
  table.names = reader.names();
  return table;
}

CsvColumns read_csv_columns(const std::string& path, const std::vector<std::string_view>& required,
                            const std::vector<std::string_view>& optional, TableSource source) {
  return read_csv_columns(path, {required, optional, {}, source});
}

}  // namespace fingerpad
