#include "replay/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "base/csv_cell.hpp"
#include "base/csv_cells.hpp"
#include "base/number_text.hpp"
#include "base/printable_text.hpp"
#include "base/text_lines.hpp"
#include "replay/batch_files.hpp"
#include "replay/kept_summary.hpp"
#include "replay/summary_column.hpp"
#include "trace/job_index.hpp"
#include "trace/output_file.hpp"

namespace fingerpad {
namespace {

/// Every set key of the batch, in the order of first appearance.
std::vector<std::string> set_keys(const std::vector<BatchJob>& jobs) {
  std::vector<std::string> keys;
  for (const BatchJob& job : jobs) {
    for (const auto& [key, value] : job.job.set_keys) {
      if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
    }
  }
  return keys;
}

std::string set_value(const BatchJob& job, const std::string& key) {
  for (const auto& [name, value] : job.job.set_keys) {
    if (name == key) return value;
  }
  return "";
}

/// Between the warnings of one job.
constexpr std::string_view warnings_apart = " / ";

std::string summary_text(const std::vector<BatchJob>& jobs) {
  const auto keys = set_keys(jobs);
  std::string text;
  for (const std::string& name : summary_header(keys)) text += (text.empty() ? "" : ",") + csv_cell(name);
  text += "\n";
  for (const BatchJob& job : jobs) {
    if (job.status.empty()) continue;
    text += fmt::format("{},{}", csv_cell(job.job.scene.name), job.job.number);
    for (const std::string& key : keys) text += "," + csv_cell(set_value(job, key));
    text += "," + csv_cell(job.status);
    for (std::size_t i = 0; i < Figures::names().size(); ++i) {
      text += "," + number_text(job.status == "ok" ? job.figures[i] : TickRecord::nan);
    }
    text += fmt::format(",{},{},{}\n", job.contact_method, job.contact_normals,
                        csv_cell(fmt::format("{}", fmt::join(job.kept_warnings, warnings_apart))));
  }
  return text;
}

/// The last column says which ranks have run the batch, so that one of them that comes late finds it done.
constexpr std::string_view timing_header = "scene,job,seconds,run\n";

std::string timing_text(const std::vector<BatchJob>& jobs, const std::string& run) {
  std::string text(timing_header);
  for (const BatchJob& job : jobs) {
    if (job.status.empty()) continue;
    text += fmt::format("{},{},{:.6f},{}\n", csv_cell(job.job.scene.name), job.job.number, job.seconds,
                        csv_cell(run));
  }
  return text;
}

/// Adds the reason to `lost` where the file cannot be written whole; then an older one stays as it was.
void write_table(const std::filesystem::path& path, const std::string& text, std::vector<Error>& lost) {
  try {
    OutputFile file(path.string());
    file.write(text);
    file.commit();
  } catch (const Error& error) {
    lost.push_back(error);
  }
}

/// The index of this shard's jobs.
std::string index_text(const std::vector<BatchJob>& jobs, const BatchOptions& options) {
  std::vector<JobIndexRow> rows;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const SceneJob& job = jobs[i].job;
    if (!is_of_shard(i, options)) continue;
    const std::string mesh = job.scene.parts.empty() ? "" : job.scene.parts.front().mesh;
    rows.push_back({job.number, options.traces ? trace_name(job, options.format) : "", job.scene.name, mesh,
                    job.scene.motion.file, job.set_keys});
  }
  return job_index_text(set_keys(jobs), rows);
}

}  // namespace

std::vector<Error> write_job_index(const std::vector<BatchJob>& jobs, const BatchOptions& options) {
  std::vector<Error> lost;
  if (!has_index(jobs)) return lost;
  const std::string name = table_names(options.shard, options.shard_count).jobs;
  write_table(std::filesystem::path(options.out_dir) / name, index_text(jobs, options), lost);
  return lost;
}

std::vector<Error> write_summary(const std::vector<BatchJob>& jobs, const BatchOptions& options,
                                 const std::string& run) {
  const TableNames names = table_names(options.shard, options.shard_count);
  const std::filesystem::path folder(options.out_dir);
  std::vector<Error> lost;
  if (run.empty() && leaves_folder_alone(jobs)) return lost;  // a rank that comes late looks for its run
  try {
    if (is_lone_scene(jobs)) keep_other_summary(jobs, options);  // where its trace was kept, it did not begin
    keep_done_summary(jobs, options);
  } catch (const Error& error) {
    if (is_lone_scene(jobs) && jobs[0].status == printable(error.what())) return lost;  // told as the job's
    return {error};
  }
  write_table(folder / names.summary, summary_text(jobs), lost);
  write_table(folder / names.schema, summary_schema_text(set_keys(jobs)), lost);
  write_table(folder / names.timing, timing_text(jobs, run), lost);
  return lost;
}

std::string missing_rank_words(int rank) {
  return fmt::format(" without rank {}", rank);
}

bool is_summed_up_without(int rank, const BatchOptions& options, const std::string& run,
                          std::filesystem::file_time_type& written_at) {
  const auto path =
      std::filesystem::path(options.out_dir) / table_names(options.shard, options.shard_count).timing;
  std::error_code none;
  if (!std::filesystem::is_regular_file(path, none)) return false;
  try {
    TextLines lines(path.string(), {"a table of times", std::uint64_t{1} << 30});
    std::string_view line;
    if (!lines.next(line) || std::string(line) + "\n" != timing_header || !lines.next(line)) return false;
    const auto cells = csv_cells(line, ',');
    if (cells.size() != 4 || !cells[3].starts_with(run)) return false;
    const std::string missing = std::string(cells[3]).substr(run.size()) + " ";
    if (missing.find(missing_rank_words(rank) + " ") == std::string::npos) return false;
    written_at = std::filesystem::last_write_time(path, none);
    return !none;
  } catch (const Error&) {
    return false;
  }
}

}  // namespace fingerpad
