#include "trace/csv_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include "base/csv_columns.hpp"
#include "base/error.hpp"
#include "base/number_text.hpp"
#include "base/printable_text.hpp"
#include "base/text_lines.hpp"
#include "motion/recording_format.hpp"
#include "trace/change_log.hpp"
#include "trace/trace_column.hpp"

namespace fingerpad {
namespace {

/// The column that tells of a thinned trace by how much; the same in each row.
constexpr std::string_view every_name = "every";

/// Whether a header is one that a writer of some columns writes.
bool is_partial(std::vector<std::string_view> names) {
  if (!names.empty() && names.back() == every_name) names.pop_back();
  return names.size() > 1 && names.front() == "t_s" &&
         std::ranges::all_of(names, [](const std::string_view name) {
           return std::ranges::any_of(trace_columns(),
                                      [name](const auto& column) { return column.name == name; });
         });
}

/// How a file begins: a header and a row, if they are of a trace.
std::string first_text(const std::string& path) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(path, none)) return {};
  std::ifstream file(path, std::ios::binary);
  constexpr std::size_t longest = 8192;
  std::string text(longest, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.starts_with("\xef\xbb\xbf")) text.erase(0, 3);
  return text;
}

/// The names in a file's first line.
std::vector<std::string> header_names(const std::string& path) {
  const std::string text = first_text(path);
  const auto names = csv_cells(std::string_view(text).substr(0, text.find_first_of("\r\n")), ',');
  return {names.begin(), names.end()};
}

bool has_every_column(const std::vector<std::string>& names) {
  return std::ranges::all_of(trace_columns(), [&](const TraceColumn& column) {
    return column.of != ColumnOf::every_trace || std::ranges::find(names, column.name) != names.end();
  });
}

/// Where each column of a trace stands in the file; beyond its columns for one that it lacks.
std::vector<std::size_t> find_columns(const std::string& where, std::string_view header, Trace& trace) {
  std::vector<std::size_t> places;
  const auto names = csv_cells(header, ',');
  const std::size_t beyond = names.size();
  for (const TraceColumn& column : trace_columns()) {
    const auto place = csv_column(header, column.name, where);
    if (!place) trace.absent.emplace_back(column.name);
    if (!place && column.of == ColumnOf::every_trace) {
      trace.missing.emplace_back(column.name);
      trace.info.columns = {names.begin(), names.end()};
      std::erase(trace.info.columns, every_name);
      if (is_partial(names)) {
        places.push_back(beyond);
        continue;
      }
      throw refused(where, fmt::format("is no trace: it has no column '{}'", column.name));
    }
    places.push_back(place.value_or(beyond));
  }
  return places;
}

std::optional<double> phase_number(std::string_view name) {
  for (const Phase phase : {Phase::free, Phase::stick, Phase::slip}) {
    if (name == phase_name(phase)) return static_cast<double>(phase);
  }
  return std::nullopt;
}

bool is_blank(std::string_view line) {
  return line.find_first_not_of(" \t\r") == std::string_view::npos;
}

TickRecord read_row(const TextLines& lines, const std::vector<std::string_view>& cells,
                    const std::vector<std::size_t>& places, std::size_t cell_count) {
  if (cells.size() != cell_count) {
    throw refused(lines.place(),
                  fmt::format("has {} cells, but the header has {}", cells.size(), cell_count));
  }
  TickRecord record;
  std::string_view damage;  // of the row's numbers, once it is known that all are
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (places[k] == cells.size()) continue;
    const TraceColumn& column = trace_columns()[k];
    const std::string_view cell = cells[places[k]];
    const bool is_phase = column.kind == ColumnKind::phase;
    const auto value = is_phase ? phase_number(cell) : parse_number(cell);
    if (!value) {
      throw refused(lines.place(),
                    fmt::format("'{}' in column '{}' is no {}", printable(cell, 40), column.name,
                                is_phase ? "phase (free, stick, slip)" : "number"));
    }
    const std::string_view wrong = read_value(column, *value, record);
    if (damage.empty()) damage = wrong;
  }
  if (!damage.empty()) throw refused(lines.place(), std::string(damage));
  return record;
}

/// What a row says in the column `every`.
/// @param before  what the rows before it say; 0: it is the first
std::uint64_t read_every(const TextLines& lines, std::string_view cell, std::uint64_t before) {
  std::uint64_t every = 0;
  const char* const end = cell.data() + cell.size();
  const auto [rest, fault] = std::from_chars(cell.data(), end, every);
  if (fault != std::errc{} || rest != end || every == 0) {
    throw refused(lines.place(), fmt::format("'{}' in column '{}' is no whole number from 1",
                                             printable(cell, 40), every_name));
  }
  if (before != 0 && every != before) {
    throw refused(lines.place(),
                  fmt::format("column '{}' says {}, and {} in the row before", every_name, every, before));
  }
  return every;
}

void mark_cut(Trace& trace, const std::string& how) {
  trace.complete = false;
  trace.cut += (trace.cut.empty() ? "" : ", and ") + how;
}

/// A trace of which no row can be left: its header was being written. A line of other words is none.
void refuse_cut_header(const TextLines& lines, std::string_view header) {
  auto names = csv_cells(header, ',');
  names.pop_back();  // which may lack letters
  if (lines.ended() || !is_partial(names)) return;
  throw refused(
      lines.where(),
      fmt::format("ends within its header (line {}): no row of it is left; make it again", lines.number()));
}

/// Those made while it was touched, but for one whose line has no end.
void read_changes(const std::string& path, Trace& trace) {
  const std::string text = read_change_file(path), file = change_file_name(path);
  trace.info.changes = read_scene_changes(text, file);
  if (!text.empty() && text.back() != '\n')
    mark_cut(trace, fmt::format("lacks a change, for {} ends within a row", file));
}

}  // namespace

std::string csv_header(std::span<const TraceColumn> columns, std::uint64_t every) {
  std::string header;
  for (const TraceColumn& column : columns) {
    if (!header.empty()) header += ',';
    header += column.name;
  }
  if (every != 1) header += fmt::format(",{}", every_name);
  return header + '\n';
}

void append_csv_row(std::string& out, std::span<const TraceColumn> columns, const TickRecord& record,
                    std::uint64_t every) {
  for (const TraceColumn& column : columns) {
    if (column.kind == ColumnKind::phase) {
      out += phase_name(static_cast<Phase>(static_cast<unsigned char>(column.get(record))));
    } else {
      append_number(out, column.get(record));
    }
    out += ',';
  }
  if (every != 1)
    fmt::format_to(std::back_inserter(out), "{}\n", every);
  else
    out.back() = '\n';
}

bool is_csv_trace(const std::string& path) {
  return has_every_column(header_names(path));
}

bool is_partial_csv_trace(const std::string& path) {
  const std::vector<std::string> names = header_names(path);
  return is_partial({names.begin(), names.end()}) && !has_every_column(names);
}

namespace {

bool is_of_own_trace(const std::vector<std::string>& names) {
  const auto is_of_a_recording = [](const std::string& name) {
    return std::ranges::any_of(recording_columns,
                               [&name](const RecordingColumn& column) { return column.header == name; });
  };
  return has_every_column(names) ||
         (is_partial({names.begin(), names.end()}) && !std::ranges::all_of(names, is_of_a_recording));
}

}  // namespace

bool is_own_csv_trace(const std::string& path) {
  return is_of_own_trace(header_names(path));
}

void refuse_trace_below(const std::string& path, const std::vector<std::string>& header) {
  if (is_of_own_trace(header))
    throw refused(path,
                  "is a trace of this program below other lines: take those out, and it is read as a trace");
}

std::uint64_t every_of_csv(const std::string& path) {
  std::string_view text;
  const std::string first = first_text(path);
  text = first;
  const std::size_t end = text.find_first_of("\r\n");
  const auto names = csv_cells(text.substr(0, end), ',');
  if (names.back() != every_name || !(is_partial(names) || is_csv_trace(path))) return 1;
  text.remove_prefix(std::min(text.find_first_not_of("\r\n", end), text.size()));
  const auto cells = csv_cells(text.substr(0, text.find_first_of("\r\n")), ',');
  std::uint64_t every = 1;
  if (cells.size() == names.size())
    std::from_chars(cells.back().data(), cells.back().data() + cells.back().size(), every);
  return every;
}

Trace read_csv_trace(const std::string& path) {
  TextLines lines(path, {"a trace as CSV", std::uint64_t{2} << 30, true});
  std::string_view line;
  do {
    if (!lines.next(line)) throw refused(lines.where(), "is empty");
  } while (is_blank(line));
  if (line.starts_with("\x89HDF")) {
    throw refused(lines.where(),
                  "is an HDF5 trace, which cannot be read from a stream: name the file itself");
  }
  refuse_cut_header(lines, line);
  Trace trace;
  const auto places = find_columns(lines.place(), line, trace);
  const std::size_t cell_count = csv_cells(line, ',').size();
  const auto every_place = csv_column(line, every_name, lines.place());
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (places[k] != cell_count) tell_of(trace_columns()[k], trace.info);
  }
  if (path.ends_with(".part")) mark_cut(trace, std::string(unfinished_words));
  read_changes(path, trace);
  std::vector<std::string_view> cells;
  while (lines.next(line)) {
    if (is_blank(line)) continue;
    // The row that was under way, whatever name the recording has been given since.
    if (!lines.ended()) {
      mark_cut(trace, fmt::format("ends within a row (line {})", lines.number()));
      break;
    }
    split_csv(line, ',', cells);
    trace.rows.push_back(read_row(lines, cells, places, cell_count));
    if (every_place)
      trace.info.every = read_every(lines, cells[*every_place], trace.rows.size() > 1 ? trace.info.every : 0);
  }
  return trace;
}

}  // namespace fingerpad
