#pragma once

#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "replay/batch.hpp"
#include "replay/run_lock.hpp"

namespace fingerpad {

/// Thrown by claimed_folder where a rank was told to stop before the first of its run had come: it has
/// written nothing.
struct StoppedBeforeTheFirst : std::exception {
  const char* what() const noexcept override { return "told to stop before the first of its run had come"; }
};

/// Where the ranks of a shard tell one another: other shards may be at work in the same output folder.
std::string ranks_folder(const BatchOptions& options);

struct ClaimedFolder {
  /// Holds the run's place in it; none for a rank that comes when the others of its run have done all and
  /// left.
  std::unique_ptr<RunLock> lock;
  std::vector<std::filesystem::path> made;  ///< for it, by this process, innermost first
};

/// The output folder of a batch, made where it is not there and registered for this run. What must be done
/// once before anything is written is done by the process that comes first, which of ranks is commonly the
/// root: looking for collisions, removing what the ranks of a killed run have left, keeping a summary of
/// other scenes (but for a lone scene's), and `when_first`.
/// Throws Error as run_batch().
ClaimedFolder claimed_folder(const std::vector<BatchJob>& jobs, const BatchOptions& options,
                             const Ranks& ranks, const std::function<void()>& when_first);

}  // namespace fingerpad
