#include "trace/hdf5_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/error.hpp"
#include "trace/hdf5_columns.hpp"

namespace fingerpad {
namespace {

void refuse_keys_of_text(const std::string& path, const RecordingFormat& format) {
  const CsvDialect plain = RecordingFormat{}.dialect;
  const char* key = !format.name.empty()                          ? "format"
                    : !format.positions_path.empty()              ? "positions"
                    : format.dialect.separator != plain.separator ? "separator"
                    : format.dialect.decimal != plain.decimal     ? "decimal"
                                                                  : nullptr;
  if (key == nullptr) return;
  throw refused(path,
                fmt::format("'{}' in [motion] says how a table of text is read, and this is HDF5: leave "
                            "it out",
                            key));
}

/// Of what must be there.
void refuse_missing(const std::string& path, const AskedColumns& asked, const std::vector<bool>& present) {
  for (std::size_t k = 0; k < asked.required; ++k) {
    if (present[k]) continue;
    throw refused(path, fmt::format("has no dataset '{}'; a recorded motion has one a column at its root, as "
                                    "t_s, x_m, y_m, z_m, of N numbers each, and {}; where they are called "
                                    "otherwise, say [motion] columns = {{ t = \"time\" }}",
                                    asked.names[k], read_hdf5_contents(path)));
  }
}

/// What lay where nothing is recorded is not guessed.
void refuse_gaps(const std::string& path, const AskedColumns& asked,
                 const std::vector<std::vector<double>>& columns) {
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const auto gap =
        std::find_if(columns[k].begin(), columns[k].end(), [](double x) { return !std::isfinite(x); });
    if (gap == columns[k].end()) continue;
    throw refused(fmt::format("{}:{}", path, gap - columns[k].begin() + 1),
                  fmt::format("holds no finite number in column '{}', and what lay there is not guessed: "
                              "leave such rows out, or fill them",
                              asked.names[k]));
  }
}

}  // namespace

bool is_hdf5_table(const std::string& path) {
  return !read_hdf5_columns(path, {}).is_trace;
}

Motion read_motion_hdf5(const std::string& path, RecordingFormat& format) {
  refuse_keys_of_text(path, format);
  refuse_words_of_no_force(path, format);
  const AskedColumns asked = asked_columns(format);
  Hdf5Columns file = read_hdf5_columns(path, {asked.names.begin(), asked.names.end()});
  refuse_missing(path, asked, file.present);
  refuse_gaps(path, asked, file.columns);
  std::vector<long> rows(file.columns.front().size());
  std::iota(rows.begin(), rows.end(), 1L);
  const UnitRow units{std::move(file.units), path, UnitSource::attributes};
  const RecordedTable table =
      recorded_table(path, std::move(file.columns), std::move(rows), asked, units, format);
  return motion_of_table(table, format);
}

}  // namespace fingerpad
