#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fingerpad {

/// Columns of numbers picked from a CSV file by name.
struct CsvColumns {
  std::vector<bool> present;                 ///< per asked-for name
  std::vector<std::vector<double>> columns;  ///< per asked-for name, a number per row; empty where absent
  std::vector<long> lines;                   ///< per row: its line in the file, from 1
};

/// Where a column stands in a CSV header, from 0; nothing where it is not there. Blanks around names do not
/// count. Throws Error (refused, at `place`) for a column that is there twice, and for a header whose cells
/// are parted by another mark than the comma.
std::optional<std::size_t> csv_column(std::string_view header, std::string_view name,
                                      const std::string& place);

/// Where a table may come from: a stream is read once and cannot be looked at again.
enum class TableSource { file, file_or_stream };

/// Reads named columns of a CSV file whose first line is a header; other columns and blank lines are passed
/// over.
///
/// @param required  names that must be there
/// @param optional  names that may be there
/// Throws Error (refused, at `file:line`) as csv_column, for a file that cannot be read or is empty, a
/// missing column, a row that is short or has more cells than the header, a word that is no number, a number
/// that is not finite, and over 50 million rows.
CsvColumns read_csv_columns(const std::string& path, const std::vector<std::string_view>& required,
                            const std::vector<std::string_view>& optional = {},
                            TableSource source = TableSource::file);

}  // namespace fingerpad
