#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "replay/figures.hpp"
#include "replay/ranks.hpp"
#include "replay/run_proof.hpp"
#include "scene/scene_file.hpp"
#include "trace/trace_choice.hpp"
#include "trace/trace_writer.hpp"

namespace fingerpad {

struct BatchJob;

struct BatchOptions {
  std::string out_dir;
  TraceFormat format = TraceFormat::hdf5;
  TraceChoice choice = {};  ///< which columns and rows the traces have
  bool traces = true;       ///< false: the figures alone are kept, in the summary
  int threads = 1;
  std::size_t memory_bytes =
      0;  ///< bounds the meshes that are kept; 0: those of as many jobs as there are threads, and of one more
  bool resume = false;
  int shard = 1;        ///< this call's share of the jobs, from 1
  int shard_count = 1;  ///< job i of the batch (from 1) belongs to shard (i - 1) mod shard_count + 1
  /// How long ranks wait for the first of them to come, and the last to leave for those that have not come.
  std::chrono::duration<double> patience = std::chrono::seconds(30);
  std::string version;
  LoadProgress on_load;  ///< as MeshStore's
  /// Told now and then how far a job is, 0 .. 1, by the thread that does it. May be empty.
  std::function<void(const BatchJob&, double share_done)> on_ticks;
  /// Told, by the process that comes first, of runs that had begun to write the same folder and ended before
  /// they were done: "OUT: process 12 on HOST (COMMAND) ..."; by the last, of ranks that never came. May be
  /// empty.
  std::function<void(const std::string&)> on_unfinished;
  /// Told, by the process that comes first, where a summary of other scenes is kept, which traces of an
  /// earlier run stay that are of none of these jobs, and that what another build of the program has made is
  /// made again. May be empty.
  std::function<void(const std::string&)> on_kept;
  /// Told now and then, on a rank, how many jobs the other ranks have ended. May be empty.
  std::function<void(std::size_t)> on_elsewhere;
  /// Asked before each job by the thread that would do it; where it says so, no further job of this rank is
  /// begun. May be empty.
  std::function<bool()> should_stop;
};

/// One job of a batch, and how it ended.
struct BatchJob {
  SceneJob job;
  std::string status;                           ///< "ok", or the error; empty: another shard's
  std::vector<double> figures;                  ///< Figures::values(), empty unless "ok"
  std::string contact_method, contact_normals;  ///< that served (TraceInfo); empty unless "ok"
  std::vector<std::string> contact_reasons;     ///< of what its scene left open
  std::vector<std::string> motion_notes;        ///< how its motion was read (LoadedMotion)
  std::vector<std::string> warnings;            ///< of its motion, and of what that touches
  std::vector<std::string> kept_warnings;       ///< those that the summary keeps (JobResult)
  double seconds = 0;
  int exit_code = 0;           ///< of this job alone
  bool not_begun = false;      ///< the batch was asked to stop before it; without status
  bool kept = false;           ///< an earlier run's trace was kept (BatchOptions::resume)
  MadeAgain made_again;        ///< of BatchOptions::resume: why its trace was made again, if it was
  bool wrote_nothing = false;  ///< it failed before there was anything of its trace
  std::string left_behind;     ///< of a job that failed: an earlier run's trace that is still in its place
};

/// Every job of the given scene files. Of several, those that cannot be loaded become failed jobs.
/// Throws Error (refused) for a single one that cannot be loaded, and for two scenes of one name (their
/// traces would overwrite each other).
std::vector<BatchJob> batch_jobs(const std::vector<std::string>& scene_paths);

/// How a batch ended, for this process.
struct BatchEnd {
  bool tells = true;  ///< false of a rank that left while others went on: the last of them has the whole
  std::vector<Error> lost;  ///< the tables that could not be written, with the reason; the traces are there
};

/// Runs this shard's jobs on `threads` threads a rank; then whoever ends last writes `summary.csv` and
/// `timing.csv`. A job that fails does not stop the rest. Traces and summary depend on the jobs alone, not on
/// threads, ranks or their timing. Where BatchEnd::tells every job of the shard has its status afterwards,
/// elsewhere the rank's own. Of many ranks this goes on in a child process (WatchedRank): to be called before
/// there are threads.
/// @param on_done  called after each of this rank's jobs, one call at a time, from any thread
/// Throws Error before anything is written: refused where two files of the batch would be one, where a file
/// that the batch reads would be overwritten, or where a running process writes the same files; usage where
/// the output folder is no place to write to; fault where the disk is full.
BatchEnd run_batch(std::vector<BatchJob>& jobs, const BatchOptions& options, const Ranks& ranks,
                   const std::function<void(const BatchJob&)>& on_done);

}  // namespace fingerpad
