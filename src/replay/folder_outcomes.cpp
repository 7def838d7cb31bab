#include "replay/folder_outcomes.hpp"

#include <algorithm>
#include <filesystem>

namespace fingerpad {

namespace fs = std::filesystem;

const JobOutcome* FolderOutcomes::find(const JobName& name) const {
  const auto found = by_job.find(name);
  return found == by_job.end() ? nullptr : &found->second;
}

bool FolderOutcomes::lacks(std::string_view figure) const {
  return std::find(absent_figures.begin(), absent_figures.end(), figure) != absent_figures.end();
}

FolderOutcomes outcomes_in(const std::string& folder) {
  FolderOutcomes outcomes;
  if (!has_summary(folder)) return outcomes;
  BatchResults results = read_batch_results(folder);
  outcomes.absent_figures = std::move(results.absent_figures);
  for (JobOutcome& job : results.jobs) {
    const JobName name(job.scene, job.number);
    if (!job.trace.empty()) outcomes.by_trace[fs::path(job.trace).filename().string()] = name;
    outcomes.by_job[name] = std::move(job);
  }
  return outcomes;
}

bool ended_otherwise(const std::string& trace, const FolderOutcomes& in_one, const FolderOutcomes& in_other) {
  const auto name = in_one.by_trace.find(trace);
  if (name == in_one.by_trace.end()) return false;
  const JobOutcome *one = in_one.find(name->second), *other = in_other.find(name->second);
  return one != nullptr && other != nullptr && one->status != other->status;
}

void add_traces_of_jobs(const std::string& folder, const FolderOutcomes& outcomes, const JobWords& index,
                        std::set<std::string>& traces) {
  const auto add = [&](const std::string& name) {
    std::error_code none;
    if (fs::is_regular_file(fs::path(folder) / name, none)) traces.insert(name);
  };
  for (const auto& [name, job] : outcomes.by_trace) add(name);
  for (const auto& [name, words] : index) add(name);
}

}  // namespace fingerpad
