#include "replay/merge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "base/csv_cells.hpp"
#include "base/error.hpp"
#include "base/output_place.hpp"
#include "base/path_words.hpp"
#include "base/text_lines.hpp"
#include "replay/batch_files.hpp"
#include "replay/run_lock.hpp"
#include "trace/output_file.hpp"

namespace fingerpad {
namespace {

namespace fs = std::filesystem;

/// A table's lines, the header apart.
struct ShardTable {
  std::string header;
  std::vector<std::string> rows;
};

/// One shard: K of N, and where it lies.
struct FoundShard {
  fs::path folder;
  int shard = 0, count = 0;
};

ShardTable read_shard_table(const fs::path& path) {
  TextLines lines(path.string(), {"a table of a batch", std::uint64_t{2} << 30});
  ShardTable table;
  std::string_view line;
  if (lines.next(line)) table.header = line;
  while (lines.next(line)) table.rows.emplace_back(line);
  return table;
}

/// The shards whose summaries lie in a folder.
void find_shards(const std::string& folder, std::vector<FoundShard>& found) {
  std::error_code failure;
  const std::size_t before = found.size();
  for (fs::directory_iterator at(folder, failure); !failure && at != fs::directory_iterator();
       at.increment(failure)) {
    const auto number = shard_of_table(at->path().filename().string(), "summary");
    if (number) found.push_back({folder, number->shard, number->count});
  }
  if (failure) throw refused(folder, "cannot be read: " + folder_words(folder, failure.value()));
  if (found.size() == before)
    throw refused(folder, "holds no shard of a batch, whose summary would be called summary-1of4.csv");
}

/// All shards of one batch, in order.
std::vector<FoundShard> whole_batch(const std::vector<std::string>& folders) {
  std::vector<FoundShard> found;
  for (const std::string& folder : folders) find_shards(folder, found);
  std::sort(found.begin(), found.end(),
            [](const FoundShard& a, const FoundShard& b) { return a.shard < b.shard; });
  for (const FoundShard& one : found) {
    if (one.count == found[0].count) continue;
    throw refused(one.folder.string(),
                  fmt::format("holds a shard of {}, but {} one of {}: merge one batch at a time", one.count,
                              found[0].folder.string(), found[0].count));
  }
  for (int k = 1; k <= found[0].count; ++k) {
    const auto is_k = [k](const FoundShard& one) { return one.shard == k; };
    const auto times = std::count_if(found.begin(), found.end(), is_k);
    if (times == 1) continue;
    throw refused(found[0].folder.string(),
                  fmt::format("shard {} of {} is {}", k, found[0].count,
                              times == 0 ? "in none of the folders" : "there twice"));
  }
  return found;
}

fs::path table_of(const FoundShard& shard, std::string TableNames::*which) {
  return shard.folder / (table_names(shard.shard, shard.count).*which);
}

Error refuse_unfinished_shard(const FoundShard& shard, std::size_t rows, std::size_t due) {
  return refused(table_of(shard, &TableNames::summary).string(),
                 fmt::format("has {} of {} jobs: run that shard to its end (with --resume where it writes "
                             "traces)",
                             rows, due));
}

/// Rows in the order of the batch: job i stands in shard i mod N.
ShardTable merged_table(const std::vector<FoundShard>& shards, std::string TableNames::*which) {
  std::vector<ShardTable> tables;
  std::size_t total = 0;
  for (const FoundShard& shard : shards) {
    const std::string path = table_of(shard, which).string();
    tables.push_back(read_shard_table(path));
    total += tables.back().rows.size();
    if (tables.back().header != tables[0].header)
      throw refused(path, "has other columns than the first shard's: it is of another batch");
  }
  for (std::size_t k = 0; k < shards.size(); ++k) {
    const std::size_t due = total > k ? (total - k - 1) / shards.size() + 1 : 0;
    if (tables[k].rows.size() < due) throw refuse_unfinished_shard(shards[k], tables[k].rows.size(), due);
  }
  ShardTable merged{tables[0].header, {}};
  for (std::size_t i = 0; i < total; ++i) {
    merged.rows.push_back(tables[i % shards.size()].rows[i / shards.size()]);
  }
  return merged;
}

/// An index is written before its jobs: it tells how many a shard has, however many were done.
void refuse_stopped_shards(const std::vector<FoundShard>& shards) {
  for (const FoundShard& shard : shards) {
    std::error_code none;
    const fs::path index = table_of(shard, &TableNames::jobs);
    if (!fs::exists(index, none)) continue;
    const std::size_t due = read_shard_table(index).rows.size();
    const std::size_t rows = read_shard_table(table_of(shard, &TableNames::summary)).rows.size();
    if (rows != due) throw refuse_unfinished_shard(shard, rows, due);
  }
}

void write_merged(const fs::path& path, const ShardTable& table) {
  OutputFile file(path.string());
  file.write(table.header + "\n");
  for (const std::string& row : table.rows) file.write(row + "\n");
  file.commit();
}

/// Copies a file into place; itself is left alone.
void bring(const fs::path& from, const fs::path& to) {
  std::error_code failure;
  if (fs::equivalent(from, to, failure)) return;
  const fs::path part = to.string() + ".part";
  fs::copy_file(from, part, fs::copy_options::overwrite_existing, failure);
  if (!failure) fs::rename(part, to, failure);
  if (!failure) return;
  std::error_code ignored;
  fs::remove(part, ignored);
  throw Error(output_fault(failure.value()), to.string(), "cannot be written: " + failure.message());
}

/// Where a table has this column; beyond its columns if nowhere.
std::size_t place_of(std::string_view column, const ShardTable& table) {
  const auto names = csv_cells(table.header, ',');
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), column) - names.begin());
}

/// The trace of a row of the summary, which need not be there; empty for a job that failed.
fs::path trace_of_row(const std::string& row, std::size_t status, const fs::path& folder) {
  const auto cells = csv_cells(row, ',');
  if (cells.size() <= status || cells.size() < 2 || cells[status] != "ok") return {};
  SceneJob job;
  job.scene.name = cells[0];
  job.number = std::atoi(std::string(cells[1]).c_str());
  const fs::path hdf5 = folder / trace_name(job, TraceFormat::hdf5),
                 csv = folder / trace_name(job, TraceFormat::csv);
  std::error_code none;
  return fs::is_regular_file(csv, none) && !fs::is_regular_file(hdf5, none) ? csv : hdf5;
}

/// Whether the batch was to write traces (not with --format none): so its index says.
bool names_traces(const ShardTable& index) {
  const std::size_t file = place_of("file", index);
  return std::any_of(index.rows.begin(), index.rows.end(), [file](const std::string& row) {
    const auto cells = csv_cells(row, ',');
    return file < cells.size() && !cells[file].empty();
  });
}

/// The traces of all jobs that are done. Throws Error (refused) where one is gone.
/// @param index  the batch's, if it has one; else one trace that is there tells that there were others
std::vector<fs::path> traces_of(const ShardTable& summary, const std::vector<FoundShard>& shards,
                                const ShardTable* index) {
  std::vector<fs::path> traces;
  fs::path gone;
  const std::size_t status = place_of("status", summary);
  for (std::size_t i = 0; i < summary.rows.size(); ++i) {
    const fs::path trace = trace_of_row(summary.rows[i], status, shards[i % shards.size()].folder);
    if (trace.empty()) continue;
    std::error_code none;
    if (fs::is_regular_file(trace, none))
      traces.push_back(trace);
    else if (gone.empty())
      gone = trace;
  }
  if (!gone.empty() && (index != nullptr ? names_traces(*index) : !traces.empty()))
    throw refused(gone.string(),
                  "is gone, but its shard's summary has it as done: run that shard again with --resume");
  return traces;
}

void bring_trace(const fs::path& trace, const fs::path& out) {
  bring(trace, out / trace.filename());
  const fs::path proof = fs::path(state_folder) / (trace.filename().string() + ".proof");
  std::error_code none;
  if (!fs::is_regular_file(trace.parent_path() / proof, none)) return;
  fs::create_directories(out / state_folder, none);
  bring(trace.parent_path() / proof, out / proof);
}

}  // namespace

MergedShards merge_shards(const std::vector<std::string>& folders, const std::string& out) {
  const std::vector<FoundShard> shards = whole_batch(folders);
  refuse_stopped_shards(shards);
  const ShardTable summary = merged_table(shards, &TableNames::summary);
  const ShardTable timing = merged_table(shards, &TableNames::timing);
  const TableNames names = table_names(1, 1);
  std::error_code none;
  const bool indexed = fs::exists(table_of(shards[0], &TableNames::jobs), none);
  const ShardTable index = indexed ? merged_table(shards, &TableNames::jobs) : ShardTable{};
  const std::vector<fs::path> traces = traces_of(summary, shards, indexed ? &index : nullptr);
  std::vector<std::string> written{names.summary, names.timing, names.jobs, names.schema};
  for (const fs::path& trace : traces) written.push_back(trace.filename().string());
  make_folder(out);
  const RunLock lock(out, written);
  for (const fs::path& trace : traces) bring_trace(trace, out);
  if (indexed) write_merged(fs::path(out) / names.jobs, index);
  write_merged(fs::path(out) / names.timing, timing);
  write_merged(fs::path(out) / names.summary, summary);
  const fs::path schema = table_of(shards[0], &TableNames::schema);
  if (fs::exists(schema, none)) bring(schema, fs::path(out) / names.schema);
  return {shards[0].count, summary.rows.size(), traces.size()};
}

}  // namespace fingerpad
