#include "trace/trace_glance.hpp"

#include <algorithm>
#include <cstdint>
#include <fstream>

#include "base/error.hpp"
#include "trace/file_seal.hpp"
#include "trace/hdf5_file.hpp"
#include "trace/hdf5_trial.hpp"
#include "trace/trace.hpp"
#include "trace/trace_column.hpp"

namespace fingerpad {
namespace {

bool may_be_trace(const hdf5::Handle& file) {
  if (hdf5::has_attribute(file, "scene")) return true;
  const auto columns = trace_columns();
  return std::ranges::all_of(columns, [&](const TraceColumn& column) {
    return column.of != ColumnOf::every_trace || hdf5::has_link(file, std::string(column.name));
  });
}

}  // namespace

bool looks_whole(const std::string& path) {
  if (is_hdf5(path)) return ends_with_seal(path);
  if (!is_csv_trace(path) && !is_partial_csv_trace(path)) return false;
  std::ifstream file(path, std::ios::binary);  // InputFile, which takes streams too, cannot seek
  file.seekg(-1, std::ios::end);
  return file.get() == '\n';
}

bool is_foreign_hdf5(const std::string& path) {
  if (!is_hdf5(path) || ends_with_seal(path)) return false;
  constexpr std::uint64_t room = 4096;
  try {
    return read_in_trial(
        path, {.seconds = 2, .memory_bytes = std::uint64_t{256} << 20}, room,
        [&](Teller& tell) {
          tell(!may_be_trace(hdf5::open_file(path)));
          tell.flush();
        },
        [](Hearer& hear) {
          bool is_foreign = false;
          hear(is_foreign);
          return is_foreign;
        });
  } catch (const Error&) {
    return false;
  }
}

}  // namespace fingerpad
