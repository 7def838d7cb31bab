#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "scene/scene.hpp"

namespace fingerpad {

/// How many ticks the jobs of a batch will have: each motion is made once for all the jobs that follow it.
class PlannedTicks {
 public:
  /// Throws Error (refused) as load_motion() does: again for each scene whose motion is refused.
  long of(const Scene& scene);
  /// What is odd in the motions that were made, each line once.
  const std::vector<std::string>& warnings() const noexcept { return warnings_; }

 private:
  std::vector<std::string> warnings_;
  std::map<std::string, long> counts_;
  std::map<std::string, Error> refusals_;
};

}  // namespace fingerpad
