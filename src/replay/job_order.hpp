#pragma once

#include <cstdint>
#include <vector>

#include "replay/batch.hpp"

namespace fingerpad {

/// Jobs over the same meshes, which are to be loaded once: a stretch of JobOrder::jobs.
struct JobGroup {
  std::uint64_t first = 0, end = 0;
  double cost_each = 0;  ///< of a job, to be compared with other groups' alone
};

/// In which order jobs are begun: the largest mesh first, of one mesh the longest motion first, so that what
/// is long is not left for the end; jobs of the same meshes together.
struct JobOrder {
  std::vector<std::uint32_t> jobs;  ///< indices into the batch
  std::vector<JobGroup> groups;
};

/// Orders these jobs of a batch. A mesh's size and a motion's are those of their files, each looked at once.
JobOrder order_by_cost(const std::vector<BatchJob>& jobs, const std::vector<std::size_t>& ours);

/// The meshes of a scene as one text: jobs that have it in common share what is loaded.
std::string meshes_of(const Scene& scene);

}  // namespace fingerpad
