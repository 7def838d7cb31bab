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
#include "replay/trace_comparison.hpp"
#include "trace/job_index.hpp"
#include "trace/trace.hpp"

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

using JobWords = std::map<std::string, std::string>;

/// "s-0003.h5 (plate.stl, mu_static 0.3)", and what it is in the other folder where that is another job.
std::string name_of_job(const JobWords& in_a, const JobWords& in_b, const std::string& name) {
  const auto words_in = [&](const JobWords& index) {
    const auto known = index.find(name);
    return known == index.end() ? std::string() : known->second;
  };
  const std::string was = words_in(in_a), is = words_in(in_b);
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
    ChangedJob changed{std::move(job), std::move(changes), is_another ? HUGE_VAL : 0};
    for (const JobChange& change : changed.changes) {
      if (change.unit == "N") changed.force_n = std::max(changed.force_n, change.most);
    }
    ++comparison_.differing;
    on_changed_(std::move(changed));
  }

 private:
  FolderComparison& comparison_;
  const std::function<void(ChangedJob&&)>& on_changed_;
};

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
  for (const auto& [key, value] : job.values)
    values += fmt::format("{}{} {}", values.empty() ? "" : ", ", key, value);
  const std::string name = job.number > 0 ? fmt::format("{} job {}", job.scene, job.number) : job.scene;
  return values.empty() ? name : fmt::format("{} ({})", name, values);
}

std::vector<JobChange> figure_changes(const JobOutcome& a, const JobOutcome& b, double tolerance) {
  std::vector<JobChange> changes;
  const auto columns = summary_figure_columns();
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const double apart = distance_between(a.figures[i], b.figures[i]);
    if (!(apart > tolerance)) continue;
    changes.push_back({std::string(columns[i].name),
                       fmt::format("{} was {:.9g}, is {:.9g}{}", columns[i].name, a.figures[i], b.figures[i],
                                   columns[i].unit == "1" ? "" : " " + std::string(columns[i].unit)),
                       apart, columns[i].unit, TickRecord::nan});
  }
  return changes;
}

/// Jobs whose status differs or which one folder's summary does not have; and where there are no traces their
/// figures.
void compare_outcomes(const OutcomesByJob& in_a, const OutcomesByJob& in_b, bool has_traces, double tolerance,
                      FolderComparison& comparison, Changes& found) {
  std::set<std::pair<std::string, int>> all;
  for (const auto& [key, job] : in_a) all.insert(key);
  for (const auto& [key, job] : in_b) all.insert(key);
  for (const auto& key : all) {
    const auto a = in_a.find(key), b = in_b.find(key);
    const JobOutcome& job = a == in_a.end() ? b->second : a->second;
    std::vector<JobChange> changes;
    const bool is_another = a == in_a.end() || b == in_b.end() || a->second.status != b->second.status;
    if (a == in_a.end() || b == in_b.end()) {
      // A summary that is not there says nothing of its jobs.
      if (!in_a.empty() && !in_b.empty())
        changes.push_back(
            whole_change(fmt::format("is in the {} summary alone", a == in_a.end() ? "second" : "first")));
    } else if (a->second.status != b->second.status) {
      changes.push_back(whole_change(fmt::format("was '{}', is '{}'", a->second.status, b->second.status)));
    } else if (!has_traces) {
      changes = figure_changes(a->second, b->second, tolerance);
    }
    if (!has_traces) comparison.changed += changes.empty() ? 0 : 1;
    found.tell(words_of(job), std::move(changes), is_another);
  }
  if (!has_traces) comparison.jobs = all.size();
}

}  // namespace

FolderComparison compare_folders(const std::string& folder_a, const std::string& folder_b, double tolerance,
                                 const std::function<void(ChangedJob&&)>& on_changed) {
  const std::set<std::string> in_a = traces_in(folder_a), in_b = traces_in(folder_b);
  std::set<std::string> all = in_a;
  all.insert(in_b.begin(), in_b.end());
  const OutcomesByJob outcomes_a = outcomes_in(folder_a), outcomes_b = outcomes_in(folder_b);
  if (all.empty() && (outcomes_a.empty() || outcomes_b.empty()))
    throw refused(outcomes_a.empty() ? folder_a : folder_b,
                  "holds neither traces nor a summary to compare with the other folder's");
  FolderComparison comparison;
  Changes found(comparison, on_changed);
  comparison.traces = all.size();
  const auto jobs_a = jobs_in_folder(folder_a), jobs_b = jobs_in_folder(folder_b);
  for (const std::string& name : all) {
    const bool is_in_a = in_a.contains(name);
    std::vector<JobChange> changes;
    const bool is_alone = !is_in_a || !in_b.contains(name);
    if (is_alone) {
      changes.push_back(whole_change(fmt::format("is in {} alone", is_in_a ? folder_a : folder_b)));
    } else {
      const std::string a = (fs::path(folder_a) / name).string(), b = (fs::path(folder_b) / name).string();
      if (file_hash(a) == file_hash(b)) continue;
      changes = trace_changes(read_trace(a, TraceContents::some_rows),
                              read_trace(b, TraceContents::some_rows), tolerance);
    }
    comparison.changed += changes.empty() ? 0 : 1;
    found.tell(name_of_job(jobs_a, jobs_b, name), std::move(changes), is_alone);
  }
  compare_outcomes(outcomes_a, outcomes_b, !all.empty(), tolerance, comparison, found);
  return comparison;
}

}  // namespace fingerpad
