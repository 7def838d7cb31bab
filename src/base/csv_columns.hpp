#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/csv_cells.hpp"

namespace fingerpad {

/// What says in what columns are measured: a line below a table's header, or an attribute `unit` of each
/// HDF5 dataset.
enum class UnitSource { line, attributes };

/// What a table says its columns are measured in, as in "s,mm,mm,mm,N,N,N".
struct UnitRow {
  std::vector<std::string> words;  ///< per asked-for name, without brackets; empty: nothing says it
  std::string place;               ///< "table.csv:2", or an HDF5 file's path
  UnitSource source = UnitSource::line;
};

/// Columns of numbers picked from a CSV file by name.
struct CsvColumns {
  std::vector<bool> present;                 ///< per asked-for name
  std::vector<std::vector<double>> columns;  ///< per asked-for name, a number per row; empty where absent
  std::vector<long> lines;                   ///< per row: its line in the file, from 1
  UnitRow units;                             ///< below the header, where the request takes one
  char separator = ',';                      ///< that the file has
  std::string cut;    ///< that its last row was left out, where the request wants it so; for people
  std::string above;  ///< that lines above its header were passed over, for people; empty: there are none
  std::vector<std::string> names;  ///< all that the header has
};

/// What is said of another mark than a comma where only commas are read.
inline constexpr std::string_view commas_mend = "save it with commas, and numbers with decimal points";
/// And where people may say which mark a table has.
inline constexpr std::string_view separator_mend =
    "leave the separator out, and it is found, or say the one that it has";

/// Where a column stands in a CSV header, from 0; nothing where it is not there. Blanks and quotes around
/// names do not count. Throws Error (refused, at `place`) for a column that is there twice, and for a header
/// whose cells are parted by another mark than `separator`.
/// @param mend  what to do about another mark, for people
std::optional<std::size_t> csv_column(std::string_view header, std::string_view name,
                                      const std::string& place, char separator = ',',
                                      std::string_view mend = commas_mend);

/// Where a table may come from: a stream is read once and cannot be looked at again.
enum class TableSource { file, file_or_stream };

/// What is to be read of a table, and how.
struct CsvRequest {
  std::vector<std::string_view> required;       ///< names that must be there
  std::vector<std::string_view> optional = {};  ///< names that may be there
  CsvDialect dialect = {};
  TableSource source = TableSource::file;
  std::string mend = {};           ///< what to do where a column is missing, for people; may be empty
  std::string_view xml_mend = {};  ///< likewise where it is XML
  bool takes_gaps = false;         ///< a cell that is empty or nan is not a number, instead of refused
  bool takes_units = false;        ///< a line of units below the header is read, instead of refused
  /// Where the first line does not name all that is required, the first below that does is the header: what a
  /// program says above it about its instrument is passed over. See CsvColumns::above.
  bool takes_lines_above = false;
  std::string_view mark_mend = commas_mend;  ///< see csv_column
  /// How people say the decimal mark, {} in its place: "--decimal {}"; empty: they cannot.
  std::string_view decimal_key = {};
  bool leaves_out_cut_row = false;  ///< a last row without a line end; see CsvColumns::cut
};

/// Reads named columns of a CSV file whose first line is a header; other columns, blank lines and lines that
/// begin with `#` are passed over. Where the first line that is left is one of numbers, the last line before
/// it that begins with `#` is the header, as NumPy writes it.
///
/// Throws Error (refused, at `file:line`) as csv_column, for a file that cannot be read or is empty, a
/// missing column (with those that are there), a separator that cannot be found, a row that is short or has
/// more cells than the header, a row of units, a word that is no number, a number that is not finite, and
/// over 50 million rows.
CsvColumns read_csv_columns(const std::string& path, const CsvRequest& request);
CsvColumns read_csv_columns(const std::string& path, const std::vector<std::string_view>& required,
                            const std::vector<std::string_view>& optional = {},
                            TableSource source = TableSource::file);

}  // namespace fingerpad
