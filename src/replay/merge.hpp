#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace fingerpad {

/// What a merge has put together.
struct MergedShards {
  int shards = 0;
  std::size_t jobs = 0, traces = 0;
};

/// Puts the shards of a batch together in one folder: traces, their proofs, summary.csv, timing.csv and a
/// set's jobs.csv, byte for byte (but for times) what one run would have written. The shards may lie in one
/// folder or in many, and `out` may be one of them; then its traces stay where they are.
/// Throws Error: refused for folders without a shard's tables, for a shard that is missing, there twice or
/// not done, for tables that are not of one batch and for a trace that is gone; as OutputFile for the rest.
MergedShards merge_shards(const std::vector<std::string>& folders, const std::string& out);

}  // namespace fingerpad
