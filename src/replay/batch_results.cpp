#include "replay/batch_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "base/csv_cells.hpp"
#include "base/error.hpp"
#include "base/number_text.hpp"
#include "base/path_words.hpp"
#include "base/text_lines.hpp"
#include "replay/batch_files.hpp"
#include "replay/residual_warnings.hpp"
#include "replay/summary_column.hpp"
#include "touch/tick_record.hpp"

namespace fingerpad {
namespace {

namespace fs = std::filesystem;

/// A cell as it was before it was quoted.
std::string plain_cell(std::string_view cell) {
  std::string text(cell);
  for (std::size_t at = 0; (at = text.find("\"\"", at)) != std::string::npos; ++at) text.erase(at, 1);
  return text;
}

using Row = std::map<std::string, std::string, std::less<>>;

struct ResultTable {
  std::vector<std::string> header;
  std::vector<Row> rows;
};

ResultTable read_result_table(const std::string& path) {
  TextLines lines(path, {"a table of a batch", std::uint64_t{2} << 30});
  ResultTable table;
  std::string_view line;
  if (!lines.next(line)) throw refused(path, "is empty");
  for (const std::string_view cell : csv_cells(line, ',')) table.header.push_back(plain_cell(cell));
  while (lines.next(line)) {
    if (trimmed(line).empty()) continue;
    const auto cells = csv_cells(line, ',');
    if (cells.size() != table.header.size())
      throw refused(lines.place(),
                    fmt::format("has {} cells, but the header {}", cells.size(), table.header.size()));
    Row& row = table.rows.emplace_back();
    for (std::size_t i = 0; i < cells.size(); ++i) row[table.header[i]] = plain_cell(cells[i]);
  }
  return table;
}

std::string cell_of(const Row& row, std::string_view name) {
  const auto found = row.find(name);
  return found == row.end() ? "" : found->second;
}

int number_of(const Row& row, std::string_view name) {
  const auto number = parse_number(cell_of(row, name));
  return number && *number >= 0 && *number < 1e9 ? static_cast<int>(*number) : 0;
}

/// The tables of a name in a folder: its own, else those of its shards. Kept ones (kept_summary.hpp) are of
/// earlier runs.
std::vector<std::string> tables_named(const std::string& folder, const std::string& name) {
  std::vector<std::string> shards;
  std::error_code failure;
  for (fs::directory_iterator at(folder, failure); !failure && at != fs::directory_iterator();
       at.increment(failure)) {
    const std::string file = at->path().filename().string();
    if (file == name + ".csv") return {at->path().string()};
    if (shard_of_table(file, name)) shards.push_back(at->path().string());
  }
  if (failure) throw refused(folder, "cannot be read: " + folder_words(folder, failure.value()));
  std::sort(shards.begin(), shards.end());
  return shards;
}

/// The keys of a set stand between job and status.
void add_set_keys(const std::vector<std::string>& header, std::vector<std::string>& keys) {
  const auto job = std::find(header.begin(), header.end(), "job");
  const auto status = std::find(job, header.end(), "status");
  if (job == header.end()) return;
  for (auto key = job + 1; key < status; ++key) {
    if (std::find(keys.begin(), keys.end(), *key) == keys.end()) keys.push_back(*key);
  }
}

void add_absent_figures(const std::vector<std::string>& header, std::vector<std::string>& absent) {
  for (const SummaryColumn& column : summary_figure_columns()) {
    const std::string name(column.name);
    if (std::find(header.begin(), header.end(), name) == header.end() &&
        std::find(absent.begin(), absent.end(), name) == absent.end())
      absent.push_back(name);
  }
}

JobOutcome result_of(const Row& row, const std::vector<std::string>& keys) {
  JobOutcome job;
  job.scene = cell_of(row, "scene");
  job.number = number_of(row, "job");
  job.status = cell_of(row, "status");
  job.contact_method = cell_of(row, "contact_method");
  job.contact_normals = cell_of(row, "contact_normals");
  job.warnings = cell_of(row, "warnings");
  for (const SummaryColumn& column : summary_figure_columns()) {
    job.figures.push_back(parse_number(cell_of(row, column.name)).value_or(TickRecord::nan));
  }
  for (const std::string& key : keys) {
    if (const auto found = row.find(key); found != row.end()) job.values.emplace_back(key, found->second);
  }
  return job;
}

/// The trace of a job that no index names.
std::string trace_named(const fs::path& folder, const JobOutcome& job) {
  const std::string stem = job.number > 0 ? fmt::format("{}-{:04}", job.scene, job.number) : job.scene;
  for (const char* ending : {".h5", ".csv"}) {
    std::error_code none;
    if (fs::is_regular_file(folder / (stem + ending), none)) return (folder / (stem + ending)).string();
  }
  return "";
}

using JobKey = std::pair<std::string, int>;

std::map<JobKey, Row> index_of_jobs(const std::string& folder, std::vector<std::string>& files) {
  std::map<JobKey, Row> index;
  for (const std::string& path : tables_named(folder, "jobs")) {
    files.push_back(path);
    for (Row& row : read_result_table(path).rows) {
      const JobKey key{cell_of(row, "scene"), number_of(row, "number")};
      index[key] = std::move(row);
    }
  }
  return index;
}

void add_index_row(const fs::path& folder, const Row& row, JobOutcome& job) {
  job.mesh = cell_of(row, "mesh");
  job.motion = cell_of(row, "motion");
  const std::string file = cell_of(row, "file");
  std::error_code none;
  // A failed job's trace is an earlier run's, and a name with a path in it is no name of this folder's.
  if (job.done() && !file.empty() && fs::path(file).filename() == file &&
      fs::is_regular_file(folder / file, none))
    job.trace = (folder / file).string();
}

double figure(const JobOutcome& job, std::string_view name) {
  const auto columns = summary_figure_columns();
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].name == name) return std::isfinite(job.figures[i]) ? job.figures[i] : 0;
  }
  return 0;
}

/// Greater is worse, the first number counts most.
std::vector<double> badness(const JobOutcome& job) {
  const double energy_j = figure(job, "energy_made_j");
  const double scale_j = figure(job, "max_normal_force_n") * figure(job, "max_depth_m");
  constexpr double notable_share = 0.01;
  return {job.done() ? 0.0 : 1.0,
          figure(job, "nonfinite_ticks"),
          figure(job, "pop_throughs"),
          figure(job, "unsettled_ticks"),
          energy_j > notable_share * scale_j ? energy_j : 0,
          figure(job, "max_normal_force_n")};
}

std::string trouble_words(const JobOutcome& job, const std::vector<double>& bad) {
  const auto counted = [](double count, const char* one, const char* many) {
    return fmt::format("{:.0f} {}", count, count == 1 ? one : many);
  };
  std::vector<std::string> words;
  if (!job.done()) words.emplace_back("failed");
  if (bad[1] > 0) words.push_back(counted(bad[1], "force not finite", "forces not finite"));
  if (bad[2] > 0) words.push_back(counted(bad[2], "pop-through", "pop-throughs"));
  if (bad[3] > 0) words.push_back(counted(bad[3], "unsettled tick", "unsettled ticks"));
  if (bad[4] > 0) words.push_back(fmt::format("made {} J of energy", rounded_text(bad[4], 3)));
  if (job.done()) {
    for (std::string& doubt : residual_doubts(job.figures)) words.push_back(std::move(doubt));
  }
  if (!job.warnings.empty()) words.push_back(job.warnings);
  return fmt::format("{}", fmt::join(words, ", "));
}

/// Of a folder without a summary: why there is none, and what to do.
std::string missing_summary(const std::string& folder) {
  const std::vector<std::string> indices = tables_named(folder, "jobs");  // written before the jobs are run
  if (indices.empty()) return "holds no summary.csv: name the folder that `fingerpad replay --out` wrote";
  bool has_traces = false;  // an index names none where --format none was asked for
  for (const std::string& path : indices) {
    const auto rows = read_result_table(path).rows;
    has_traces |= std::ranges::any_of(rows, [](const Row& row) { return !cell_of(row, "file").empty(); });
  }
  return fmt::format("holds no summary.csv, since its replay did not end: the same `fingerpad replay` {}",
                     has_traces ? "with --resume does the rest and writes it"
                                : "does all its jobs again, of which it keeps no traces, and writes it");
}

}  // namespace

BatchResults read_batch_results(const std::string& folder) {
  BatchResults results;
  results.files = tables_named(folder, "summary");
  if (results.files.empty()) throw refused(folder, missing_summary(folder));
  std::vector<ResultTable> tables;
  for (const std::string& path : results.files) {
    tables.push_back(read_result_table(path));
    const auto& header = tables.back().header;
    if (std::find(header.begin(), header.end(), "status") == header.end())
      throw refused(path, "has no column `status`: it is no summary of a replay");
    add_set_keys(header, results.set_keys);
    add_absent_figures(header, results.absent_figures);
  }
  const auto index = index_of_jobs(folder, results.files);
  for (const ResultTable& table : tables) {
    for (const Row& row : table.rows) {
      JobOutcome job = result_of(row, results.set_keys);
      const auto found = index.find(JobKey{job.scene, job.number});
      if (found != index.end()) add_index_row(folder, found->second, job);
      if (job.trace.empty() && job.done()) job.trace = trace_named(folder, job);
      results.jobs.push_back(std::move(job));
    }
  }
  return results;
}

bool has_summary(const std::string& folder) {
  return !tables_named(folder, "summary").empty();
}

std::vector<JobTrouble> worst_first(const std::vector<JobOutcome>& jobs) {
  std::vector<std::pair<std::vector<double>, JobTrouble>> ranked;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const std::vector<double> bad = badness(jobs[i]);
    ranked.emplace_back(bad, JobTrouble{i, trouble_words(jobs[i], bad)});
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<JobTrouble> order;
  order.reserve(ranked.size());
  for (auto& [bad, trouble] : ranked) order.push_back(std::move(trouble));
  return order;
}

}  // namespace fingerpad
