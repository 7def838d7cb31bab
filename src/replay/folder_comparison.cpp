#include "replay/folder_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "base/content_hash.hpp"
#include "base/error.hpp"
#include "base/number_text.hpp"
#include "replay/folder_outcomes.hpp"
#include "replay/passed_over.hpp"
#include "replay/summary_column.hpp"
#include "replay/trace_comparison.hpp"
#include "replay/trace_pairs.hpp"
#include "trace/job_index.hpp"
#include "trace/trace.hpp"
#include "trace/trace_glance.hpp"

namespace fingerpad {
namespace {

namespace fs = std::filesystem;

/// "s-0003.h5 (plate.stl, mu_static 0.3)", and what it is in the other folder where that is another job.
std::string name_of_job(const JobWords& in_a, const JobWords& in_b, const TracePair& pair) {
  const auto words_in = [](const JobWords& index, const std::string& file) {
    const auto known = index.find(file);
    return known == index.end() ? std::string() : known->second;
  };
  const std::string &name = pair.name(), was = words_in(in_a, pair.a), is = words_in(in_b, pair.b);
  if (was.empty() && is.empty()) return name;
  if (was.empty() || is.empty() || was == is) return fmt::format("{} ({})", name, was.empty() ? is : was);
  return fmt::format("{} ({}; now {})", name, was, is);
}

/// Gathers what differs, and passes it on.
class Changes {
 public:
  Changes(FolderComparison& comparison, const std::function<void(ChangedJob&&)>& on_changed)
      : comparison_(comparison), on_changed_(on_changed) {}

  /// @param is_another  the job itself differs, not what came of it
  void tell(std::string job, std::vector<JobChange> changes, bool is_another) {
    if (changes.empty()) return;
    ChangedJob changed{std::move(job), std::move(changes), is_another ? HUGE_VAL : 0, ""};
    for (const JobChange& change : changed.changes) {
      if (change.unit == "N") changed.force_n = std::max(changed.force_n, change.most);
    }
    pass_on(std::move(changed));
  }

  /// What is no change of a job.
  void note(std::string of_what, std::vector<JobChange> changes) {
    if (changes.empty()) return;
    ++comparison_.notes;
    on_changed_({std::move(of_what), std::move(changes), HUGE_VAL, ""});
  }

  /// Of a job that one folder alone has.
  void tell_alone(std::string job, const std::string& where) {
    const std::string words = fmt::format("is in {} alone", where);
    pass_on({std::move(job), {whole_change(words)}, HUGE_VAL, words});
  }

 private:
  void pass_on(ChangedJob&& changed) {
    ++comparison_.differing;
    on_changed_(std::move(changed));
  }

  FolderComparison& comparison_;
  const std::function<void(ChangedJob&&)>& on_changed_;
};

/// "s job 3 (seed 3)".
std::string words_of(const JobOutcome& job) {
  std::string values;
  for (const auto& [key, value] : job.values)
    values += fmt::format("{}{} {}", values.empty() ? "" : ", ", key, value);
  const std::string name = job.number > 0 ? fmt::format("{} job {}", job.scene, job.number) : job.scene;
  return values.empty() ? name : fmt::format("{} ({})", name, values);
}

std::vector<JobChange> figure_changes(const JobOutcome& a, const JobOutcome& b, const FolderOutcomes& in_a,
                                      const FolderOutcomes& in_b, double tolerance) {
  std::vector<JobChange> changes;
  const auto columns = summary_figure_columns();
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (in_a.lacks(columns[i].name) || in_b.lacks(columns[i].name)) continue;
    const double apart = distance_between(a.figures[i], b.figures[i]);
    if (!(apart > tolerance)) continue;
    changes.push_back({std::string(columns[i].name),
                       fmt::format("{} was {}, is {}{}", columns[i].name, rounded_text(a.figures[i], 9),
                                   rounded_text(b.figures[i], 9),
                                   columns[i].unit == "1" ? "" : " " + std::string(columns[i].unit)),
                       apart, columns[i].unit, TickRecord::nan});
  }
  return changes;
}

/// Figures that one summary alone has a column for, as where another version wrote it: they are not compared.
void tell_absent_figures(const FolderOutcomes& in_a, const FolderOutcomes& in_b, Changes& found) {
  std::vector<JobChange> changes;
  for (const SummaryColumn& column : summary_figure_columns()) {
    const bool lacks_a = in_a.lacks(column.name);
    if (lacks_a == in_b.lacks(column.name)) continue;
    changes.push_back(whole_change(fmt::format("{} is in the {} summary alone, and not compared", column.name,
                                               lacks_a ? "second" : "first")));
  }
  found.note("summary.csv", std::move(changes));
}

/// Jobs whose status differs or which one folder's summary does not have; and where there are no traces their
/// figures.
void compare_outcomes(const FolderOutcomes& in_a, const FolderOutcomes& in_b, bool has_traces,
                      double tolerance, FolderComparison& comparison, Changes& found) {
  std::set<JobName> all;
  for (const auto& [name, job] : in_a.by_job) all.insert(name);
  for (const auto& [name, job] : in_b.by_job) all.insert(name);
  for (const JobName& name : all) {
    const JobOutcome *a = in_a.find(name), *b = in_b.find(name);
    if (a == nullptr || b == nullptr) {
      const JobOutcome& job = a == nullptr ? *b : *a;
      // A summary that is not there says nothing of its jobs; a trace that is alone has been told.
      if (in_a.empty() || in_b.empty() || (has_traces && !job.trace.empty())) continue;
      comparison.changed += has_traces ? 0 : 1;
      found.tell_alone(words_of(job), fmt::format("the {} summary", a == nullptr ? "second" : "first"));
      continue;
    }
    std::vector<JobChange> changes;
    const bool is_another = a->status != b->status;
    if (is_another) {
      changes.push_back(whole_change(fmt::format("was '{}', is '{}'", a->status, b->status)));
    } else if (!has_traces) {
      changes = figure_changes(*a, *b, in_a, in_b, tolerance);
    }
    if (!has_traces) comparison.changed += changes.empty() ? 0 : 1;
    found.tell(words_of(*a), std::move(changes), is_another);
  }
  if (has_traces) return;
  comparison.jobs = all.size();
  tell_absent_figures(in_a, in_b, found);
}

/// Without traces on both sides it takes both summaries.
void refuse_nothing_to_compare(const std::string& folder, const std::set<std::string>& traces,
                               const FolderOutcomes& outcomes, const std::string& other,
                               const FolderOutcomes& of_other) {
  if (!traces.empty() || (!outcomes.empty() && !of_other.empty())) return;
  if (outcomes.empty()) throw refused(folder, "holds no traces, and no summary of jobs: nothing to compare");
  throw refused(folder, fmt::format("holds no traces, and {} no summary of jobs to compare by", other));
}

/// Where the folders hold the traces of the same jobs in unlike formats.
void tell_formats(const std::string& folder_a, const std::string& folder_b,
                  const std::vector<TracePair>& pairs, Changes& found) {
  for (const bool is_hdf5 : {true, false}) {
    const auto count = std::count_if(pairs.begin(), pairs.end(), [is_hdf5](const TracePair& pair) {
      return pair.are_of_two_formats() && pair.a.ends_with(".h5") == is_hdf5;
    });
    if (count == 0) continue;
    found.note(folder_a,
               {whole_change(fmt::format("{} {} {} here and {} in {}: the numbers in them are compared",
                                         count, count == 1 ? "trace is" : "traces are",
                                         is_hdf5 ? "HDF5" : "CSV", is_hdf5 ? "CSV" : "HDF5", folder_b))});
  }
}

/// A trace as compare takes it; where it cannot be read, that is what is told of its job.
std::optional<Trace> read_or_tell(const std::string& path, std::vector<JobChange>& changes,
                                  FolderComparison& comparison) {
  try {
    return read_trace(path, TraceContents::some_rows);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::refused) throw;
    changes.push_back(whole_change(fmt::format("cannot be compared: {}", error.what())));
    comparison.damaged.emplace_back(error.what());
    return std::nullopt;
  }
}

/// What differs between two traces of a job.
std::vector<JobChange> changes_of(const std::string& a, const std::string& b, bool are_of_two_formats,
                                  double tolerance, FolderComparison& comparison) {
  std::vector<JobChange> unread;
  const auto in_a = read_or_tell(a, unread, comparison), in_b = read_or_tell(b, unread, comparison);
  if (!unread.empty()) return unread;
  for (const auto& [path, trace] : {std::pair(&a, &in_a), std::pair(&b, &in_b)}) {
    const std::string words = early_end_words(**trace);
    if (!words.empty()) comparison.early_ends.push_back(fmt::format("{}: {}", *path, words));
  }
  return trace_changes(*in_a, *in_b, tolerance, are_of_two_formats);
}

}  // namespace

FolderComparison compare_folders(const std::string& folder_a, const std::string& folder_b, double tolerance,
                                 const std::function<void(ChangedJob&&)>& on_changed) {
  const FolderOutcomes outcomes_a = outcomes_in(folder_a), outcomes_b = outcomes_in(folder_b);
  const auto jobs_a = jobs_in_folder(folder_a), jobs_b = jobs_in_folder(folder_b);
  std::set<std::string> in_a = traces_in(folder_a), in_b = traces_in(folder_b);
  add_traces_of_jobs(folder_a, outcomes_a, jobs_a, in_a);
  add_traces_of_jobs(folder_b, outcomes_b, jobs_b, in_b);
  add_damaged(folder_a, in_b, in_a);
  add_damaged(folder_b, in_a, in_b);
  refuse_nothing_to_compare(folder_a, in_a, outcomes_a, folder_b, outcomes_b);
  refuse_nothing_to_compare(folder_b, in_b, outcomes_b, folder_a, outcomes_a);
  std::vector<TracePair> pairs = trace_pairs(in_a, in_b);
  FolderComparison comparison;
  Changes found(comparison, on_changed);
  if (in_a.empty() != in_b.empty()) {
    found.note("summary.csv",
               {whole_change(fmt::format("the other folder has no traces, as of --format none: "
                                         "those of {} are not compared",
                                         in_a.empty() ? folder_b : folder_a))});
    pairs.clear();
  }
  tell_formats(folder_a, folder_b, pairs, found);
  comparison.traces = pairs.size();
  for (const auto& [folder, traces] : {std::pair(&folder_a, &in_a), std::pair(&folder_b, &in_b)}) {
    for (std::string& words : passed_over_words(*folder, *traces))
      comparison.passed_over.push_back(std::move(words));
  }
  for (const TracePair& pair : pairs) {
    if (pair.a.empty() || pair.b.empty()) {
      ++comparison.changed;
      const bool is_in_a = pair.b.empty();
      const bool told = is_in_a ? ended_otherwise(pair.a, outcomes_a, outcomes_b)
                                : ended_otherwise(pair.b, outcomes_b, outcomes_a);
      if (!told) found.tell_alone(name_of_job(jobs_a, jobs_b, pair), is_in_a ? folder_a : folder_b);
      continue;
    }
    const std::string a = (fs::path(folder_a) / pair.a).string(), b = (fs::path(folder_b) / pair.b).string();
    if (file_hash(a) == file_hash(b) && looks_whole(a)) continue;
    std::vector<JobChange> changes = changes_of(a, b, pair.are_of_two_formats(), tolerance, comparison);
    comparison.changed += changes.empty() ? 0 : 1;
    found.tell(name_of_job(jobs_a, jobs_b, pair), std::move(changes), false);
  }
  compare_outcomes(outcomes_a, outcomes_b, !pairs.empty(), tolerance, comparison, found);
  return comparison;
}

}  // namespace fingerpad
