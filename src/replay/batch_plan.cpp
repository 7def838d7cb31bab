#include "replay/batch_plan.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>

#include "base/error.hpp"
#include "replay/batch_files.hpp"
#include "replay/missing_inputs.hpp"
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
    std::string key = scene.motion.file_path + (motion != nullptr ? write_toml(motion->value) : "");
    if (scene.motion.laid) key = scene.path + "\n" + scene.text;  // laid on parts, which that does not name
    if (const auto known = counts_.find(key); known != counts_.end()) return known->second;
    if (const auto known = refusals_.find(key); known != refusals_.end()) throw known->second;
    const LoadedMotion loaded = load_keeping_refusal(scene, key);
    for (const std::string& warning : loaded.warnings) {
      if (std::ranges::find(warnings_, warning) == warnings_.end()) warnings_.push_back(warning);
    }
    return counts_[key] = loaded.path.tick_count();
  }
  /// What was told of those that were loaded for it.
  const std::vector<std::string>& warnings() const noexcept { return warnings_; }

 private:
  /// A motion that is refused is read once, too.
  LoadedMotion load_keeping_refusal(const Scene& scene, const std::string& key) {
    try {
      return load_motion(scene);
    } catch (const Error& error) {
      refusals_.emplace(key, error);
      throw;
    }
  }

  std::vector<std::string> warnings_;
  std::map<std::string, long> counts_;
  std::map<std::string, Error> refusals_;
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
    refuse_missing_inputs(job.scene);
    plan.ticks = ticks.of(job.scene);
  } catch (const Error& error) {
    plan.error = error.what();
  }
  return plan;
}

/// Of the files of a scene's meshes: by these loading takes longer and traces grow.
double mesh_bytes(const Scene& scene) {
  double bytes = 0;
  for (const PartEntry& part : scene.parts) {
    std::error_code none;
    const auto size = std::filesystem::file_size(part.mesh_path, none);
    if (!none) bytes += static_cast<double>(size);
  }
  return bytes;
}

struct Kind {
  const Scene* scene = nullptr;  ///< of its first job
  double mesh_bytes = 0;
  JobCost cost = {};
  bool is_tried = false;
  std::string error = {};  ///< why it cannot be tried: its jobs fail
};

/// Kinds from the smallest mesh to the largest, those first that stand in even steps from end to end.
std::vector<Kind*> in_order_of_trying(std::vector<Kind*> kinds, std::size_t count) {
  std::stable_sort(kinds.begin(), kinds.end(),
                   [](const Kind* a, const Kind* b) { return a->mesh_bytes < b->mesh_bytes; });
  if (kinds.size() <= count) return kinds;
  std::vector<Kind*> first, others;
  for (std::size_t i = 0, next = 0; i < kinds.size(); ++i) {
    const bool is_next = i == next * (kinds.size() - 1) / (count - 1);
    (is_next ? first : others).push_back(kinds[i]);
    if (is_next) ++next;
  }
  first.insert(first.end(), others.begin(), others.end());
  return first;
}

/// What the kinds that were tried cost, as a straight line over their meshes' bytes, at least none.
double on_line(const std::vector<const Kind*>& tried, double JobCost::*what, double mesh_bytes) {
  double mean_x = 0, mean_y = 0, xx = 0, xy = 0;
  for (const Kind* kind : tried) {
    mean_x += kind->mesh_bytes / static_cast<double>(tried.size());
    mean_y += kind->cost.*what / static_cast<double>(tried.size());
  }
  for (const Kind* kind : tried) {
    xx += (kind->mesh_bytes - mean_x) * (kind->mesh_bytes - mean_x);
    xy += (kind->mesh_bytes - mean_x) * (kind->cost.*what - mean_y);
  }
  return std::max(0.0, mean_y + (xx > 0 ? xy / xx * (mesh_bytes - mean_x) : 0));
}

/// Tries some of the kinds, and reckons what the others cost: a tick what it does on average, the rest by
/// their meshes.
void measure(const std::vector<Kind*>& kinds, const BatchOptions& options, BatchPlan& plan) {
  constexpr std::size_t most_tried = 8;
  MeshStore meshes(8, options.on_load);
  std::vector<const Kind*> tried_kinds;
  for (Kind* kind : in_order_of_trying(kinds, most_tried)) {
    if (tried_kinds.size() == most_tried) break;
    try {
      kind->cost = tried(*kind->scene, meshes, options);
      kind->is_tried = true;
      tried_kinds.push_back(kind);
    } catch (const Error& error) {
      kind->error = error.what();
    }
  }
  plan.kinds = static_cast<int>(kinds.size());
  plan.measured = static_cast<int>(tried_kinds.size());
  for (Kind* kind : kinds) {
    if (kind->is_tried || !kind->error.empty()) continue;
    for (double JobCost::*const what : {&JobCost::load_s, &JobCost::bytes})
      kind->cost.*what = on_line(tried_kinds, what, kind->mesh_bytes);
    for (double JobCost::*const what : {&JobCost::s_per_tick, &JobCost::bytes_per_tick})
      for (const Kind* other : tried_kinds)
        kind->cost.*what += other->cost.*what / static_cast<double>(tried_kinds.size());
  }
}

}  // namespace

BatchPlan plan_batch(const std::vector<BatchJob>& jobs, const BatchOptions& options) {
  BatchPlan plan;
  TickCounts ticks;
  std::map<std::string, Kind> kinds;
  std::vector<Kind*> in_order, of_jobs;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    if (!is_of_shard(i, options)) continue;
    plan.jobs.push_back(planned(jobs[i], options, ticks));
    of_jobs.push_back(nullptr);
    if (!plan.jobs.back().error.empty()) continue;
    const Scene& scene = jobs[i].job.scene;
    const auto [entry, is_new] = kinds.try_emplace(kind_of(scene), Kind{&scene, mesh_bytes(scene)});
    if (is_new) in_order.push_back(&entry->second);
    of_jobs.back() = &entry->second;
  }
  plan.warnings = ticks.warnings();
  measure(in_order, options, plan);
  for (const Kind* kind : in_order) plan.seconds += kind->cost.load_s;
  for (std::size_t i = 0; i < plan.jobs.size(); ++i) {
    if (of_jobs[i] == nullptr) continue;
    PlannedJob& job = plan.jobs[i];
    job.error = of_jobs[i]->error;
    if (!job.error.empty()) continue;
    const JobCost& cost = of_jobs[i]->cost;
    const auto job_ticks = static_cast<double>(job.ticks);
    plan.ticks += job_ticks;
    plan.seconds += job_ticks * cost.s_per_tick / options.threads;
    plan.bytes += cost.bytes + job_ticks * cost.bytes_per_tick;
  }
  return plan;
}

}  // namespace fingerpad
