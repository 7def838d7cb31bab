#pragma once

#include <string>
#include <vector>

#include "replay/batch.hpp"

namespace fingerpad {

/// One job as it would be run.
struct PlannedJob {
  std::string file, mesh, motion;
  std::string values;  ///< its set keys: "mu_static 0.3, law dahl"
  long ticks = 0;
  std::string error;  ///< why it would fail, as far as that is seen before the run; empty if nothing is
};

/// What a batch would take.
struct BatchPlan {
  std::vector<PlannedJob> jobs;  ///< of this call's shard
  double ticks = 0;
  double seconds = 0;  ///< on the batch's threads
  double bytes = 0;
  std::string bytes_unknown = {};  ///< why they are not, if so: what the folder for temporary files said
  std::vector<std::string> warnings = {};  ///< of its motions' files, each once
  int measured = 0, kinds = 0;  ///< of so many kinds of jobs, by their parts and contact, so many were tried
  int not_laid = 0;  ///< jobs of which it was not seen whether their motion can be laid on the part
};

/// Plans a batch without writing into its folder. The ticks are counted; time and disk are reckoned from a
/// short try of one job for each set of parts with its contact method, at most eight, from the smallest mesh
/// to the largest (where that job fails, of the next that does not), whose trace goes to the system's folder
/// for temporary files and is removed again. Of further kinds a tick is taken for an average one, loading and
/// disk go by the size of their meshes' files. On the parts that are loaded for a try the motions of the
/// other jobs are laid too, as far as that is asked for.
BatchPlan plan_batch(const std::vector<BatchJob>& jobs, const BatchOptions& options);

}  // namespace fingerpad
