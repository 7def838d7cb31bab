#pragma once

#include <optional>
#include <string>
#include <vector>

#include "replay/batch.hpp"

namespace fingerpad {

/// "lab-0003" of a set's job, "rub" of a scene alone: what its trace is called, without an ending.
std::string job_name(const SceneJob& job);

/// The trace's file name: `<scene>.h5`, or `<scene>-0001.h5` for a job of a set.
std::string trace_name(const SceneJob& job, TraceFormat format);

/// The file names of the tables of a batch, or of a shard's own: `summary-2of8.csv`. The index of jobs is for
/// sets alone; the schema says what the summary's columns are.
struct TableNames {
  std::string summary, timing, jobs, schema;
};
TableNames table_names(int shard, int shard_count);

/// K of N.
struct ShardNumber {
  int shard = 0, count = 0;
};
/// Whose table a file is by its name, "summary-2of8.csv" of the tables called "summary"; nothing where no
/// shard would call its own so.
std::optional<ShardNumber> shard_of_table(const std::string& file, const std::string& table);

/// Whether a batch has jobs that are numbered, and so an index of them.
bool has_index(const std::vector<BatchJob>& jobs) noexcept;

/// Whether the batch is one scene without a set: that is no batch to its caller.
bool is_lone_scene(const std::vector<BatchJob>& jobs) noexcept;

/// Whether it is one that was refused before it wrote anything of its trace: its folder stays as it was.
bool leaves_folder_alone(const std::vector<BatchJob>& jobs) noexcept;

/// Whether this call runs job i (from 0) of its batch.
bool is_of_shard(std::size_t i, const BatchOptions& options) noexcept;

/// The jobs of this call's shard, from 0.
std::vector<std::size_t> jobs_of_shard(std::size_t job_count, const BatchOptions& options);

/// Marks those of these jobs that have no status: the batch was asked to stop before them.
void mark_not_begun(std::vector<BatchJob>& jobs, const std::vector<std::size_t>& ours);

/// How what is left of a batch is done: "the same command with --resume does the rest", where there are
/// traces that it could keep.
std::string mend_of_unfinished(const BatchOptions& options);

/// The files that a scene's run reads: the scene itself, meshes, motion and profile.
std::vector<std::string> input_files(const Scene& scene);

/// What this call will write in its folder: traces and tables.
std::vector<std::string> output_names(const std::vector<BatchJob>& jobs, const BatchOptions& options);

/// Throws Error (refused) where two jobs of the batch, in whatever shards, would write one file, where a
/// trace would have the name of a table, and where an output is a file that the batch reads. Writes nothing.
void refuse_collisions(const std::vector<BatchJob>& jobs, const BatchOptions& options);

}  // namespace fingerpad
