#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <vector>

#include "replay/job_order.hpp"

namespace fingerpad {

/// Hands the jobs of one process out to its threads. A thread goes on with the meshes that it had last; where
/// none of their jobs is left it begins with the next meshes, and where all are begun it helps where most is
/// left. So while one thread loads a mesh the others do not wait for it: they load the next ones, or work on
/// those that are loaded. Which thread does a job changes nothing of it. Thread-safe.
class JobQueue {
 public:
  /// @param may_begin  whether there is room for one more mesh beside those in use; asked while those that
  ///        are begun have jobs left: where they have none, a thread would else stand idle
  JobQueue(JobOrder order, std::function<bool()> may_begin);

  /// The next job of a thread, an index into the batch; nothing when all are begun.
  /// @param thread  its number, from 0
  std::optional<std::size_t> next(std::size_t thread);

 private:
  static constexpr std::size_t no_group = SIZE_MAX;

  bool has_jobs(std::size_t group) const noexcept {
    return group != no_group && order_.groups[group].first < order_.groups[group].end;
  }
  std::size_t group_for(std::size_t had_last);
  std::size_t most_left() const noexcept;

  std::mutex mutex_;
  JobOrder order_;  // `first` of a group is its first job that is not begun
  std::function<bool()> may_begin_;
  std::size_t groups_begun_ = 0;
  std::vector<std::size_t> open_;      // groups that are begun and may have jobs left
  std::vector<std::size_t> had_last_;  // by thread
};

}  // namespace fingerpad
