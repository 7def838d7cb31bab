#include "view/compared_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <utility>

#include "base/csv_columns.hpp"
#include "base/error.hpp"
#include "base/input_file.hpp"
#include "scene/scene_differences.hpp"
#include "trace/trace.hpp"
#include "trace/trace_choice.hpp"
#include "trace/trace_column.hpp"
#include "trace/trace_folder.hpp"
#include "view/left_out_ticks.hpp"
#include "view/run_title.hpp"
#include "view/several_walls.hpp"
#include "view/touch_series.hpp"

namespace fingerpad {
namespace {

/// What differs between two scenes that have little in common is no name.
constexpr std::size_t longest_name = 60;

bool is_comparable(const TraceColumn& column) {
  return column.name != "t_s" && column.kind != ColumnKind::phase && column.kind != ColumnKind::index;
}

/// Where in a trace the ticks of another stand that has some of them; empty where one is not there.
std::vector<std::size_t> places_of(const std::vector<double>& fewer_t_s, const std::vector<double>& t_s) {
  std::vector<std::size_t> places;
  for (const double at_s : fewer_t_s) {
    if (t_s.empty() || at_s < t_s.front() || at_s > t_s.back()) continue;
    const auto place = std::lower_bound(t_s.begin(), t_s.end(), at_s);
    if (*place != at_s) return {};
    places.push_back(static_cast<std::size_t>(place - t_s.begin()));
  }
  return places;
}

std::vector<TickRecord> rows_at(const std::vector<TickRecord>& rows, const std::vector<std::size_t>& places) {
  std::vector<TickRecord> some;
  some.reserve(places.size());
  for (const std::size_t place : places) some.push_back(rows[place]);
  return some;
}

/// The way of all ticks where that of some of them is given: between two of these it goes on as their own way
/// does, or their time where that stands still.
/// @pre at least one place
std::vector<double> way_by_some(const std::vector<double>& own, const std::vector<double>& t_s,
                                const std::vector<double>& of_some, const std::vector<std::size_t>& places) {
  std::vector<double> x(own.size());
  for (std::size_t i = 0; i < places.front(); ++i) x[i] = of_some.front() + (own[i] - own[places.front()]);
  for (std::size_t k = 0; k + 1 < places.size(); ++k) {
    const std::size_t from = places[k], to = places[k + 1];
    const std::vector<double>& pace = own[to] > own[from] ? own : t_s;
    for (std::size_t i = from; i < to; ++i) {
      const double share = (pace[i] - pace[from]) / (pace[to] - pace[from]);
      x[i] = of_some[k] + share * (of_some[k + 1] - of_some[k]);
    }
  }
  for (std::size_t i = places.back(); i < own.size(); ++i)
    x[i] = of_some.back() + (own[i] - own[places.back()]);
  return x;
}

/// Tells a run's friction as traces of some of its ticks tell it, and its way as the one of fewest does.
/// @param fewer_t_s  of traces of some of this one's ticks; the fewest first
void tell_by_fewer(ComparedRun& run, const std::vector<TickRecord>& rows,
                   const std::vector<std::vector<double>>& fewer_t_s, Over over) {
  const std::vector<double> own_x = run.x;
  for (const std::vector<double>& by_t_s : fewer_t_s) {
    const std::vector<std::size_t> places = places_of(by_t_s, run.t_s);
    const std::vector<TickRecord> some = rows_at(rows, places);
    for (ComparedColumn& column : run.columns) {
      if (column.name == "friction") column.thinned.push_back({by_t_s, places, friction_along_sliding(some)});
    }
    if (over == Over::time || &by_t_s != &fewer_t_s.front()) continue;
    run.x = way_by_some(own_x, run.t_s, abscissa(some, over), places);
    run.x_by_fewer = true;
  }
}

/// @param fewer_t_s  as above
ComparedRun of_trace(const std::string& path, Over over, double from_s, double to_s,
                     const std::vector<std::vector<double>>& fewer_t_s) {
  Trace trace = read_trace(path, TraceContents::some_rows);
  refuse_no_rows(trace, path);
  if (over != Over::time) refuse_missing_columns(trace, path);
  const bool lacks_ticks = ticks_a_row(trace) > 1;
  const std::uint64_t every = trace.info.every;
  std::string ends_early = early_end_words(trace);
  const double lasts_s = trace.rows.back().t_s - trace.rows.front().t_s;
  const std::size_t file_rows = trace.rows.size();
  std::erase_if(trace.rows, [&](const TickRecord& row) { return row.t_s < from_s || row.t_s > to_s; });
  const std::string title = scene_title(trace.info, path);
  const std::string scene = trace.info.scene_name.empty() ? title : trace.info.scene_name;
  ComparedRun run{"", scene, title, path, trace.info.scene_text, true, abscissa(trace.rows, over), {}};
  refuse_standstill(run.x, over, path);
  run.t_s = abscissa(trace.rows, Over::time);
  run.lacks_ticks = lacks_ticks;
  run.several_walls = any_held_by_several_walls(trace.rows);
  run.every = every;
  run.ends_early = std::move(ends_early);
  run.lasts_s = lasts_s;
  run.file_rows = file_rows;
  for (const TraceColumn& column : trace_columns(trace.info)) {
    if (!is_comparable(column)) continue;
    ComparedColumn values{std::string(column.name), std::string(column.unit), {}};
    for (const TickRecord& row : trace.rows) values.values.push_back(column.get(row));
    run.columns.push_back(std::move(values));
  }
  if (!trace.missing.empty()) return run;
  run.columns.push_back({"friction", "N", friction_along_sliding(trace.rows)});
  run.rub = rub_line(trace.rows);
  tell_by_fewer(run, trace.rows, fewer_t_s, over);
  return run;
}

/// How many trials a table's columns tell apart; 0 where none does, by numbers.
std::size_t trials_in(const std::string& path) {
  try {
    CsvRequest request{{"trial"}, {"subject"}, {found_separator, '.'}};
    request.leaves_out_cut_row = true;
    const CsvColumns table = read_csv_columns(path, request);
    std::set<std::pair<double, double>> trials;
    for (std::size_t i = 0; i < table.lines.size(); ++i)
      trials.emplace(table.present[1] ? table.columns[1][i] : 0, table.columns[0][i]);
    return trials.size();
  } catch (const Error&) {
    return 0;
  }
}

/// Throws Error (refused) for a time that is missing or goes back.
void refuse_disorder(const std::string& path, const CsvColumns& table) {
  const std::vector<double>& times = table.columns[0];
  for (std::size_t i = 0; i < times.size(); ++i) {
    const std::string place = fmt::format("{}:{}", path, table.lines[i]);
    if (!std::isfinite(times[i])) throw refused(place, "has no time t_s: leave such rows out");
    if (i == 0 || times[i] >= times[i - 1]) continue;
    const std::size_t trials = trials_in(path);
    if (trials < 2)
      throw refused(place,
                    "its time goes back; sort the table by t_s, or where several trials follow one another, "
                    "each with a time of its own, keep the rows of one in a file of their own");
    throw refused(place,
                  fmt::format("its time begins anew: the table holds {} trials (column trial), and plot "
                              "draws one; keep the header and the rows of one in a file of their own",
                              trials));
  }
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
  request.leaves_out_cut_row = true;
  request.takes_gaps = true;  // as replay --columns writes them, where nothing is touched
  const CsvColumns table = read_csv_columns(path, request);
  if (over != Over::time)
    throw refused(path,
                  "does not tell what the finger touched (px_m to nz): only whole traces are drawn over "
                  "travel or turn, no measurements, and none that replay --columns wrote");
  const std::vector<double>& times = table.columns[0];
  if (times.empty())
    throw refused(path, table.cut.empty() ? "has a header but no rows: nothing to draw"
                                          : table.cut + "; no row of it is left");
  refuse_disorder(path, table);
  const auto within = [&](const std::vector<double>& values) {
    std::vector<double> kept;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (times[i] >= from_s && times[i] <= to_s) kept.push_back(values[i]);
    }
    return kept;
  };
  const std::string stem = std::filesystem::path(path).stem().string();
  ComparedRun run{"", stem, stem, path, "", false, within(times), {}};
  for (std::size_t i = 0; i < request.optional.size(); ++i) {
    if (!table.present[i + 1]) continue;
    run.columns.push_back({std::string(request.optional[i]), units[i], within(table.columns[i + 1])});
  }
  if (run.columns.empty())
    throw refused(path, "is no trace, and none of its columns has a trace's name (fx_n, fn_n, x_m)");
  run.ends_early = table.cut;
  run.lasts_s = times.back() - times.front();
  run.file_rows = times.size();
  run.every = every_of_csv(path);
  run.lacks_ticks = run.every > 1;
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
  refuse_false_hdf5(path);
  if (holds_trace(path)) return false;
  try {
    CsvRequest request{{"t_s"}, {}, {found_separator, '.'}};
    request.leaves_out_cut_row = true;
    read_csv_columns(path, request);
    return true;
  } catch (const Error&) {
    return false;
  }
}

ComparedRun read_compared_run(const std::string& path, Over over, double from_s, double to_s) {
  refuse_trace_folder(path);
  refuse_false_hdf5(path);
  return holds_trace(path) ? of_trace(path, over, from_s, to_s, {}) : of_table(path, over, from_s, to_s);
}

std::vector<ComparedRun> read_compared_runs(const std::vector<std::string>& paths, Over over, double from_s,
                                            double to_s) {
  std::vector<ComparedRun> runs;
  std::vector<std::vector<double>> all_t_s;  // the fewest first
  for (const std::string& path : paths) {
    runs.push_back(read_compared_run(path, over, from_s, to_s));
    const std::vector<double>& t_s = runs.back().t_s;
    if (!t_s.empty() && std::ranges::find(all_t_s, t_s) == all_t_s.end()) all_t_s.push_back(t_s);
  }
  std::ranges::stable_sort(all_t_s, {}, [](const std::vector<double>& t_s) { return t_s.size(); });
  for (std::size_t i = 0; i < runs.size(); ++i) {
    std::vector<std::vector<double>> fewer_t_s = all_t_s;
    std::erase_if(fewer_t_s, [&](const auto& t_s) {
      return t_s.size() >= runs[i].t_s.size() || places_of(t_s, runs[i].t_s).empty();
    });
    // A stream cannot be read again.
    if (!fewer_t_s.empty() && !stream_descriptor(paths[i]))
      runs[i] = of_trace(paths[i], over, from_s, to_s, fewer_t_s);
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
