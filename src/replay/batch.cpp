#include "replay/batch.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <chrono>
#include <filesystem>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>

#include "base/error.hpp"
#include "replay/run_job.hpp"
#include "replay/summary.hpp"

namespace fingerpad {
namespace {

void run_one(BatchJob& batch_job, MeshStore& meshes, const BatchOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const SceneJob& job = batch_job.job;
  try {
    if (!job.error.empty()) throw Error(ErrorKind::refused, "", job.error);
    const auto path = std::filesystem::path(options.out_dir) / trace_name(job, options.format);
    const JobResult result =
        run_job(job.scene, meshes, {path.string(), options.format, options.version, options.resume});
    batch_job.figures = result.figures.values();
    batch_job.contact_method = result.contact_method;
    batch_job.contact_normals = result.contact_normals;
    batch_job.contact_reasons = result.contact_reasons;
    batch_job.status = "ok";
  } catch (const Error& error) {
    batch_job.status = error.what();
    batch_job.exit_code = static_cast<int>(error.kind());
  } catch (const std::exception& error) {
    batch_job.status = fmt::format("{}: {}", job.scene.name, error.what());
    batch_job.exit_code = static_cast<int>(ErrorKind::fault);
  }
  batch_job.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// This rank's outcomes as text for the root, and back.
std::string outcomes_text(const std::vector<BatchJob>& jobs, const std::vector<std::size_t>& ours) {
  nlohmann::json outcomes = nlohmann::json::array();
  for (const std::size_t i : ours) {
    const BatchJob& job = jobs[i];
    outcomes.push_back({i, job.status, job.exit_code, job.seconds, job.figures, job.contact_method,
                        job.contact_normals, job.contact_reasons});
  }
  return outcomes.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void take_outcomes(std::vector<BatchJob>& jobs, const std::string& text) {
  for (const auto& outcome : nlohmann::json::parse(text)) {
    BatchJob& job = jobs.at(outcome[0].get<std::size_t>());
    job.status = outcome[1];
    job.exit_code = outcome[2];
    job.seconds = outcome[3];
    job.figures = outcome[4].get<std::vector<double>>();
    job.contact_method = outcome[5];
    job.contact_normals = outcome[6];
    job.contact_reasons = outcome[7].get<std::vector<std::string>>();
  }
}

/// The jobs of this shard, and of them every count-th for this rank.
std::vector<std::size_t> share(std::size_t job_count, const BatchOptions& options, const Ranks& ranks) {
  std::vector<std::size_t> shard;
  for (auto i = static_cast<std::size_t>(options.shard - 1); i < job_count;
       i += static_cast<std::size_t>(options.shard_count)) {
    shard.push_back(i);
  }
  std::vector<std::size_t> ours;
  for (auto i = static_cast<std::size_t>(ranks.rank()); i < shard.size();
       i += static_cast<std::size_t>(ranks.count())) {
    ours.push_back(shard[i]);
  }
  return ours;
}

}  // namespace

std::string trace_name(const SceneJob& job, TraceFormat format) {
  const char* ending = format == TraceFormat::hdf5 ? "h5" : "csv";
  if (job.number == 0) return fmt::format("{}.{}", job.scene.name, ending);
  return fmt::format("{}-{:04}.{}", job.scene.name, job.number, ending);
}

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

void run_batch(std::vector<BatchJob>& jobs, const BatchOptions& options, const Ranks& ranks,
               const std::function<void(const BatchJob&)>& on_done) {
  std::error_code failure;
  std::filesystem::create_directories(options.out_dir, failure);
  if (failure) throw Error(ErrorKind::fault, options.out_dir, "cannot be made: " + failure.message());

  const std::vector<std::size_t> ours = share(jobs.size(), options, ranks);
  MeshStore meshes(static_cast<std::size_t>(options.threads) + 1, options.on_load);
  std::mutex done_mutex;
  tbb::task_arena arena(options.threads);
  arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, ours.size(), 1),
        [&](const tbb::blocked_range<std::size_t>& range) {
          for (std::size_t i = range.begin(); i < range.end(); ++i) {
            // Isolated: while Embree builds a tree inside, this thread must not pick up a job that waits for
            // that tree.
            tbb::this_task_arena::isolate([&] { run_one(jobs[ours[i]], meshes, options); });
            const std::lock_guard lock(done_mutex);
            on_done(jobs[ours[i]]);
          }
        },
        tbb::simple_partitioner());
  });
  for (const std::string& text : ranks.gather(outcomes_text(jobs, ours))) take_outcomes(jobs, text);
  if (ranks.is_root()) write_summary(jobs, options);
}

}  // namespace fingerpad
