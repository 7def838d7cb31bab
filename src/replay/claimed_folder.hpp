#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "replay/batch.hpp"
#include "replay/run_lock.hpp"

namespace fingerpad {

/// The output folder of a batch, made where it is not there and registered for this run. What must be done
/// once before anything is written is done by the process that comes first, which of ranks is commonly the
/// root: looking for collisions, keeping a summary of other scenes, and `when_first`.
/// @returns what holds the run's place in the folder. Throws Error as run_batch().
std::unique_ptr<RunLock> claimed_folder(const std::vector<BatchJob>& jobs, const BatchOptions& options,
                                        const Ranks& ranks, const std::function<void()>& when_first);

}  // namespace fingerpad
