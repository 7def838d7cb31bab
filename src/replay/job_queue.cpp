#include "replay/job_queue.hpp"

#include <utility>

namespace fingerpad {

JobQueue::JobQueue(JobOrder order, std::function<bool()> may_begin)
    : order_(std::move(order)), may_begin_(std::move(may_begin)) {}

std::optional<std::size_t> JobQueue::next(std::size_t thread) {
  const std::lock_guard lock(mutex_);
  if (thread >= had_last_.size()) had_last_.resize(thread + 1, no_group);
  const std::size_t group = group_for(had_last_[thread]);
  if (group == no_group) return std::nullopt;
  had_last_[thread] = group;
  return order_.jobs[order_.groups[group].first++];
}

std::size_t JobQueue::group_for(std::size_t had_last) {
  if (has_jobs(had_last)) return had_last;
  std::erase_if(open_, [this](std::size_t group) { return !has_jobs(group); });
  if (groups_begun_ == order_.groups.size()) return most_left();
  if (!open_.empty() && !may_begin_()) return most_left();
  open_.push_back(groups_begun_);
  return groups_begun_++;
}

std::size_t JobQueue::most_left() const noexcept {
  std::size_t best = no_group;
  double most = 0;
  for (const std::size_t group : open_) {
    const JobGroup& jobs = order_.groups[group];
    const double left = static_cast<double>(jobs.end - jobs.first) * jobs.cost_each;
    if (left <= most) continue;
    most = left;
    best = group;
  }
  return best;
}

}  // namespace fingerpad
