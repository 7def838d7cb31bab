#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/number_text.hpp"
#include "base/path_words.hpp"
#include "trace/csv_rows.hpp"
#include "trace/file_seal.hpp"
#include "trace/hdf5_trace.hpp"
#include "trace/hdf5_trial.hpp"
#include "trace/trace.hpp"
#include "trace/trace_choice.hpp"
#include "trace/trace_column.hpp"
#include "trace/trace_folder.hpp"

namespace fingerpad {
namespace {

constexpr InputKind trace_file{"a trace", std::numeric_limits<std::uint64_t>::max()};

/// By a child process. The seal tells damage that HDF5 would not see.
Trace read_hdf5_trace(const std::string& path, TraceContents contents) {
  constexpr std::uint64_t bytes_per_second = std::uint64_t{5} << 20;  // far slower than any reading
  if (check_seal(path) == Seal::broken)
    throw refused(path, "is damaged: its contents are not those that were written");
  std::error_code vanished;
  const std::uint64_t bytes = std::filesystem::file_size(path, vanished);
  if (vanished) throw refused(path, "cannot be read: " + path_words(path, vanished.value()));
  // A row takes eight bytes of the file at least, its time, and eight of every column where it is told. Of a
  // plain trace what is told is hardly more than the file, of a deflated one many times that.
  const std::uint64_t told_bytes = (std::uint64_t{1} << 20) + (trace_columns().size() + 1) * bytes;
  const TrialLimits limits{.seconds = 2 + bytes / bytes_per_second,
                           .memory_bytes = (std::uint64_t{256} << 20) + 4 * bytes};
  return read_in_trial(
      path, limits, told_bytes, [&](Teller& tell) { tell_trace(path, contents, tell); },
      [&](Hearer& hear) { return hear_trace(path, contents, hear); });
}

/// Where no more than one wall can hold the finger a run does not tell how many do.
void count_single_walls(Trace& trace) {
  const bool is_told = std::find(trace.absent.begin(), trace.absent.end(), "walls") == trace.absent.end();
  if (is_told || !trace.info.columns.empty()) return;
  for (TickRecord& row : trace.rows) row.walls = row.phase == Phase::free ? 0 : 1;
}

}  // namespace

bool is_hdf5(const std::string& path) {
  // Bytes taken from a stream are gone: a stream is read as a text. What cannot be opened is for the reader
  // to tell.
  if (stream_descriptor(path) || why_unreadable(path, trace_file)) return false;
  InputFile file(path, trace_file);
  std::string start(8, '\0');
  return file.read(start.data(), 8) == 8 && start == "\x89HDF\r\n\x1a\n";
}

void refuse_false_hdf5(const std::string& path) {
  const bool says_hdf5 = path.ends_with(".h5") || path.ends_with(".hdf5");
  if (!says_hdf5 || is_hdf5(path) || why_unreadable(path, trace_file)) return;
  std::error_code vanished;
  if (std::filesystem::file_size(path, vanished) == 0 && !vanished)
    throw refused(path, "is empty: whatever was to write it ended before it had begun");
  throw refused(path, "is no HDF5 file, as its name says: it is damaged, or something else by that name");
}

Trace read_trace(const std::string& path, TraceContents contents) {
  refuse_trace_folder(path);
  if (path.ends_with(".toml") && !is_hdf5(path) && !why_unreadable(path, trace_file))
    throw refused(path, "is a scene, not a trace: `fingerpad replay` makes one of it");
  refuse_false_hdf5(path);
  Trace trace = is_hdf5(path) ? read_hdf5_trace(path, contents) : read_csv_trace(path);
  if (contents != TraceContents::some_rows) refuse_missing_columns(trace, path);
  count_single_walls(trace);
  return trace;
}

Trace read_trace(const std::string& path) {
  return read_trace(path, TraceContents::all);
}

std::string early_end_words(const Trace& trace) {
  if (trace.complete) return "";
  if (trace.rows.empty()) return trace.cut + "; no row of it is whole";
  return fmt::format("{}; read up to t = {} s", trace.cut, number_text(trace.rows.back().t_s));
}

void refuse_no_rows(const Trace& trace, const std::string& path) {
  if (!trace.rows.empty()) return;
  throw refused(path, trace.complete ? "holds no row, and so nothing to show: was its run one of no ticks?"
                                     : trace.cut + "; no row of it is left, and so nothing to show");
}

}  // namespace fingerpad
