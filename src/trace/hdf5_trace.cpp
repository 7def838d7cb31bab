#include "trace/hdf5_trace.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "base/error.hpp"
#include "touch/world.hpp"
#include "trace/change_log.hpp"
#include "trace/column_chunks.hpp"
#include "trace/embedded_surfaces.hpp"
#include "trace/hdf5_file.hpp"
#include "trace/trace_column.hpp"

namespace fingerpad {
namespace {

// A writer adds at most this many rows to a column before the next column gets them.
constexpr std::uint64_t max_unfinished_rows = most_chunk_rows;
constexpr std::size_t block_rows = 1024;

/// Rows by column, as they stand in the file.
using Block = std::vector<std::vector<double>>;

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
  info.motion_notes = hdf5::read_texts(file, "motion_notes");
  for (const TraceColumn& column : trace_columns()) {
    if (hdf5::has_link(file, std::string(column.name))) tell_of(column, info);
  }
  info.profile_text = hdf5::read_text(file, "profile");
  info.contact_method = hdf5::read_text(file, "contact_method");
  info.contact_normals = hdf5::read_text(file, "contact_normals");
  info.contact_reasons = hdf5::read_texts(file, "contact_reasons");
  info.columns = hdf5::read_texts(file, "columns");
  info.every = hdf5::read_whole(file, "every").value_or(1);
  info.deflated = hdf5::read_whole(file, "deflated").value_or(0) != 0;
  return info;
}

/// For both ways of the handover.
template <typename Way, typename Info>
void each_field_of_info(Way& way, Info& info) {
  way(info.scene_name);
  way(info.scene_text);
  way(info.seed);
  way(info.rate_hz);
  way(info.version);
  way(info.mesh_files);
  way(info.mesh_hashes);
  way(info.motion_file);
  way(info.motion_hash);
  way(info.several_walls);
  way(info.in_hand);
  way(info.estimated);
  way(info.turning);
  way(info.attitudes);
  way(info.sent);
  way(info.compared);
  way(info.motion_notes);
  way(info.profile_text);
  way(info.contact_method);
  way(info.contact_normals);
  way(info.contact_reasons);
  way(info.columns);
  way(info.every);
  way(info.deflated);
}

struct Columns {
  std::vector<std::optional<hdf5::Handle>> handles;  ///< none for one that an older trace lacks
  std::uint64_t rows = 0;                            ///< of the shortest
};

/// How long a column is: what it says of itself, checked against the bytes that it has.
std::uint64_t rows_of(const hdf5::Handle& column, const std::string& name, bool complete,
                      std::uint64_t file_bytes) {
  const auto size = hdf5::extents(column);
  if (size.size() != 1)
    throw refused(column.path(), fmt::format("column '{}' is no column of numbers{}", name,
                                             size.empty() ? ""
                                                          : fmt::format(": it is {}, and a trace's is N",
                                                                        fmt::join(size, " x "))));
  // Every row takes many bytes.
  if (size[0] > file_bytes)
    throw refused(column.path(), fmt::format("is damaged: {} rows in {} bytes", size[0], file_bytes));
  const std::uint64_t stored = hdf5::stored_values(column);
  if (complete && size[0] > stored) {
    throw refused(column.path(), fmt::format("is damaged: column '{}' has {} rows, but bytes for {} alone",
                                             name, size[0], stored));
  }
  return std::min(size[0], stored);  // a killed writer may have left a column longer than its bytes
}

/// What to do with an HDF5 file that this program has not written.
std::string own_table_mend(const hdf5::Handle& file) {
  return hdf5::has_attribute(file, "scene")
             ? ""
             : "; a table of your own is touched as a scene's motion ([motion] file = ...), and fitted by "
               "`fingerpad fit`";
}

/// @param is_partial  the file says that it was written without some columns
Columns open_columns(const hdf5::Handle& file, bool complete, bool is_partial) {
  const std::uint64_t file_bytes = std::filesystem::file_size(file.path());
  Columns columns;
  std::uint64_t longest = 0;
  columns.rows = std::numeric_limits<std::uint64_t>::max();
  for (const TraceColumn& column : trace_columns()) {
    const std::string name(column.name);
    if (!hdf5::has_link(file, name)) {
      const bool always = column.of == ColumnOf::every_trace;
      if (!always || (is_partial && name != "t_s")) {
        columns.handles.emplace_back();
        continue;
      }
      throw refused(file.path(), fmt::format("is no trace: it has no column '{}'; {}{}", name,
                                             hdf5::contents_words(file), own_table_mend(file)));
    }
    columns.handles.push_back(hdf5::open_dataset(file, name, "column"));
    // A row that takes bytes for certain: so what a file unfolds to has a bound.
    if (name == "t_s" && hdf5::is_deflated(*columns.handles.back()))
      throw refused(file.path(),
                    "is refused: column 't_s' is compressed, which no trace's is" + own_table_mend(file));
    const std::uint64_t rows = rows_of(*columns.handles.back(), name, complete, file_bytes);
    columns.rows = std::min(columns.rows, rows);
    longest = std::max(longest, rows);
  }
  if (longest - columns.rows > (complete ? 0 : max_unfinished_rows)) {
    throw refused(file.path(),
                  fmt::format("is damaged: its columns have from {} to {} rows", columns.rows, longest));
  }
  return columns;
}

bool read_block(const Columns& columns, std::size_t first, std::size_t count, Block& block) {
  for (std::size_t k = 0; k < columns.handles.size(); ++k) {
    if (!columns.handles[k]) continue;
    block[k].resize(count);
    if (!hdf5::read_rows(*columns.handles[k], first, block[k])) return false;
  }
  return true;
}

/// Which columns there are, the rows' number as far as it is known, blocks of them, and an empty block as the
/// end.
void tell_rows(const hdf5::Handle& file, const Columns& columns, bool complete, Teller& tell) {
  std::string there;
  for (const auto& handle : columns.handles) there += handle ? '1' : '0';
  tell(there);
  tell(std::uint64_t{columns.rows});
  Block block(columns.handles.size());
  for (std::size_t first = 0; first < columns.rows; first += block_rows) {
    const std::size_t count = std::min<std::size_t>(block_rows, columns.rows - first);
    if (!read_block(columns, first, count, block)) {
      // What was under way when the recording was cut short is not there; in a whole file nothing may be
      // missing.
      if (!complete) break;
      throw refused(file.path(), fmt::format("is damaged: the rows from {} cannot be read", first + 1));
    }
    tell(std::uint64_t{count});
    for (const auto& values : block) tell.numbers(std::span<const double>(values));
  }
  tell(std::uint64_t{0});
}

/// The columns that the file has; the trace is told which of the others it should have.
std::vector<TraceColumn> hear_columns(Hearer& hear, Trace& trace) {
  std::string there;
  hear(there);
  const auto columns = trace_columns();
  if (there.size() != columns.size()) throw ToldTooMuch("other columns");
  std::vector<TraceColumn> present;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    if (there[k] == '1') {
      present.push_back(columns[k]);
      continue;
    }
    trace.absent.emplace_back(columns[k].name);
    if (columns[k].of == ColumnOf::every_trace) trace.missing.emplace_back(columns[k].name);
  }
  return present;
}

void hear_rows(const std::string& path, Hearer& hear, Trace& trace) {
  constexpr std::size_t most_reserved = std::size_t{1} << 20;  // a record takes far more room than a row told
  const std::vector<TraceColumn> columns = hear_columns(hear, trace);
  const std::size_t row_bytes = std::max<std::size_t>(1, columns.size()) * sizeof(double);
  trace.rows.reserve(std::min(hear.length(row_bytes), most_reserved));
  Block block(columns.size());
  while (const std::size_t count = hear.length(row_bytes)) {
    if (columns.empty()) throw ToldTooMuch("rows of no columns");
    for (auto& values : block) {
      values.resize(count);
      hear.numbers(std::span<double>(values));
    }
    for (std::size_t i = 0; i < count; ++i) {
      TickRecord& record = trace.rows.emplace_back();
      for (std::size_t k = 0; k < columns.size(); ++k) {
        const std::string_view damage = read_value(columns[k], block[k][i], record);
        if (!damage.empty()) throw refused(path, fmt::format("row {}: {}", trace.rows.size(), damage));
      }
    }
  }
}

/// Empty if there are none, or one was too large to be embedded.
std::shared_ptr<const World> hear_surfaces(const std::string& path, Hearer& hear) {
  auto world = std::make_shared<World>();
  bool whole = true;
  while (hear.one<bool>()) {
    EmbeddedSurface surface;
    each_field(hear, surface);
    whole = whole && (surface.has_triangles || !surface.is_part);
    if (whole) add_surface(*world, surface, path);
  }
  if (!whole || world->surfaces.empty()) return nullptr;
  return world;
}

}  // namespace

void tell_trace(const std::string& path, TraceContents contents, Teller& tell) {
  const hdf5::Handle file = hdf5::open_file(path);
  const bool complete = hdf5::read_whole(file, "complete").value_or(0) != 0;
  tell(complete);
  const TraceInfo info = read_info(file);
  each_field_of_info(tell, info);
  tell(read_change_log(file));
  tell_rows(file, open_columns(file, complete, !info.columns.empty()), complete, tell);
  if (contents == TraceContents::all) {
    read_surfaces(file, [&tell](const EmbeddedSurface& surface) {
      tell(true);
      each_field(tell, surface);
    });
  }
  tell(false);
  tell.flush();
}

Trace hear_trace(const std::string& path, TraceContents contents, Hearer& hear) {
  Trace trace;
  hear(trace.complete);
  if (!trace.complete) trace.cut = unfinished_words;
  each_field_of_info(hear, trace.info);
  std::string changes;
  hear(changes);
  trace.info.changes = read_scene_changes(changes, path);
  hear_rows(path, hear, trace);
  trace.world = hear_surfaces(path, hear);
  if (contents != TraceContents::all) trace.world = nullptr;
  if (!trace.world) return trace;
  const auto surfaces = static_cast<int>(trace.world->surfaces.size());
  for (const TickRecord& row : trace.rows) {
    if (row.surface >= surfaces)
      throw refused(path, fmt::format("names surface {} of {}", row.surface, surfaces));
  }
  return trace;
}

}  // namespace fingerpad
