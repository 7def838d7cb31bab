#include "trace/csv_rows.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/error.hpp"
#include "base/number_text.hpp"
#include "base/text_lines.hpp"
#include "trace/trace_row.hpp"

namespace fingerpad {
namespace {

std::vector<std::string_view> cells_of(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  std::vector<std::string_view> cells;
  while (true) {
    const std::size_t comma = line.find(',');
    cells.push_back(line.substr(0, comma));
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

/// Where each column of a trace stands in the file.
std::array<std::size_t, trace_column_count> find_columns(const std::string& where, std::string_view header) {
  const auto names = cells_of(header);
  std::array<std::size_t, trace_column_count> places{};
  for (std::size_t k = 0; k < trace_column_count; ++k) {
    const std::string_view wanted = trace_columns()[k].name;
    while (places[k] < names.size() && names[places[k]] != wanted) ++places[k];
    if (places[k] == names.size()) {
      throw refused(where, fmt::format("is no trace: it has no column '{}'", wanted));
    }
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

TickRecord read_row(const TextLines& lines, std::string_view line,
                    const std::array<std::size_t, trace_column_count>& places, std::size_t cell_count) {
  const auto cells = cells_of(line);
  if (cells.size() != cell_count) {
    throw refused(lines.place(),
                  fmt::format("has {} cells, but the header has {}", cells.size(), cell_count));
  }
  TraceRow row{};
  for (std::size_t k = 0; k < trace_column_count; ++k) {
    const std::string_view cell = cells[places[k]];
    const auto value = k == phase_column ? phase_number(cell) : parse_number(cell);
    if (!value) {
      throw refused(lines.place(),
                    fmt::format("'{}' in column '{}' is no {}", cell.substr(0, 40), trace_columns()[k].name,
                                k == phase_column ? "phase (free, stick, slip)" : "number"));
    }
    row[k] = *value;
  }
  if (const std::string_view damage = row_damage(row); !damage.empty())
    throw refused(lines.place(), std::string(damage));
  return to_record(row);
}

}  // namespace

std::string csv_header() {
  std::string header;
  for (const TraceColumn& column : trace_columns()) {
    if (!header.empty()) header += ',';
    header += column.name;
  }
  return header + '\n';
}

void append_csv_row(std::string& out, const TickRecord& record) {
  const TraceRow row = to_row(record);
  for (std::size_t k = 0; k < trace_column_count; ++k) {
    if (k > 0) out += ',';
    if (k == phase_column) {
      out += phase_name(record.phase);
    } else {
      append_number(out, row[k]);
    }
  }
  out += '\n';
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
  const auto places = find_columns(lines.place(), line);
  const std::size_t cell_count = cells_of(line).size();
  Trace trace;
  trace.complete = !path.ends_with(".part");
  while (lines.next(line)) {
    if (!lines.ended() && !trace.complete) break;  // the row that was under way
    if (is_blank(line)) continue;
    trace.rows.push_back(read_row(lines, line, places, cell_count));
  }
  return trace;
}

}  // namespace fingerpad
