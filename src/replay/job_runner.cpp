#include "replay/job_runner.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <mutex>

#include "base/error.hpp"
#include "base/file_identity.hpp"
#include "base/printable_text.hpp"
#include "replay/batch_files.hpp"
#include "replay/job_order.hpp"
#include "replay/kept_summary.hpp"
#include "replay/run_job.hpp"
#include "replay/summary_column.hpp"
#include "touch/unit_hints.hpp"

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

/// A rub that no place of a part holds may be one on a grain of sand.
std::vector<std::string> unit_words(const Scene& scene, MeshStore& meshes) {
  std::vector<std::string> words;
  if (!scene.motion.laid) return words;  // else it has not failed by the part's size
  try {
    for (const PartEntry& part : scene.parts) add_unit_hint(meshes.load(part)->verdict, part, words);
  } catch (
      const std::exception&) {  // NOLINT(bugprone-empty-catch): what a mesh is refused for is told already
  }
  return words;
}

constexpr std::size_t motion_bytes = std::size_t{256} << 20;

/// As many meshes as so many jobs use at a time, whatever they are.
std::size_t meshes_of_jobs_at_a_time(const std::vector<BatchJob>& jobs, std::size_t at_a_time) {
  std::size_t most_parts = 1;
  for (const BatchJob& job : jobs) most_parts = std::max(most_parts, job.job.scene.parts.size());
  return at_a_time * most_parts;
}

}  // namespace

JobRunner::JobRunner(std::vector<BatchJob>& jobs, const BatchOptions& options)
    : jobs_(jobs),
      options_(options),
      meshes_(meshes_of_jobs_at_a_time(jobs, static_cast<std::size_t>(options.threads) + 1), options.on_load),
      motions_(motion_bytes),
      contacts_(most_contact_bytes),
      shared_contacts_(contacts_of_several(jobs)) {
  if (options.memory_bytes > 0) meshes_.bound_memory(options.memory_bytes);
}

void JobRunner::expect(const std::vector<std::size_t>& jobs) {
  for (const std::size_t i : jobs) {
    for (const PartEntry& part : jobs_[i].job.scene.parts) meshes_.expect(part);
  }
}

void JobRunner::hold(std::optional<std::size_t> job) {
  if (job) expect({*job});  // first: what both have in common stays
  if (held_) {
    for (const PartEntry& part : jobs_[*held_].job.scene.parts) meshes_.done(part);
  }
  held_ = job;
}

void JobRunner::run_one(std::size_t index) {
  BatchJob& batch_job = jobs_[index];
  const auto start = std::chrono::steady_clock::now();
  const SceneJob& job = batch_job.job;
  const std::string path =
      options_.traces ? (std::filesystem::path(options_.out_dir) / trace_name(job, options_.format)).string()
                      : "";
  const auto before = options_.traces ? state_of(path) : std::nullopt;
  const auto unfinished_before = options_.traces ? state_of(path + ".part") : std::nullopt;
  bool has_begun = false;
  // It is under way from now on, however long its mesh takes to load.
  if (options_.on_ticks) options_.on_ticks(batch_job, 0);
  try {
    if (!job.error.empty()) throw Error(ErrorKind::refused, "", job.error);
    JobOutput output{path, options_.format, options_.choice, options_.version, options_.resume, {}, {}, {}};
    output.name = std::filesystem::path(trace_name(job, options_.format)).stem().string();
    output.on_begin = [&] {
      has_begun = true;
      if (is_lone_scene(jobs_)) keep_other_summary(jobs_, options_);
    };
    if (options_.on_ticks) output.on_ticks = [&](double share) { options_.on_ticks(batch_job, share); };
    const bool may_share = shared_contacts_.contains(contact_number(job));
    const JobResult result = run_job(job.scene, meshes_, motions_, output, may_share ? &contacts_ : nullptr);
    has_begun = true;  // or its trace was kept
    refuse_nonfinite(result.figures, job.scene.path);
    batch_job.figures = result.figures;
    batch_job.kept = result.kept;
    batch_job.made_again = result.made_again;
    batch_job.contact_method = result.contact_method;
    batch_job.contact_normals = result.contact_normals;
    batch_job.contact_reasons = result.contact_reasons;
    batch_job.motion_notes = result.motion_notes;
    batch_job.warnings = result.warnings;
    batch_job.kept_warnings = result.kept_warnings;
    batch_job.status = "ok";
  } catch (const Error& error) {
    batch_job.status = printable(error.what());  // between ranks it is JSON, which is UTF-8
    // The output folder was good when the run began: what is wrong with it now is no fault of the call.
    batch_job.exit_code =
        static_cast<int>(error.kind() == ErrorKind::usage ? ErrorKind::fault : error.kind());
    batch_job.warnings = batch_job.kept_warnings = unit_words(job.scene, meshes_);
  } catch (const std::exception& error) {
    batch_job.status = fmt::format("{}: {}", job.scene.name, error.what());
    batch_job.exit_code = static_cast<int>(ErrorKind::fault);
  }
  if (batch_job.status != "ok") {
    const bool is_as_before = !options_.traces || state_of(path) == before;
    if (is_as_before && before) batch_job.left_behind = path;
    batch_job.wrote_nothing =
        !has_begun && is_as_before && (!options_.traces || state_of(path + ".part") == unfinished_before);
  }
  batch_job.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void JobRunner::run(const NextJob& next, const OnEnd& on_end) {
  std::mutex done_mutex;
  // Where the process may run on fewer processors than it is given threads (mpirun binds each rank to its
  // own), TBB would warn on standard error that it starts fewer.
  const std::size_t limit = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  const tbb::global_control workers(tbb::global_control::max_allowed_parallelism,
                                    std::max(limit, static_cast<std::size_t>(options_.threads)));
  const auto work = [&](const tbb::blocked_range<int>& threads) {
    while (const std::optional<std::size_t> job = next(static_cast<std::size_t>(threads.begin()))) {
      // Isolated: while Embree builds a tree inside, this thread must not pick up a job that waits for
      // that tree.
      tbb::this_task_arena::isolate([&] { run_one(*job); });
      for (const PartEntry& part : jobs_[*job].job.scene.parts) meshes_.done(part);
      const std::lock_guard lock(done_mutex);
      on_end(*job);
    }
  };
  tbb::task_arena arena(options_.threads);
  arena.execute([&] {
    tbb::parallel_for(tbb::blocked_range<int>(0, options_.threads, 1), work, tbb::simple_partitioner());
  });
}

}  // namespace fingerpad
