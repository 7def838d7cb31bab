#include "replay/job_try.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>

#include "base/error.hpp"
#include "replay/figures.hpp"
#include "touch/closed_loop.hpp"
#include "trace/column_chunks.hpp"
#include "trace/motion_source.hpp"
#include "trace/trace_info.hpp"

namespace fingerpad {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The trace that a try writes to the system's folder for temporary files; it goes with the object. Where
/// that refuses, the try goes on without it.
class TryTrace {
 public:
  TryTrace() = default;
  TryTrace(const TryTrace&) = delete;
  TryTrace& operator=(const TryTrace&) = delete;
  ~TryTrace() {
    writer_.reset();
    std::error_code ignored;
    for (const std::string& name : {path_, path_ + ".part"}) std::filesystem::remove(name, ignored);
  }
  void begin(TraceFormat format, const TraceInfo& info, const World& world, long rows) {
    attempt([&] {
      const char* ending = format == TraceFormat::csv ? "csv" : "h5";
      path_ = (std::filesystem::temp_directory_path() / fmt::format("fingerpad-try-{}.{}", getpid(), ending))
                  .string();
      writer_ = TraceWriter::create(path_, format, info, world, static_cast<std::uint64_t>(rows));
      writer_->flush();
    });
  }
  void append(const std::vector<TickRecord>& rows) {
    if (writer_) attempt([&] { writer_->append(rows); });
  }
  void finish() {
    if (writer_) attempt([&] { writer_->finish(); });
  }
  /// 0 where it could not be written.
  double bytes() const {
    if (!refusal_.empty()) return 0;
    std::error_code none;
    for (const std::string& name : {path_ + ".part", path_}) {
      const auto size = std::filesystem::file_size(name, none);
      if (!none) return static_cast<double>(size);
    }
    return 0;
  }
  const std::string& refusal() const noexcept { return refusal_; }

 private:
  template <typename Step>
  void attempt(const Step& step) {
    try {
      step();
      return;
    } catch (const Error& error) {
      refusal_ = error.what();
    } catch (const std::filesystem::filesystem_error& error) {
      refusal_ = "TMPDIR names no folder that can be used: " + error.code().message();
    }
    writer_.reset();
  }

  std::string path_, refusal_;
  std::unique_ptr<TraceWriter> writer_;
};

/// The rows that a try's file has room for: the last chunk of a plain HDF5 trace is there whole.
std::uint64_t rows_on_disk(long tried_ticks, long ticks, const BatchOptions& options) {
  const auto rows = static_cast<std::uint64_t>(tried_ticks);
  if (options.format == TraceFormat::csv || options.choice.deflated) return rows;
  const std::uint64_t chunk = chunk_rows_for(static_cast<std::uint64_t>(ticks));
  return (rows + chunk - 1) / chunk * chunk;
}

/// A job made ready for its first tick, as run_job() does it.
struct ReadyJob {
  ReadyJob(const Scene& scene_as_written, MeshStore& meshes, MotionStore& motions,
           const BatchOptions& options)
      : stored(motions.load(scene_as_written, meshes)),
        scene(at_rate(scene_as_written, path())),
        world(load_world(scene, meshes)),
        info(trace_info(scene, *world, path(), stored->hash, options.version)) {
    choose(options.choice, info);
  }
  const FingerPath& path() const { return stored->motion.path; }

  std::shared_ptr<const StoredMotion> stored;
  Scene scene;
  std::shared_ptr<const World> world;
  TraceInfo info;
};

/// Ticks until it has lasted long enough. @returns how many
long tick_for_a_while(ClosedLoop& loop, Figures& figures, TryTrace& trace, Clock::time_point start) {
  constexpr double long_enough_s = 0.2;
  constexpr long block_ticks = 64;  // as run_job()
  std::vector<TickRecord> block;
  block.reserve(block_ticks);
  long ticks = 0;
  while (ticks < loop.tick_count() && !loop.has_diverged() && seconds_since(start) < long_enough_s) {
    block.clear();
    const long end = std::min(ticks + block_ticks, loop.tick_count());
    for (; ticks < end && !loop.has_diverged(); ++ticks) {
      block.push_back(loop.next());
      figures.observe(block.back());
    }
    trace.append(block);
  }
  return ticks;
}

}  // namespace

JobCost try_job(const Scene& scene, MeshStore& meshes, MotionStore& motions, const BatchOptions& options) {
  const Clock::time_point start = Clock::now();
  { const ReadyJob first(scene, meshes, motions, options); }
  const double first_s = seconds_since(start);

  // Its meshes, and its motion where that is read from a file, are there from now on, as for the jobs after
  // it.
  const Clock::time_point again = Clock::now();
  const ReadyJob job(scene, meshes, motions, options);
  JobCost cost;
  cost.load_s = std::max(0.0, first_s - seconds_since(again));
  TryTrace trace;
  ClosedLoop loop(job.world, job.scene, job.path());
  Figures figures(job.world);
  if (options.traces) trace.begin(options.format, job.info, *job.world, loop.tick_count());
  cost.s_a_job = seconds_since(again);
  cost.bytes = trace.bytes();

  const Clock::time_point run = Clock::now();
  const long ticks = tick_for_a_while(loop, figures, trace, run);
  const double run_s = seconds_since(run);
  const Clock::time_point ending = Clock::now();
  trace.finish();
  cost.s_a_job += seconds_since(ending);
  cost.unwritten = trace.refusal();
  if (ticks == 0) return cost;
  cost.s_per_tick = run_s / static_cast<double>(ticks);
  // The try writes all its rows.
  cost.bytes_per_tick = std::max(0.0, trace.bytes() - cost.bytes) /
                        static_cast<double>(rows_on_disk(ticks, loop.tick_count(), options)) /
                        static_cast<double>(options.choice.every);
  return cost;
}

}  // namespace fingerpad
