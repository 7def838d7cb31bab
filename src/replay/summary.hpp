#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "replay/batch.hpp"

namespace fingerpad {

/// Writes `summary.csv` (scene, job, every set key as written, status, figures, contact method and normals,
/// warnings: no times) and `timing.csv` (scene, job, seconds, the run of ranks) into the output folder: a row
/// for each job that this call ran; and beside the summary what its columns are, `summary.schema.json`. With
/// several shards the names carry the shard: `summary-2of8.csv`. Nothing is written where
/// leaves_folder_alone(). A summary of jobs that are done is kept beside one of a batch that has none.
/// @param run  Ranks::run with missing_rank_words for each that never came; empty for a process alone
/// @returns why, for each of them that could not be written
std::vector<Error> write_summary(const std::vector<BatchJob>& jobs, const BatchOptions& options,
                                 const std::string& run = "");

/// " without rank 3".
std::string missing_rank_words(int rank);

/// Whether the tables in the folder are those of that run of ranks and say that this rank never came:
/// `timing.csv` does, which is written last. Then `written_at` is when.
bool is_summed_up_without(int rank, const BatchOptions& options, const std::string& run,
                          std::filesystem::file_time_type& written_at);

/// Writes the index of a set's jobs: which file is of which mesh, motion and values. Nothing for a batch
/// without sets. Returns as write_summary.
std::vector<Error> write_job_index(const std::vector<BatchJob>& jobs, const BatchOptions& options);

}  // namespace fingerpad
