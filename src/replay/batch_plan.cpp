#include "replay/batch_plan.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>

#include "base/error.hpp"
#include "replay/batch_files.hpp"
#include "scene/scene_reader.hpp"
#include "scene/toml_tree.hpp"
#include "touch/closed_loop.hpp"
#include "touch/mesh_store.hpp"
#include "trace/column_chunks.hpp"
#include "trace/motion_source.hpp"
#include "trace/trace_info.hpp"

namespace fingerpad {
namespace {

using Clock = std::chrono::steady_clock;

/// What a kind of jobs costs.
struct JobCost {
  double load_s = 0, s_per_tick = 0, bytes = 0, bytes_per_tick = 0;
};

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Where a try writes its trace; it goes with the object.
struct TryFile {
  explicit TryFile(TraceFormat format)
      : path((std::filesystem::temp_directory_path() /
              fmt::format("fingerpad-try-{}.{}", getpid(), format == TraceFormat::csv ? "csv" : "h5"))
                 .string()) {}
  TryFile(const TryFile&) = delete;
  TryFile& operator=(const TryFile&) = delete;
  ~TryFile() {
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
    std::filesystem::remove(path + ".part", ignored);
  }
  double bytes() const {
    std::error_code none;
    for (const std::string& name : {path + ".part", path}) {
      const auto size = std::filesystem::file_size(name, none);
      if (!none) return static_cast<double>(size);
    }
    return 0;
  }
  std::string path;
};

/// The rows that a try's file has room for: the last chunk of a plain HDF5 trace is there whole.
std::uint64_t rows_on_disk(long tried_ticks, long ticks, const BatchOptions& options) {
  const auto rows = static_cast<std::uint64_t>(tried_ticks);
  if (options.format == TraceFormat::csv || options.choice.deflated) return rows;
  const std::uint64_t chunk = chunk_rows_for(static_cast<std::uint64_t>(ticks));
  return (rows + chunk - 1) / chunk * chunk;
}

/// Runs the beginning of a job.
JobCost tried(const Scene& scene_as_written, MeshStore& meshes, const BatchOptions& options) {
  constexpr double long_enough_s = 0.2;
  constexpr long block_ticks = 4096;
  const Clock::time_point start = Clock::now();
  const LoadedMotion motion = load_motion(scene_as_written, meshes);
  const Scene scene = at_rate(scene_as_written, motion.path);
  const auto world = load_world(scene, meshes);
  JobCost cost;
  cost.load_s = seconds_since(start);
  const TryFile file(options.format);
  ClosedLoop loop(world, scene, motion.path);
  std::unique_ptr<TraceWriter> writer;
  if (options.traces) {
    TraceInfo info = trace_info(scene, *world, motion.path, options.version);
    choose(options.choice, info);
    writer = TraceWriter::create(file.path, options.format, info, *world,
                                 static_cast<std::uint64_t>(motion.path.tick_count()));
    writer->flush();
  }
  cost.bytes = file.bytes();
  const Clock::time_point run = Clock::now();
  std::vector<TickRecord> block;
  long ticks = 0;
  while (ticks < loop.tick_count() && !loop.has_diverged() && seconds_since(run) < long_enough_s) {
    block.clear();
    const long end = std::min(ticks + block_ticks, loop.tick_count());
    for (; ticks < end && !loop.has_diverged(); ++ticks) block.push_back(loop.next());
    if (writer) writer->append(block);
  }
  if (writer) writer->finish();
  if (ticks == 0) return cost;
  cost.s_per_tick = seconds_since(run) / static_cast<double>(ticks);
  // The try writes all its rows.
  cost.bytes_per_tick = std::max(0.0, file.bytes() - cost.bytes) /
                        static_cast<double>(rows_on_disk(ticks, loop.tick_count(), options)) /
                        static_cast<double>(options.choice.every);
  return cost;
}

/// The ticks of each motion, counted once.
class TickCounts {
 public:
  long of(const Scene& scene) {
    // The part need not be loaded for it.
    if (scene.motion.laid && !scene.motion.automatic_rate)
      return tick_count(duration_s(*scene.motion.laid, pressed_depth_m(scene)), scene.motion.rate_hz);
    const TomlNode root = parse_toml(scene.text, scene.path);
    const TomlEntry* motion = find_entry(root, "motion");
    const std::string key = scene.motion.file_path + (motion != nullptr ? write_toml(motion->value) : "");
    const auto [entry, is_new] = counts_.try_emplace(key, 0);
    if (is_new) entry->second = load_motion(scene).path.tick_count();
    return entry->second;
  }

 private:
  std::map<std::string, long> counts_;
};

/// Jobs that cost alike: the same parts, touched in the same way.
std::string kind_of(const Scene& scene) {
  std::string kind = scene.contact.method + " " + std::to_string(static_cast<int>(scene.hand.has_value()));
  for (const PartEntry& part : scene.parts) kind += "\n" + part.mesh_path;
  return kind;
}

PlannedJob planned(const BatchJob& batch_job, const BatchOptions& options, TickCounts& ticks) {
  const SceneJob& job = batch_job.job;
  PlannedJob plan{trace_name(job, options.format), "", job.scene.motion.file, "", 0, job.error};
  if (!job.scene.parts.empty()) plan.mesh = job.scene.parts.front().mesh;
  for (const auto& [key, value] : job.set_keys) {
    if (key == "mesh" || key == "motion") continue;
    plan.values += (plan.values.empty() ? "" : ", ") + key.substr(key.rfind('.') + 1) + " " + value;
  }
  if (!plan.error.empty()) return plan;
  try {
    plan.ticks = ticks.of(job.scene);
  } catch (const Error& error) {
    plan.error = error.what();
  }
  return plan;
}

/// The costs of all kinds; a kind that cannot be tried makes its jobs fail.
class Costs {
 public:
  Costs(const BatchOptions& options) : options_(options), meshes_(8, options.on_load) {}

  /// @returns  why the kind's jobs fail; empty if they do not
  std::string take(const Scene& scene, double ticks, BatchPlan& plan) {
    constexpr int most_tried = 8;
    const auto [entry, is_new] = costs_.try_emplace(kind_of(scene));
    if (is_new) {
      ++plan.kinds;
      try {
        if (plan.measured < most_tried) {
          entry->second.cost = tried(scene, meshes_, options_);
          ++plan.measured;
          if (entry->second.cost.s_per_tick > slowest_.s_per_tick) slowest_ = entry->second.cost;
        } else {
          entry->second.cost = slowest_;
        }
        plan.seconds += entry->second.cost.load_s;
      } catch (const Error& error) {
        entry->second.error = error.what();
      }
    }
    const JobCost& cost = entry->second.cost;
    plan.seconds += ticks * cost.s_per_tick / options_.threads;
    plan.bytes += cost.bytes + ticks * cost.bytes_per_tick;
    return entry->second.error;
  }

 private:
  struct Kind {
    JobCost cost;
    std::string error;
  };
  const BatchOptions& options_;
  MeshStore meshes_;
  std::map<std::string, Kind> costs_;
  JobCost slowest_;
};

}  // namespace

BatchPlan plan_batch(const std::vector<BatchJob>& jobs, const BatchOptions& options) {
  BatchPlan plan;
  TickCounts ticks;
  Costs costs(options);
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    if (!is_of_shard(i, options)) continue;
    PlannedJob job = planned(jobs[i], options, ticks);
    if (job.error.empty()) job.error = costs.take(jobs[i].job.scene, static_cast<double>(job.ticks), plan);
    if (job.error.empty()) plan.ticks += static_cast<double>(job.ticks);
    plan.jobs.push_back(std::move(job));
  }
  return plan;
}

}  // namespace fingerpad
