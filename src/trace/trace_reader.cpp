#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>

#include "base/error.hpp"
#include "trace/csv_rows.hpp"
#include "trace/embedded_surfaces.hpp"
#include "trace/file_seal.hpp"
#include "trace/hdf5_file.hpp"
#include "trace/trace.hpp"
#include "trace/trace_row.hpp"
#include "trace/trial.hpp"

namespace fingerpad {
namespace {

// A writer adds at most this many rows to a column before the next column gets them.
constexpr std::uint64_t max_unfinished_rows = 4096;

TraceInfo read_info(const hdf5::Handle& file) {
  TraceInfo info;
  info.scene_name = hdf5::read_text(file, "scene_name");
  info.scene_text = hdf5::read_text(file, "scene");
  info.seed = hdf5::read_whole(file, "seed").value_or(info.seed);
  if (hdf5::has_attribute(file, "rate_hz")) info.rate_hz = hdf5::read_numbers(file, "rate_hz", 1).front();
  info.version = hdf5::read_text(file, "version");
  info.mesh_files = hdf5::read_texts(file, "mesh_files");
  info.mesh_hashes = hdf5::read_texts(file, "mesh_hashes");
  info.motion_file = hdf5::read_text(file, "motion_file");
  info.motion_hash = hdf5::read_text(file, "motion_hash");
  info.profile_text = hdf5::read_text(file, "profile");
  info.contact_method = hdf5::read_text(file, "contact_method");
  info.contact_normals = hdf5::read_text(file, "contact_normals");
  info.contact_reasons = hdf5::read_texts(file, "contact_reasons");
  return info;
}

struct Columns {
  std::vector<hdf5::Handle> handles;
  std::uint64_t rows = 0;  ///< of the shortest
};

Columns open_columns(const hdf5::Handle& file, bool complete) {
  Columns columns;
  std::uint64_t longest = 0;
  columns.rows = std::numeric_limits<std::uint64_t>::max();
  for (const TraceColumn& column : trace_columns()) {
    const std::string name(column.name);
    if (!hdf5::has_link(file, name)) {
      throw refused(file.path(), fmt::format("is no trace: it has no column '{}'", name));
    }
    columns.handles.push_back(hdf5::open_dataset(file, name));
    const auto size = hdf5::extents(columns.handles.back());
    if (size.size() != 1)
      throw refused(file.path(), fmt::format("column '{}' is no column of numbers", name));
    columns.rows = std::min(columns.rows, size[0]);
    longest = std::max(longest, size[0]);
  }
  if (longest - columns.rows > (complete ? 0 : max_unfinished_rows)) {
    throw refused(file.path(),
                  fmt::format("is damaged: its columns have from {} to {} rows", columns.rows, longest));
  }
  // Every row takes many bytes, so that a damaged length is seen before memory is asked for.
  const std::uint64_t bytes = std::filesystem::file_size(file.path());
  if (columns.rows > bytes) {
    throw refused(file.path(), fmt::format("is damaged: {} rows in {} bytes", columns.rows, bytes));
  }
  return columns;
}

/// Reads rows until one cannot be read; how many were.
std::size_t read_block(const Columns& columns, std::size_t first, std::vector<TraceRow>& block) {
  std::vector<double> values(block.size());
  for (std::size_t k = 0; k < columns.handles.size(); ++k) {
    if (!hdf5::read_rows(columns.handles[k], first, values)) return 0;
    for (std::size_t i = 0; i < block.size(); ++i) block[i][k] = values[i];
  }
  return block.size();
}

void read_rows(const hdf5::Handle& file, Trace& trace) {
  constexpr std::size_t block_rows = 1024;  // a chunk of the file
  const Columns columns = open_columns(file, trace.complete);
  trace.rows.reserve(columns.rows);
  std::vector<TraceRow> block;
  for (std::size_t first = 0; first < columns.rows; first += block_rows) {
    block.resize(std::min<std::size_t>(block_rows, columns.rows - first));
    if (read_block(columns, first, block) == 0) {
      // What was under way when the recording was cut short is not there; in a whole file nothing may be
      // missing.
      if (!trace.complete) return;
      throw refused(file.path(), fmt::format("is damaged: the rows from {} cannot be read", first + 1));
    }
    for (std::size_t i = 0; i < block.size(); ++i) {
      const std::string_view damage = row_damage(block[i]);
      if (!damage.empty()) throw refused(file.path(), fmt::format("row {}: {}", first + i + 1, damage));
      trace.rows.push_back(to_record(block[i]));
    }
  }
}

Trace read_contents(const std::string& path, TraceContents contents) {
  const hdf5::Handle file = hdf5::open_file(path);
  Trace trace;
  trace.complete = hdf5::read_whole(file, "complete").value_or(0) != 0;
  trace.info = read_info(file);
  read_rows(file, trace);
  if (contents == TraceContents::all) trace.world = read_surfaces(file);
  if (!trace.world) return trace;
  const auto surfaces = static_cast<int>(trace.world->surfaces.size());
  for (const TickRecord& row : trace.rows) {
    if (row.surface >= surfaces)
      throw refused(path, fmt::format("names surface {} of {}", row.surface, surfaces));
  }
  return trace;
}

/// HDF5 1.10 trusts what it reads: of files with a few bytes changed among its own records, one in thirty
/// crashed it and one in ninety hung it. A seal tells damage beforehand; what has no seal (a recording cut
/// short, a file changed by another tool) is read by a child process first.
Trace read_hdf5_trace(const std::string& path, TraceContents contents) {
  constexpr std::uint64_t bytes_per_second = std::uint64_t{50} << 20;  // far slower than any reading
  const Seal seal = check_seal(path);
  if (seal == Seal::broken) throw refused(path, "is damaged: its contents are not those that were written");
  const hdf5::Turn turn;
  if (seal == Seal::none) {
    const std::uint64_t bytes = std::filesystem::file_size(path);
    // A row takes twice as much in memory as in the file.
    const std::uint64_t memory_bytes = (std::uint64_t{256} << 20) + 4 * bytes;
    const auto outcome =
        trial([&] { read_contents(path, contents); }, 3 + bytes / bytes_per_second, memory_bytes);
    if (outcome.end == TrialOutcome::End::threw) throw refused("", outcome.message);
    if (outcome.end == TrialOutcome::End::died)
      throw refused(path, "is damaged: HDF5 cannot read it to its end");
  }
  return read_contents(path, contents);
}

}  // namespace

bool is_hdf5(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string start(8, '\0');
  return file.read(start.data(), 8) && start == "\x89HDF\r\n\x1a\n";
}

Trace read_trace(const std::string& path, TraceContents contents) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) throw refused(path, "is a folder, not a trace");
  if (!std::ifstream(path, std::ios::binary)) throw refused(path, "cannot be read");
  return is_hdf5(path) ? read_hdf5_trace(path, contents) : read_csv_trace(path);
}

Trace read_trace(const std::string& path) {
  return read_trace(path, TraceContents::all);
}

}  // namespace fingerpad
