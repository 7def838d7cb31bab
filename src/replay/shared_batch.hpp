#pragma once

#include <functional>
#include <vector>

#include "replay/batch.hpp"

namespace fingerpad {

/// run_batch() for one of many ranks. They share the jobs by files in the state folder alone, which every
/// rank sees (JobBoard, RankLog). A rank that dies loses the jobs that it has begun; what it has only taken,
/// others do. Whoever leaves last puts all outcomes together and writes the tables.
BatchEnd run_shared_batch(std::vector<BatchJob>& jobs, const BatchOptions& options, const Ranks& ranks,
                          const std::function<void(const BatchJob&)>& on_done);

}  // namespace fingerpad
