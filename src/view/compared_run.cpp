#include "view/compared_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "base/csv_columns.hpp"
#include "base/error.hpp"
#include "base/input_file.hpp"
#include "scene/scene_differences.hpp"
#include "trace/trace.hpp"
#include "trace/trace_choice.hpp"
#include "trace/trace_column.hpp"
#include "view/left_out_ticks.hpp"
#include "view/run_title.hpp"
#include "view/touch_series.hpp"

namespace fingerpad {
namespace {

/// What differs between two scenes that have little in common is no name.
constexpr std::size_t longest_name = 60;

bool is_comparable(const TraceColumn& column) {
  return column.name != "t_s" && column.kind != ColumnKind::phase && column.kind != ColumnKind::index;
}

/// As one run is drawn: a straight rub over a flat place along the world's axis, or every reversal that falls
/// between two ticks would count as twice the friction.
std::vector<double> friction_of(const std::vector<TickRecord>& rows) {
  return touch_series(rows, main_direction(rows)).friction_n;
}

/// The rows of every so manieth tick and of the last, as a trace of these alone has them.
std::vector<TickRecord> thinned_rows(const std::vector<TickRecord>& rows, std::uint64_t every) {
  std::vector<TickRecord> kept;
  const auto last = static_cast<long>(rows.size()) - 1;
  for (long k = 0; k <= last; ++k) {
    if (is_kept(k, last, every)) kept.push_back(rows[static_cast<std::size_t>(k)]);
  }
  return kept;
}

/// Values of some of the rows, at their places among all; nan at the others.
std::vector<double> among_all(const std::vector<TickRecord>& some, const std::vector<double>& values,
                              const std::vector<TickRecord>& all) {
  std::vector<double> out(all.size(), TickRecord::nan);
  for (std::size_t i = 0, k = 0; i < all.size() && k < some.size(); ++i) {
    if (all[i].t_s == some[k].t_s) out[i] = values[k++];
  }
  return out;
}

/// @param every  of the trace that has the fewest ticks
ComparedRun of_trace(const std::string& path, Over over, double from_s, double to_s, std::uint64_t every) {
  Trace trace = read_trace(path, TraceContents::rows);
  const auto is_left_out = [&](const TickRecord& row) { return row.t_s < from_s || row.t_s > to_s; };
  const std::uint64_t own_every = ticks_a_row(trace);
  std::vector<TickRecord> fewer;
  if (every > own_every && every % own_every == 0) fewer = thinned_rows(trace.rows, every / own_every);
  std::erase_if(fewer, is_left_out);
  std::erase_if(trace.rows, is_left_out);
  const std::string title = scene_title(trace.info, path);
  const std::string scene = trace.info.scene_name.empty() ? title : trace.info.scene_name;
  ComparedRun run{"", scene, title, path, trace.info.scene_text, true, own_every, abscissa(trace.rows, over),
                  {}};
  refuse_standstill(run.x, over, path);
  for (const TraceColumn& column : trace_columns(trace.info)) {
    if (!is_comparable(column)) continue;
    ComparedColumn values{std::string(column.name), std::string(column.unit), {}};
    for (const TickRecord& row : trace.rows) values.values.push_back(column.get(row));
    run.columns.push_back(std::move(values));
  }
  run.columns.push_back({"friction", "N", friction_of(trace.rows)});
  if (!fewer.empty() && over == Over::time)
    run.columns.back().thinned = among_all(fewer, friction_of(fewer), trace.rows);
  return run;
}

ComparedRun of_table(const std::string& path, Over over, double from_s, double to_s) {
  CsvRequest request{
      {"t_s"},
      {},
      {found_separator, '.'},
      TableSource::file,
      "plot takes traces, and tables with t_s and columns named as a trace's (fx_n, fn_n, x_m)"};
  std::vector<std::string> units;
  for (const TraceColumn& column : trace_columns()) {
    if (!is_comparable(column)) continue;
    request.optional.push_back(column.name);
    units.emplace_back(column.unit);
  }
  const CsvColumns table = read_csv_columns(path, request);
  if (over != Over::time)
    throw refused(path,
                  "is a table of measurements, which does not tell what the finger touched: only "
                  "traces are drawn over travel or turn");
  const std::vector<double>& times = table.columns[0];
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (times[i] >= times[i - 1]) continue;
    throw refused(fmt::format("{}:{}", path, table.lines[i]), "its time goes back; sort the table by t_s");
  }
  const auto within = [&](const std::vector<double>& values) {
    std::vector<double> kept;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (times[i] >= from_s && times[i] <= to_s) kept.push_back(values[i]);
    }
    return kept;
  };
  const std::string stem = std::filesystem::path(path).stem().string();
  ComparedRun run{"", stem, stem, path, "", false, 1, within(times), {}};
  for (std::size_t i = 0; i < request.optional.size(); ++i) {
    if (!table.present[i + 1]) continue;
    run.columns.push_back({std::string(request.optional[i]), units[i], within(table.columns[i + 1])});
  }
  if (run.columns.empty())
    throw refused(path, "is no trace, and none of its columns has a trace's name (fx_n, fn_n, x_m)");
  return run;
}

bool holds_trace(const std::string& path) {
  return stream_descriptor(path) || is_hdf5(path) || is_csv_trace(path);
}

bool all_differ(const std::vector<std::string>& words) {
  return std::set<std::string>(words.begin(), words.end()).size() == words.size();
}

}  // namespace

bool is_measured_table(const std::string& path) {
  if (holds_trace(path)) return false;
  try {
    read_csv_columns(path, {{"t_s"}, {}, {found_separator, '.'}});
    return true;
  } catch (const Error&) {
    return false;
  }
}

ComparedRun read_compared_run(const std::string& path, Over over, double from_s, double to_s) {
  return holds_trace(path) ? of_trace(path, over, from_s, to_s, 1) : of_table(path, over, from_s, to_s);
}

std::vector<ComparedRun> read_compared_runs(const std::vector<std::string>& paths, Over over, double from_s,
                                            double to_s) {
  std::vector<ComparedRun> runs;
  std::uint64_t every = 1;
  for (const std::string& path : paths) {
    runs.push_back(read_compared_run(path, over, from_s, to_s));
    every = std::max(every, runs.back().every);
  }
  for (std::size_t i = 0; i < runs.size(); ++i) {
    // A stream cannot be read again.
    if (runs[i].is_trace && runs[i].every < every && !stream_descriptor(paths[i]))
      runs[i] = of_trace(paths[i], over, from_s, to_s, every);
  }
  return runs;
}

void name_apart(std::vector<ComparedRun>& runs) {
  if (std::all_of(runs.begin(), runs.end(), [](const ComparedRun& run) { return !run.name.empty(); })) return;
  std::vector<std::string> texts, stems, paths;
  for (const ComparedRun& run : runs) {
    texts.push_back(run.scene_text);
    stems.push_back(std::filesystem::path(run.path).stem().string());
    paths.push_back(run.path);
  }
  const bool any_unknown =
      std::any_of(texts.begin(), texts.end(), [](const auto& text) { return text.empty(); });
  std::vector<std::string> names = any_unknown ? stems : scene_differences(texts);
  const bool any_long =
      std::any_of(names.begin(), names.end(), [](const auto& name) { return name.size() > longest_name; });
  if (any_long || !all_differ(names)) names = all_differ(stems) ? stems : paths;
  for (std::size_t i = 0; i < runs.size(); ++i) runs[i].name = names[i];
}

}  // namespace fingerpad
