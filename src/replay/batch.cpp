#include "replay/batch.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>

#include "base/error.hpp"
#include "base/file_identity.hpp"
#include "base/path_words.hpp"
#include "base/printable_text.hpp"
#include "replay/batch_files.hpp"
#include "replay/run_job.hpp"
#include "replay/run_lock.hpp"
#include "replay/summary.hpp"
#include "replay/summary_column.hpp"

namespace fingerpad {
namespace {

/// Throws where a figure of a run is no number: the run says nothing then, and its row says why.
void refuse_nonfinite(const std::vector<double>& figures, const std::string& scene_path) {
  for (std::size_t i = 0; i < figures.size(); ++i) {
    if (std::isfinite(figures[i]) || (std::isnan(figures[i]) && summary_figure_columns()[i].may_lack))
      continue;
    throw refused(scene_path,
                  fmt::format("the run's {} is not finite: its numbers left what a double can hold",
                              Figures::names()[i]));
  }
}

/// What tells a trace that a job has not written from one that it has; nothing where no file is.
std::optional<std::string> state_of(const std::string& path) {
  std::error_code none;
  const auto written = std::filesystem::last_write_time(path, none);
  const auto identity = file_identity(path);
  if (none || !identity) return std::nullopt;
  return fmt::format("{} {}", *identity, written.time_since_epoch().count());
}

void run_one(BatchJob& batch_job, MeshStore& meshes, MotionStore& motions, const BatchOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const SceneJob& job = batch_job.job;
  const std::string path =
      options.traces ? (std::filesystem::path(options.out_dir) / trace_name(job, options.format)).string()
                     : "";
  const auto before = options.traces ? state_of(path) : std::nullopt;
  try {
    if (!job.error.empty()) throw Error(ErrorKind::refused, "", job.error);
    JobOutput output{path, options.format, options.choice, options.version, options.resume, {}};
    if (options.on_ticks) output.on_ticks = [&](double share) { options.on_ticks(batch_job, share); };
    const JobResult result = run_job(job.scene, meshes, motions, output);
    refuse_nonfinite(result.figures, job.scene.path);
    batch_job.figures = result.figures;
    batch_job.kept = result.kept;
    batch_job.contact_method = result.contact_method;
    batch_job.contact_normals = result.contact_normals;
    batch_job.contact_reasons = result.contact_reasons;
    batch_job.motion_notes = result.motion_notes;
    batch_job.warnings = result.warnings;
    batch_job.status = "ok";
  } catch (const Error& error) {
    batch_job.status = printable(error.what());  // between ranks it is JSON, which is UTF-8
    // The output folder was good when the run began: what is wrong with it now is no fault of the call.
    batch_job.exit_code =
        static_cast<int>(error.kind() == ErrorKind::usage ? ErrorKind::fault : error.kind());
  } catch (const std::exception& error) {
    batch_job.status = fmt::format("{}: {}", job.scene.name, error.what());
    batch_job.exit_code = static_cast<int>(ErrorKind::fault);
  }
  if (batch_job.status != "ok" && before && state_of(path) == before) batch_job.left_behind = path;
  batch_job.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// This rank's outcomes as text for the root, and back.
std::string outcomes_text(const std::vector<BatchJob>& jobs, const std::vector<std::size_t>& ours) {
  nlohmann::json outcomes = nlohmann::json::array();
  for (const std::size_t i : ours) {
    const BatchJob& job = jobs[i];
    // Figures as bits: JSON has no numbers that are not finite.
    std::vector<std::uint64_t> figures;
    for (const double figure : job.figures) figures.push_back(std::bit_cast<std::uint64_t>(figure));
    outcomes.push_back({i, job.status, job.exit_code, job.seconds, figures, job.contact_method,
                        job.contact_normals, job.contact_reasons, job.kept, job.left_behind, job.motion_notes,
                        job.warnings, job.not_begun});
  }
  return outcomes.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void take_outcomes(std::vector<BatchJob>& jobs, const std::string& text) {
  for (const auto& outcome : nlohmann::json::parse(text)) {
    BatchJob& job = jobs.at(outcome[0].get<std::size_t>());
    job.status = outcome[1];
    job.exit_code = outcome[2];
    job.seconds = outcome[3];
    job.figures.clear();
    for (const std::uint64_t bits : outcome[4]) job.figures.push_back(std::bit_cast<double>(bits));
    job.contact_method = outcome[5];
    job.contact_normals = outcome[6];
    job.contact_reasons = outcome[7].get<std::vector<std::string>>();
    job.kept = outcome[8];
    job.left_behind = outcome[9];
    job.motion_notes = outcome[10].get<std::vector<std::string>>();
    job.warnings = outcome[11].get<std::vector<std::string>>();
    job.not_begun = outcome[12];
  }
}

/// The jobs of this shard, and of them every count-th for this rank.
std::vector<std::size_t> share(std::size_t job_count, const BatchOptions& options, const Ranks& ranks) {
  std::vector<std::size_t> shard;
  for (std::size_t i = 0; i < job_count; ++i) {
    if (is_of_shard(i, options)) shard.push_back(i);
  }
  std::vector<std::size_t> ours;
  for (auto i = static_cast<std::size_t>(ranks.rank()); i < shard.size();
       i += static_cast<std::size_t>(ranks.count())) {
    ours.push_back(shard[i]);
  }
  return ours;
}

/// Jobs of one mesh one after another, as far as nothing else tells their order: each mesh is loaded once.
std::vector<std::size_t> by_mesh(const std::vector<BatchJob>& jobs, std::vector<std::size_t> ours) {
  const auto mesh_of = [&jobs](std::size_t i) {
    const Scene& scene = jobs[i].job.scene;
    return scene.parts.empty() ? std::string() : scene.parts.front().mesh_path;
  };
  std::map<std::string, std::size_t> first;
  for (const std::size_t i : ours) first.emplace(mesh_of(i), i);
  std::stable_sort(ours.begin(), ours.end(),
                   [&](std::size_t a, std::size_t b) { return first[mesh_of(a)] < first[mesh_of(b)]; });
  return ours;
}

/// On the root: looks for collisions, makes the output folder and registers the run in it.
std::shared_ptr<RunLock> root_claim(const std::vector<BatchJob>& jobs, const BatchOptions& options) {
  refuse_collisions(jobs, options);
  std::error_code failure;
  std::filesystem::create_directories(options.out_dir, failure);
  if (failure)
    throw Error(output_fault(failure.value()), options.out_dir,
                "cannot be made: " + path_words(options.out_dir + "/", failure.value()));
  auto lock = std::make_shared<RunLock>(options.out_dir, output_names(jobs, options));
  for (const std::string& run : lock->unfinished()) {
    if (options.on_unfinished)
      options.on_unfinished(
          fmt::format("{}: {} ended before it was done; this run takes its place", options.out_dir, run));
  }
  const std::string kept = keep_other_summary(jobs, options);
  if (options.on_kept && !kept.empty()) options.on_kept(kept);
  return lock;
}

/// What must be done once for all ranks before any of them writes. What the root refuses, every rank throws.
/// @returns what holds the run's place in the folder
std::shared_ptr<void> claimed_folder(const std::vector<BatchJob>& jobs, const BatchOptions& options,
                                     const Ranks& ranks) {
  std::shared_ptr<void> claim;
  std::string said;  // '0' and the lock's path, or the kind of an error and its text
  if (ranks.is_root()) {
    try {
      const std::shared_ptr<RunLock> lock = root_claim(jobs, options);
      said = "0" + lock->path();
      claim = lock;
    } catch (const Error& error) {
      said = fmt::format("{}{}", static_cast<int>(error.kind()), error.what());
    } catch (const std::exception& error) {
      said = fmt::format("{}{}: {}", static_cast<int>(ErrorKind::fault), options.out_dir, error.what());
    }
  }
  said = ranks.broadcast(said);
  if (said[0] != '0') throw Error(static_cast<ErrorKind>(said[0] - '0'), "", said.substr(1));
  return ranks.is_root() ? claim : RunLock::join(said.substr(1));
}

}  // namespace

std::vector<BatchJob> batch_jobs(const std::vector<std::string>& scene_paths) {
  std::vector<BatchJob> jobs;
  std::set<std::string> names;
  const auto add = [&jobs](SceneJob job) {
    jobs.emplace_back();
    jobs.back().job = std::move(job);
  };
  for (const std::string& path : scene_paths) {
    SceneFile file;
    try {
      file = read_scene_file(path);
    } catch (const Error& error) {
      if (scene_paths.size() == 1) throw;  // no batch, and nothing of it to write
      SceneJob failed;
      failed.scene.name = std::filesystem::path(path).stem().string();
      failed.scene.path = path;
      failed.error = error.what();
      add(std::move(failed));
      continue;
    }
    if (!names.insert(file.scene.name).second) {
      throw refused(path, fmt::format("a scene named '{}' is already in this batch, and both would write one "
                                      "file; give one another `name`",
                                      file.scene.name));
    }
    for (SceneJob& job : file.jobs) add(std::move(job));
  }
  return jobs;
}

std::vector<Error> run_batch(std::vector<BatchJob>& jobs, const BatchOptions& options, const Ranks& ranks,
                             const std::function<void(const BatchJob&)>& on_done) {
  const std::shared_ptr<void> claim = claimed_folder(jobs, options, ranks);
  const std::vector<std::size_t> ours = by_mesh(jobs, share(jobs.size(), options, ranks));
  std::vector<Error> lost;  // before the jobs: then a killed run has said which is which
  if (ranks.is_root()) lost = write_job_index(jobs, options);
  MeshStore meshes(static_cast<std::size_t>(options.threads) + 1, options.on_load);
  if (options.memory_bytes > 0) meshes.bound_memory(options.memory_bytes);
  for (const std::size_t i : ours) {
    for (const PartEntry& part : jobs[i].job.scene.parts) meshes.expect(part);
  }
  MotionStore motions(std::size_t{256} << 20);
  std::mutex done_mutex;
  // Where the process may run on fewer processors than it is given threads (mpirun binds each rank to its
  // own), TBB would warn on standard error that it starts fewer.
  const std::size_t limit = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  const tbb::global_control workers(tbb::global_control::max_allowed_parallelism,
                                    std::max(limit, static_cast<std::size_t>(options.threads)));
  tbb::task_arena arena(options.threads);
  arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, ours.size(), 1),
        [&](const tbb::blocked_range<std::size_t>& range) {
          for (std::size_t i = range.begin(); i < range.end(); ++i) {
            // Isolated: while Embree builds a tree inside, this thread must not pick up a job that waits for
            // that tree.
            if (options.should_stop && options.should_stop()) {
              jobs[ours[i]].not_begun = true;
              continue;
            }
            tbb::this_task_arena::isolate([&] { run_one(jobs[ours[i]], meshes, motions, options); });
            for (const PartEntry& part : jobs[ours[i]].job.scene.parts) meshes.done(part);
            const std::lock_guard lock(done_mutex);
            on_done(jobs[ours[i]]);
          }
        },
        tbb::simple_partitioner());
  });
  for (const std::string& text : ranks.gather(outcomes_text(jobs, ours))) take_outcomes(jobs, text);
  if (!ranks.is_root()) return {};
  for (const Error& error : write_summary(jobs, options)) lost.push_back(error);
  return lost;
}

}  // namespace fingerpad
