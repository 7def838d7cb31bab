#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "replay/figures.hpp"
#include "replay/ranks.hpp"
#include "scene/scene_file.hpp"
#include "trace/trace_writer.hpp"

namespace fingerpad {

struct BatchOptions {
  std::string out_dir;
  TraceFormat format = TraceFormat::hdf5;
  int threads = 1;
  bool resume = false;
  int shard = 1;        ///< this call's share of the jobs, from 1
  int shard_count = 1;  ///< job i of the batch (from 1) belongs to shard (i - 1) mod shard_count + 1
  std::string version;
  LoadProgress on_load;  ///< as MeshStore's
};

/// One job of a batch, and how it ended.
struct BatchJob {
  SceneJob job;
  std::string status;                           ///< "ok", or the error; empty: another shard's
  std::vector<double> figures;                  ///< Figures::values(), empty unless "ok"
  std::string contact_method, contact_normals;  ///< that served (TraceInfo); empty unless "ok"
  std::vector<std::string> contact_reasons;     ///< of what its scene left open
  double seconds = 0;
  int exit_code = 0;  ///< of this job alone
};

/// Every job of the given scene files. Scenes that cannot be loaded become failed jobs.
/// Throws Error (refused) for two scenes of one name (their traces would overwrite each other).
std::vector<BatchJob> batch_jobs(const std::vector<std::string>& scene_paths);

/// Runs this shard's jobs on `threads` threads a rank, writing a trace each; then the root rank writes
/// `summary.csv` and `timing.csv`. A job that fails does not stop the rest. Traces and summary depend on the
/// jobs alone, not on threads, ranks or their timing. On the root every job of the shard has its status
/// afterwards, elsewhere the rank's own.
/// @param on_done  called after each of this rank's jobs, one call at a time, from any thread
/// Throws Error (fault) if the output folder cannot be written.
void run_batch(std::vector<BatchJob>& jobs, const BatchOptions& options, const Ranks& ranks,
               const std::function<void(const BatchJob&)>& on_done);

/// The trace's file name: `<scene>.h5`, or `<scene>-0001.h5` for a job of a set.
std::string trace_name(const SceneJob& job, TraceFormat format);

}  // namespace fingerpad
