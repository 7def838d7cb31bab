#pragma once

#include <cstdint>
#include <unordered_set>
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
/// Jobs that may touch alike (contact_number) follow one another, so many such rows side by side.
/// @param at_a_time  jobs under way together
JobOrder order_by_cost(const std::vector<BatchJob>& jobs, const std::vector<std::size_t>& ours,
                       std::size_t at_a_time);

/// Alike for jobs of one file that differ in keys alone that mostly have no part in where the finger touches:
/// friction, what surfaces are like, the seed. Else most likely not.
std::uint64_t contact_number(const SceneJob& job);

/// The contact_number that several of these jobs have in common.
std::unordered_set<std::uint64_t> contacts_of_several(const std::vector<BatchJob>& jobs);

/// The meshes of a scene as one text: jobs that have it in common share what is loaded.
std::string meshes_of(const Scene& scene);

}  // namespace fingerpad
