#include "replay/job_try.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <limits>
#include <memory>
#include <utility>

#include "base/error.hpp"
#include "replay/contact_store.hpp"
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

/// Runs a job's ticks for a while, and takes the time.
class TickTry {
 public:
  TickTry(const ReadyJob& job, const BatchOptions& options, const ContactWrap& wrap)
      : loop_(job.world, job.scene, job.path(), {}, wrap), figures_(job.world, job.scene.finger.radius_m) {
    if (options.traces) trace_.begin(options.format, job.info, *job.world, loop_.tick_count());
  }
  /// Ticks until it has lasted long enough, or there are no more.
  void run(long most_ticks = std::numeric_limits<long>::max()) {
    constexpr double long_enough_s = 0.2;
    constexpr long block_ticks = 64;  // as run_job()
    std::vector<TickRecord> block;
    block.reserve(block_ticks);
    const long last = std::min(most_ticks, loop_.tick_count());
    const Clock::time_point start = Clock::now();
    while (ticks_ < last && !loop_.has_diverged() && seconds_since(start) < long_enough_s) {
      block.clear();
      for (const long end = std::min(ticks_ + block_ticks, last); ticks_ < end && !loop_.has_diverged();
           ++ticks_) {
        block.push_back(loop_.next());
        figures_.observe(block.back());
      }
      trace_.append(block);
    }
    seconds_ = seconds_since(start);
  }
  long tick_count() const noexcept { return loop_.tick_count(); }
  long ticks() const noexcept { return ticks_; }
  double s_per_tick() const noexcept { return seconds_ / static_cast<double>(ticks_); }
  TryTrace& trace() noexcept { return trace_; }

 private:
  ClosedLoop loop_;
  Figures figures_;
  TryTrace trace_;
  long ticks_ = 0;
  double seconds_ = 0;
};

/// What a tick takes where it need not ask where the finger touches.
double s_per_played_tick(const ReadyJob& job, const BatchOptions& options,
                         const std::shared_ptr<const ContactTape>& tape, long ticks) {
  const auto play = [&](std::unique_ptr<ContactMethod> method, std::vector<PlacedSurface> surfaces) {
    return played_contact(std::move(method), tape, std::move(surfaces));
  };
  TickTry played(job, options, play);
  played.run(ticks);
  return played.s_per_tick();
}

}  // namespace

JobCost try_job(const Scene& scene, MeshStore& meshes, MotionStore& motions, const BatchOptions& options,
                bool is_shared) {
  const Clock::time_point start = Clock::now();
  { const ReadyJob first(scene, meshes, motions, options); }
  const double first_s = seconds_since(start);

  // Its meshes, and its motion where that is read from a file, are there from now on, as for the jobs after
  // it.
  const Clock::time_point again = Clock::now();
  const ReadyJob job(scene, meshes, motions, options);
  JobCost cost;
  cost.load_s = std::max(0.0, first_s - seconds_since(again));
  std::shared_ptr<ContactTape> tape;
  if (is_shared && ContactStore::may_share(job.scene))
    tape = std::make_shared<ContactTape>(job.path().tick_count(), most_contact_bytes);
  long ticks = 0;
  {
    const auto record = [&](std::unique_ptr<ContactMethod> method, const std::vector<PlacedSurface>&) {
      return tape ? recording_contact(std::move(method), tape) : std::move(method);
    };
    TickTry tried(job, options, record);
    cost.s_a_job = seconds_since(again);
    cost.bytes = tried.trace().bytes();
    tried.run();
    const Clock::time_point ending = Clock::now();
    tried.trace().finish();
    cost.s_a_job += seconds_since(ending);
    cost.unwritten = tried.trace().refusal();
    ticks = tried.ticks();
    if (ticks == 0) return cost;
    cost.s_per_tick = tried.s_per_tick();
    // The try writes all its rows.
    cost.bytes_per_tick = std::max(0.0, tried.trace().bytes() - cost.bytes) /
                          static_cast<double>(rows_on_disk(ticks, tried.tick_count(), options)) /
                          static_cast<double>(options.choice.every);
  }
  cost.s_per_played_tick = cost.s_per_tick;
  if (!tape) return cost;
  cost.may_play = true;
  cost.s_per_played_tick = s_per_played_tick(job, options, tape, ticks);
  return cost;
}

}  // namespace fingerpad
