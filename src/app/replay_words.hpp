#pragma once

#include <vector>

#include "base/error.hpp"
#include "replay/batch.hpp"

namespace fingerpad {

/// Each reason for which jobs failed, once with the jobs that it stopped, and once for the batch what the
/// figures warn of.
void tell_doubts(const std::vector<BatchJob>& jobs);

/// What the program chose where scenes left it open, and how it read their motions: each part's and each
/// motion's line once, however many jobs have it, the first dozen of them.
void tell_choices(const std::vector<BatchJob>& jobs);

/// What jobs warn of themselves, likewise.
void tell_warnings_of_jobs(const std::vector<BatchJob>& jobs);

/// Why `--resume` made traces again that were there, each reason once.
/// @param quiet  nothing but that another build of the program had made them, which is a warning
void tell_made_again(const std::vector<BatchJob>& jobs, const BatchOptions& batch, bool quiet);

/// The tables that could not be written, and the code for it where the jobs themselves are good.
int tell_lost(const std::vector<Error>& lost);

/// The closing line.
/// @param any_table_lost  the summary is not there
void tell_end(const std::vector<BatchJob>& jobs, bool any_table_lost, const BatchOptions& batch);

/// How far a batch came that was asked to stop, and how the rest is done.
void tell_stopped(const std::vector<BatchJob>& jobs, const BatchOptions& batch);

}  // namespace fingerpad
