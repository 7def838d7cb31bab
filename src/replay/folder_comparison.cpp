#include "replay/folder_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include "base/content_hash.hpp"
#include "base/error.hpp"
#include "base/path_words.hpp"
#include "replay/batch_results.hpp"
#include "replay/summary_column.hpp"
#include "trace/job_index.hpp"
#include "trace/trace.hpp"
#include "trace/trace_column.hpp"

namespace fingerpad {
namespace {

namespace fs = std::filesystem;

/// The traces in a folder, by name.
std::set<std::string> traces_in(const std::string& folder) {
  std::set<std::string> names;
  std::error_code failure;
  for (fs::directory_iterator at(folder, failure); !failure && at != fs::directory_iterator();
       at.increment(failure)) {
    std::error_code none;
    if (!at->is_regular_file(none)) continue;
    const std::string path = at->path().string();
    if (path.ends_with(".h5") ||
        (path.ends_with(".csv") && (is_csv_trace(path) || is_partial_csv_trace(path))))
      names.insert(at->path().filename().string());
  }
  if (failure) throw refused(folder, "cannot be read: " + path_words(folder, failure.value()));
  return names;
}

/// How far a column of two traces is apart.
struct ColumnChange {
  std::size_t ticks = 0;
  double most = 0, at_s = 0;
};

/// 0 for equal numbers and two that are none; infinite where only one is none.
double distance_between(double a, double b) {
  if (a == b || (std::isnan(a) && std::isnan(b))) return 0;
  const double apart = std::abs(a - b);
  return std::isnan(apart) ? HUGE_VAL : apart;
}

ColumnChange change_of(const TraceColumn& column, const Trace& a, const Trace& b, double tolerance) {
  ColumnChange change;
  for (std::size_t i = 0; i < std::min(a.rows.size(), b.rows.size()); ++i) {
    const double apart = distance_between(column.get(a.rows[i]), column.get(b.rows[i]));
    if (!(apart > tolerance)) continue;
    ++change.ticks;
    if (apart <= change.most) continue;
    change.most = apart;
    change.at_s = a.rows[i].t_s;
  }
  return change;
}

/// "s-0003.h5 (mu_static 0.3)".
std::string name_of_job(const std::string& folder, const std::string& name) {
  const std::string varied = varied_in_job((fs::path(folder) / name).string());
  return varied.empty() ? name : fmt::format("{} ({})", name, varied);
}

/// Whether a trace was written without the column.
bool lacks(const Trace& trace, const TraceColumn& column) {
  return std::find(trace.missing.begin(), trace.missing.end(), column.name) != trace.missing.end();
}

/// Adds a line for each column that differs. @returns whether any does
bool compare_traces(const std::string& job, const Trace& a, const Trace& b, double tolerance,
                    std::vector<std::string>& changes) {
  const std::size_t before = changes.size();
  if (a.rows.size() != b.rows.size())
    changes.push_back(fmt::format("{}: {} ticks, then {}", job, a.rows.size(), b.rows.size()));
  for (const TraceColumn& column : trace_columns()) {
    const bool lacks_a = lacks(a, column), lacks_b = lacks(b, column);
    if (lacks_a != lacks_b)
      changes.push_back(
          fmt::format("{}: {} is in the {} trace alone", job, column.name, lacks_a ? "second" : "first"));
    if (lacks_a || lacks_b) continue;
    const ColumnChange change = change_of(column, a, b, tolerance);
    if (change.ticks == 0) continue;
    const std::string unit = column.unit == "1" ? "" : " " + std::string(column.unit);
    const std::string most = std::isinf(change.most) ? "from a number to none"
                                                     : fmt::format("by up to {:.6g}{}", change.most, unit);
    changes.push_back(fmt::format("{}: {} differs {} at t = {:.6g} s, in {} of {} ticks", job, column.name,
                                  most, change.at_s, change.ticks, std::min(a.rows.size(), b.rows.size())));
  }
  return changes.size() > before;
}

using OutcomesByJob = std::map<std::pair<std::string, int>, JobOutcome>;

/// The jobs of a folder's summaries; none where it has none.
OutcomesByJob outcomes_in(const std::string& folder) {
  OutcomesByJob outcomes;
  if (!has_summary(folder)) return outcomes;
  for (JobOutcome& job : read_batch_results(folder).jobs) {
    const std::pair key(job.scene, job.number);
    outcomes[key] = std::move(job);
  }
  return outcomes;
}

/// "s job 3 (seed 3)".
std::string words_of(const JobOutcome& job) {
  std::string values;
  for (const auto& [key, value] : job.values) values += (values.empty() ? "" : ", ") + key + " " + value;
  const std::string name = job.number > 0 ? fmt::format("{} job {}", job.scene, job.number) : job.scene;
  return values.empty() ? name : fmt::format("{} ({})", name, values);
}

void compare_figures(const JobOutcome& a, const JobOutcome& b, double tolerance,
                     std::vector<std::string>& changes) {
  const auto columns = summary_figure_columns();
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (!(distance_between(a.figures[i], b.figures[i]) > tolerance)) continue;
    changes.push_back(fmt::format("{}: {} was {:.9g}, is {:.9g}{}", words_of(a), columns[i].name,
                                  a.figures[i], b.figures[i],
                                  columns[i].unit == "1" ? "" : " " + std::string(columns[i].unit)));
  }
}

/// Jobs whose status differs or which one folder's summary does not have; and where there are no traces their
/// figures.
void compare_outcomes(const OutcomesByJob& in_a, const OutcomesByJob& in_b, bool has_traces, double tolerance,
                      FolderComparison& comparison) {
  std::set<std::pair<std::string, int>> all;
  for (const auto& [key, job] : in_a) all.insert(key);
  for (const auto& [key, job] : in_b) all.insert(key);
  for (const auto& key : all) {
    const auto a = in_a.find(key), b = in_b.find(key);
    const std::size_t before = comparison.changes.size();
    if (a == in_a.end() || b == in_b.end()) {
      // A summary that is not there says nothing of its jobs.
      if (!in_a.empty() && !in_b.empty())
        comparison.changes.push_back(fmt::format("{}: is in the {} summary alone",
                                                 words_of(a == in_a.end() ? b->second : a->second),
                                                 a == in_a.end() ? "second" : "first"));
    } else if (a->second.status != b->second.status) {
      comparison.changes.push_back(
          fmt::format("{}: was '{}', is '{}'", words_of(a->second), a->second.status, b->second.status));
    } else if (!has_traces) {
      compare_figures(a->second, b->second, tolerance, comparison.changes);
    }
    if (!has_traces) comparison.changed += comparison.changes.size() > before ? 1 : 0;
  }
  if (!has_traces) comparison.jobs = all.size();
}

}  // namespace

FolderComparison compare_folders(const std::string& folder_a, const std::string& folder_b, double tolerance) {
  const std::set<std::string> in_a = traces_in(folder_a), in_b = traces_in(folder_b);
  std::set<std::string> all = in_a;
  all.insert(in_b.begin(), in_b.end());
  const OutcomesByJob outcomes_a = outcomes_in(folder_a), outcomes_b = outcomes_in(folder_b);
  if (all.empty() && (outcomes_a.empty() || outcomes_b.empty()))
    throw refused(outcomes_a.empty() ? folder_a : folder_b,
                  "holds neither traces nor a summary to compare with the other folder's");
  FolderComparison comparison;
  comparison.traces = all.size();
  for (const std::string& name : all) {
    const bool both = in_a.contains(name) && in_b.contains(name);
    const std::string job = name_of_job(in_a.contains(name) ? folder_a : folder_b, name);
    if (!both) {
      ++comparison.changed;
      comparison.changes.push_back(
          fmt::format("{}: is in {} alone", job, in_a.contains(name) ? folder_a : folder_b));
      continue;
    }
    const std::string a = (fs::path(folder_a) / name).string(), b = (fs::path(folder_b) / name).string();
    if (file_hash(a) == file_hash(b)) continue;
    const bool changed =
        compare_traces(job, read_trace(a, TraceContents::some_rows), read_trace(b, TraceContents::some_rows),
                       tolerance, comparison.changes);
    comparison.changed += changed ? 1 : 0;
  }
  compare_outcomes(outcomes_a, outcomes_b, !all.empty(), tolerance, comparison);
  return comparison;
}

}  // namespace fingerpad
