#include "replay/batch_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <set>

#include "base/error.hpp"
#include "base/file_identity.hpp"
#include "motion/field_format.hpp"

namespace fingerpad {
namespace {

namespace fs = std::filesystem;

std::string words_for(const SceneJob& job) {
  if (job.number == 0) return fmt::format("scene '{}'", job.scene.name);
  return fmt::format("job {} of set '{}'", job.number, job.scene.name);
}

fs::path canonical_path(const fs::path& path) {
  std::error_code ignored;
  return fs::weakly_canonical(fs::absolute(path, ignored), ignored);
}

/// Who writes each file: a table, or a job.
using Writers = std::map<std::string, std::string>;

Writers table_writers(const std::vector<BatchJob>& jobs, const BatchOptions& options) {
  Writers writers;
  for (int shard = 1; shard <= options.shard_count; ++shard) {
    const TableNames names = table_names(shard, options.shard_count);
    for (const std::string& name : {names.summary, names.timing, names.schema})
      writers.emplace(name, "the batch's own table");
    if (has_index(jobs)) writers.emplace(names.jobs, "the batch's own table");
  }
  return writers;
}

/// Every file of the batch with who writes it.
Writers writers_of(const std::vector<BatchJob>& jobs, const BatchOptions& options) {
  Writers writers = table_writers(jobs, options);
  for (const BatchJob& batch_job : jobs) {
    const SceneJob& job = batch_job.job;
    if (!options.traces || !job.error.empty()) continue;
    const std::string name = trace_name(job, options.format);
    const auto [other, is_new] = writers.emplace(name, words_for(job));
    if (is_new) continue;
    throw refused(
        job.scene.path,
        fmt::format("{} would write {}, which {} is to be; give the scene another `name`", words_for(job),
                    name,
                    other->second.starts_with("the ") ? other->second : "the trace of " + other->second));
  }
  return writers;
}

/// The inputs of the whole batch, each path once.
std::set<std::string> inputs_of(const std::vector<BatchJob>& jobs) {
  std::set<std::string> inputs;
  for (const BatchJob& job : jobs) {
    for (std::string& path : input_files(job.job.scene)) inputs.insert(std::move(path));
  }
  return inputs;
}

}  // namespace

std::string job_name(const SceneJob& job) {
  return job.number == 0 ? job.scene.name : fmt::format("{}-{:04}", job.scene.name, job.number);
}

std::string trace_name(const SceneJob& job, TraceFormat format) {
  return job_name(job) + (format == TraceFormat::hdf5 ? ".h5" : ".csv");
}

TableNames table_names(int shard, int shard_count) {
  const std::string which = shard_count > 1 ? fmt::format("-{}of{}", shard, shard_count) : std::string();
  return {"summary" + which + ".csv", "timing" + which + ".csv", "jobs" + which + ".csv",
          "summary" + which + ".schema.json"};
}

std::optional<ShardNumber> shard_of_table(const std::string& file, const std::string& table) {
  ShardNumber number;
  if (!file.starts_with(table) ||
      std::sscanf(file.c_str() + table.size(), "-%dof%d.csv", &number.shard, &number.count) != 2)
    return std::nullopt;
  const bool is_one = 1 <= number.shard && number.shard <= number.count;
  // Written back, as the numbers may have been read from " 02".
  if (!is_one || file != fmt::format("{}-{}of{}.csv", table, number.shard, number.count)) return std::nullopt;
  return number;
}

bool has_index(const std::vector<BatchJob>& jobs) noexcept {
  return std::any_of(jobs.begin(), jobs.end(), [](const BatchJob& job) { return job.job.number > 0; });
}

bool is_lone_scene(const std::vector<BatchJob>& jobs) noexcept {
  return jobs.size() == 1 && jobs[0].job.number == 0;
}

bool leaves_folder_alone(const std::vector<BatchJob>& jobs) noexcept {
  return is_lone_scene(jobs) && jobs[0].wrote_nothing &&
         jobs[0].exit_code == static_cast<int>(ErrorKind::refused);
}

bool is_of_shard(std::size_t i, const BatchOptions& options) noexcept {
  return i % static_cast<std::size_t>(options.shard_count) == static_cast<std::size_t>(options.shard - 1);
}

std::vector<std::size_t> jobs_of_shard(std::size_t job_count, const BatchOptions& options) {
  std::vector<std::size_t> ours;
  for (std::size_t i = 0; i < job_count; ++i) {
    if (is_of_shard(i, options)) ours.push_back(i);
  }
  return ours;
}

void mark_not_begun(std::vector<BatchJob>& jobs, const std::vector<std::size_t>& ours) {
  for (const std::size_t i : ours) jobs[i].not_begun = jobs[i].status.empty();
}

std::string mend_of_unfinished(const BatchOptions& options) {
  return options.traces ? "the same command with --resume does the rest"
                        : "without traces the same command does all again";
}

std::vector<std::string> input_files(const Scene& scene) {
  std::vector<std::string> files;
  const auto add = [&files](const std::string& path) {
    if (!path.empty()) files.push_back(path);
  };
  add(scene.path);
  for (const PartEntry& part : scene.parts) add(part.mesh_path);
  if (!scene.motion.file_path.empty()) {
    for (const std::string& file : field_files(scene.motion.file_path, scene.motion.format)) add(file);
  }
  add(scene.finger.profile_path);
  return files;
}

std::vector<std::string> output_names(const std::vector<BatchJob>& jobs, const BatchOptions& options) {
  const TableNames tables = table_names(options.shard, options.shard_count);
  std::vector<std::string> names = {tables.summary, tables.timing, tables.schema};
  if (has_index(jobs)) names.push_back(tables.jobs);
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    if (options.traces && is_of_shard(i, options) && jobs[i].job.error.empty())
      names.push_back(trace_name(jobs[i].job, options.format));
  }
  return names;
}

void refuse_collisions(const std::vector<BatchJob>& jobs, const BatchOptions& options) {
  const Writers writers = writers_of(jobs, options);
  const fs::path folder = canonical_path(options.out_dir);
  // An input may also be what another job is only about to write: such a file is known by its path.
  std::map<std::string, std::string> inputs;
  for (const std::string& path : inputs_of(jobs)) {
    inputs.emplace(file_identity(path).value_or(canonical_path(path).string()), path);
  }
  std::map<std::string, std::string> outputs;  // identity -> name, of those that are there already
  for (const auto& [name, writer] : writers) {
    for (const std::string& written : {name, name + ".part"}) {
      const std::string path = (folder / written).string();
      const auto identity = file_identity(path);
      const std::string shown = (fs::path(options.out_dir) / written).string();
      if (const auto input = inputs.find(identity.value_or(path)); input != inputs.end()) {
        throw refused(shown,
                      fmt::format("would be overwritten by {}, but this batch reads it (as {}); write into "
                                  "another folder, or give the scene another `name`",
                                  writer, input->second));
      }
      if (!identity) continue;
      const auto [other, is_new] = outputs.emplace(*identity, shown);
      if (!is_new)
        throw refused(shown, fmt::format("is a link to the same file as {}; remove one", other->second));
    }
  }
}

}  // namespace fingerpad
