#pragma once

#include <vector>

#include "replay/batch.hpp"
#include "replay/job_board.hpp"

namespace fingerpad {

/// The board of a batch's ranks, where they all look for it.
void make_ranks_board(const std::vector<BatchJob>& jobs, const BatchOptions& options);
/// Throws Error (refused) where it is not there, or of another batch.
JobBoard ranks_board(const std::vector<BatchJob>& jobs, const BatchOptions& options);
bool has_ranks_board(const BatchOptions& options);

/// Tells, on a rank that is asked to stop, where that is because another was killed at a job: a launcher that
/// is not told otherwise ends all others then, and the lowest of them says so (BatchOptions::on_unfinished).
void tell_of_killed_rank(const std::vector<BatchJob>& jobs, const BatchOptions& options, const Ranks& ranks);

}  // namespace fingerpad
