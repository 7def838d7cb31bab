#include <algorithm>

#include "scene/scene_set.hpp"

namespace fingerpad {

std::size_t job_count(const SetEntry& entry) noexcept {
  std::size_t count = 1;
  for (const SetAxis& axis : entry.axes) {
    count = entry.zip ? std::max(count, axis.values.size()) : count * axis.values.size();
    if (count > max_jobs) return max_jobs + 1;
  }
  return count;
}

std::vector<std::size_t> choice_of_job(const SetEntry& entry, std::size_t job) {
  std::vector<std::size_t> choice(entry.axes.size());
  for (std::size_t i = entry.axes.size(); i-- > 0;) {
    const std::size_t count = entry.axes[i].values.size();
    choice[i] = entry.zip ? std::min(job, count - 1) : job % count;
    if (!entry.zip) job /= count;
  }
  return choice;
}

}  // namespace fingerpad
