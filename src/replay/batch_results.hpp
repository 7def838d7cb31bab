#pragma once

#include <string>
#include <utility>
#include <vector>

namespace fingerpad {

/// What a folder says of one job.
struct JobOutcome {
  std::string scene;
  int number = 0;  ///< 0 of a scene without a set
  std::string mesh, motion;
  std::vector<std::pair<std::string, std::string>> values;  ///< set key and value as written
  std::string status;                                       ///< `ok`, or why it failed
  std::vector<double> figures;  ///< as summary_figure_columns(); nan where the table has no number
  std::string contact_method, contact_normals;
  std::string warnings;  ///< as the summary keeps them
  std::string trace;     ///< path; empty of a failed job, and where the folder holds none

  bool done() const { return status == "ok"; }
};

/// What a replay has left in a folder.
struct BatchResults {
  std::vector<std::string> set_keys;
  std::vector<JobOutcome> jobs;
  std::vector<std::string> files;  ///< that were read
  /// Names of figures that a table of these has no column for, as an older program's; nan in all its jobs.
  std::vector<std::string> absent_figures;
};

/// Reads `summary.csv` and `jobs.csv` of a folder, or those of all shards in it. Throws Error (refused) for a
/// folder without a summary, and for a table that cannot be read.
BatchResults read_batch_results(const std::string& folder);

/// Whether a folder has a summary, or one of a shard.
bool has_summary(const std::string& folder);

/// Why a job is looked at first: failed; then forces that are not finite, pop-throughs, unsettled ticks,
/// energy made where it is over a hundredth of the greatest normal force times the greatest depth, and last
/// the greatest normal force.
struct JobTrouble {
  std::size_t job = 0;  ///< index into BatchResults::jobs
  std::string words;    ///< "2 pop-throughs", and its warnings; empty where nothing is wrong
};

/// All jobs, the worst first; equally bad ones in the order of the batch.
std::vector<JobTrouble> worst_first(const std::vector<JobOutcome>& jobs);

}  // namespace fingerpad
