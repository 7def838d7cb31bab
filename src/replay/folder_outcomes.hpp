#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "replay/batch_results.hpp"

namespace fingerpad {

/// A scene, and a job's number in it.
using JobName = std::pair<std::string, int>;

/// What varies in each job, by its trace's name: jobs_in_folder().
using JobWords = std::map<std::string, std::string>;

/// What a folder's summaries say of its jobs; of no job where it has none.
struct FolderOutcomes {
  std::map<JobName, JobOutcome> by_job;
  std::map<std::string, JobName> by_trace;  ///< its file's name
  std::vector<std::string> absent_figures;

  bool empty() const noexcept { return by_job.empty(); }
  const JobOutcome* find(const JobName& name) const;
  bool lacks(std::string_view figure) const;
};

/// Throws Error (refused) for a folder or a table that cannot be read.
FolderOutcomes outcomes_in(const std::string& folder);

/// Whether the summaries tell of a trace's job that it ended otherwise in the other folder.
bool ended_otherwise(const std::string& trace, const FolderOutcomes& in_one, const FolderOutcomes& in_other);

/// Adds the files that are there under the name of a job's trace, whatever is in them.
void add_traces_of_jobs(const std::string& folder, const FolderOutcomes& outcomes, const JobWords& index,
                        std::set<std::string>& traces);

}  // namespace fingerpad
