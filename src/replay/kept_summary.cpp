#include "replay/kept_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "base/csv_cell.hpp"
#include "base/csv_cells.hpp"
#include "base/error.hpp"
#include "base/path_words.hpp"
#include "base/text_lines.hpp"
#include "replay/batch_files.hpp"

namespace fingerpad {
namespace {

namespace fs = std::filesystem;

constexpr InputKind summary_file{"a summary", std::uint64_t{2} << 30};

/// A scene of a summary that the batch does not have; empty if it has all.
std::string scene_apart(const std::string& summary, const std::vector<BatchJob>& jobs) {
  std::set<std::string> starts;
  for (const BatchJob& job : jobs) starts.insert(csv_cell(job.job.scene.name));
  TextLines lines(summary, summary_file);
  std::string_view line;
  if (lines.next(line) && !line.starts_with("scene,job,")) return "another program";
  while (lines.next(line)) {
    const auto is_of = [&line](const std::string& start) {
      return line.starts_with(start) && line.substr(start.size()).starts_with(',');
    };
    if (!line.empty() && std::none_of(starts.begin(), starts.end(), is_of))
      return fmt::format("scene '{}'", csv_cells(line, ',').front());
  }
  return "";
}

/// "summary.kept-1.csv".
std::string kept_name(const std::string& table, int number) {
  return fmt::format("{}.kept-{}.csv", fs::path(table).stem().string(), number);
}

/// Whether a job of a summary is done.
bool has_done_job(const std::string& summary) {
  TextLines lines(summary, summary_file);
  std::string_view line;
  if (!lines.next(line)) return false;
  const auto names = csv_cells(line, ',');
  const auto status =
      static_cast<std::size_t>(std::find(names.begin(), names.end(), "status") - names.begin());
  while (lines.next(line)) {
    const auto cells = csv_cells(line, ',');
    if (status < cells.size() && cells[status] == "ok") return true;
  }
  return false;
}

/// Gives tables other names, with the first number that is free for each of them.
/// @param why  "is of scene 'a'", for the words where that is impossible
/// @returns the summary's new name
std::string keep(const fs::path& folder, const std::vector<std::string>& tables, const std::string& why) {
  int number = 1;
  const auto is_taken = [&](const std::string& table) {
    std::error_code none;
    return fs::exists(folder / kept_name(table, number), none);
  };
  while (std::any_of(tables.begin(), tables.end(), is_taken)) ++number;
  for (const std::string& table : tables) {
    std::error_code failure;
    fs::rename(folder / table, folder / kept_name(table, number), failure);
    if (failure && failure != std::errc::no_such_file_or_directory)
      throw Error(output_fault(failure.value()), (folder / table).string(),
                  fmt::format("{} and cannot be kept as {}: {}", why, kept_name(table, number),
                              path_words((folder / table).string(), failure.value())));
  }
  return kept_name(tables.front(), number);
}

}  // namespace

void keep_other_summary(const std::vector<BatchJob>& jobs, const BatchOptions& options) {
  const fs::path folder(options.out_dir);
  const TableNames tables = table_names(options.shard, options.shard_count);
  const std::string summary = (folder / tables.summary).string();
  std::error_code none;
  if (!fs::is_regular_file(summary, none)) return;
  const std::string apart = scene_apart(summary, jobs);
  if (apart.empty()) return;
  const std::string kept =
      keep(folder, {tables.summary, tables.timing, tables.jobs}, fmt::format("is of {}", apart));
  if (options.on_kept)
    options.on_kept(
        fmt::format("{}: was of {}, which is not in this batch, and is kept as {}", summary, apart, kept));
}

void keep_done_summary(const std::vector<BatchJob>& jobs, const BatchOptions& options) {
  const auto is_done = [](const BatchJob& job) { return job.status == "ok"; };
  if (std::any_of(jobs.begin(), jobs.end(), is_done)) return;
  const fs::path folder(options.out_dir);
  const TableNames tables = table_names(options.shard, options.shard_count);
  const std::string summary = (folder / tables.summary).string();
  std::error_code none;
  if (!fs::is_regular_file(summary, none) || !has_done_job(summary)) return;
  const std::string kept = keep(folder, {tables.summary, tables.timing}, "has jobs that are done");
  if (options.on_kept)
    options.on_kept(fmt::format("{}: had jobs that are done, as none of this batch is, and is kept as {}",
                                summary, kept));
}

}  // namespace fingerpad
