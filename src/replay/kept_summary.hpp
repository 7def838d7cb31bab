#pragma once

#include <vector>

#include "replay/batch.hpp"

namespace fingerpad {

/// Gives the tables of this shard that are there another name where the summary has a row of a scene that is
/// not in the batch, or is no summary at all: it would be lost. What the batch's own scenes left there is
/// replaced. What was kept is told (BatchOptions::on_kept). Throws Error where the names cannot be changed.
void keep_other_summary(const std::vector<BatchJob>& jobs, const BatchOptions& options);

/// The same for the summary of the batch's own scenes, where it has a job that is done and the batch has
/// none: all were refused (a wrong path in the scene), failed, or never begun.
void keep_done_summary(const std::vector<BatchJob>& jobs, const BatchOptions& options);

}  // namespace fingerpad
