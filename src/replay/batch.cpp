#include "replay/batch.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <set>

#include "base/error.hpp"
#include "base/output_place.hpp"
#include "replay/batch_files.hpp"
#include "replay/claimed_folder.hpp"
#include "replay/job_queue.hpp"
#include "replay/job_runner.hpp"
#include "replay/shared_batch.hpp"
#include "replay/summary.hpp"

namespace fingerpad {

std::vector<BatchJob> batch_jobs(const std::vector<std::string>& scene_paths) {
  std::vector<std::vector<SceneJob>> files;
  std::size_t total = 0;
  std::set<std::string> names;
  for (const std::string& path : scene_paths) {
    SceneFile file;
    try {
      file = read_scene_file(path);
    } catch (const Error& error) {
      if (scene_paths.size() == 1) throw;  // no batch, and nothing of it to write
      SceneJob& failed = files.emplace_back().emplace_back();
      failed.scene.name = std::filesystem::path(path).stem().string();
      failed.scene.path = path;
      failed.error = error.what();
      ++total;
      continue;
    }
    if (!names.insert(file.scene.name).second) {
      throw refused(path, fmt::format("a scene named '{}' is already in this batch, and both would write one "
                                      "file; give one another `name`",
                                      file.scene.name));
    }
    total += file.jobs.size();
    files.push_back(std::move(file.jobs));
  }
  // Every rank holds them all: each is there once, and no larger array is left behind while it grows.
  std::vector<BatchJob> jobs;
  jobs.reserve(total);
  for (std::vector<SceneJob>& file : files) {
    for (SceneJob& job : file) jobs.emplace_back().job = std::move(job);
    std::vector<SceneJob>().swap(file);
  }
  return jobs;
}

BatchEnd run_batch(std::vector<BatchJob>& jobs, const BatchOptions& options, const Ranks& ranks,
                   const std::function<void(const BatchJob&)>& on_done) {
  if (ranks.are_many()) return run_shared_batch(jobs, options, ranks, on_done);
  BatchEnd end;
  ClaimedFolder folder = claimed_folder(jobs, options, ranks, [&] {
    end.lost = write_job_index(jobs, options);  // before the jobs: then a killed run has said which is which
  });
  const std::vector<std::size_t> ours = jobs_of_shard(jobs.size(), options);
  JobRunner runner(jobs, options);
  runner.expect(ours);
  JobQueue queue(order_by_cost(jobs, ours, static_cast<std::size_t>(options.threads)),
                 [&] { return runner.has_room_for_a_mesh(); });
  const auto next = [&](std::size_t thread) -> std::optional<std::size_t> {
    if (options.should_stop && options.should_stop()) return std::nullopt;
    return queue.next(thread);
  };
  runner.run(next, [&](std::size_t job) { on_done(jobs[job]); });
  mark_not_begun(jobs, ours);
  for (const Error& error : write_summary(jobs, options)) end.lost.push_back(error);
  if (leaves_folder_alone(jobs)) {
    folder.lock.reset();
    remove_empty(folder.made);
  }
  return end;
}

}  // namespace fingerpad
