#include "trace/job_index.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string_view>

#include "base/csv_cell.hpp"
#include "base/csv_cells.hpp"
#include "base/error.hpp"
#include "base/text_lines.hpp"

namespace fingerpad {
namespace {

/// Before the set keys.
constexpr std::size_t fixed_columns = 5, file_column = 1, mesh_column = 3, motion_column = 4;

/// Whether a set key says what a fixed column says too.
bool has_own_column(std::string_view key) noexcept {
  return key == "mesh" || key == "motion";
}

/// "rub.csv, mu_static 0.3, law dahl" of a row; the mesh has its own place in a title.
std::string words_of(const std::vector<std::string>& keys, const std::vector<std::string_view>& cells,
                     bool motions_vary) {
  std::string words;
  if (motions_vary) words = std::filesystem::path(cells[motion_column]).filename().string();
  for (std::size_t i = fixed_columns; i < std::min(keys.size(), cells.size()); ++i) {
    const std::string& key = keys[i];
    if (cells[i].empty() || has_own_column(key) || key == "part.mesh" || key == "motion.file") continue;
    words += words.empty() ? "" : ", ";
    words += key.substr(key.rfind('.') + 1) + " " + std::string(cells[i]);
  }
  return words;
}

/// Calls for each row of an index until told to stop, with its keys and cells; not at all where it is none.
template <typename Take>
void for_each_row(const std::filesystem::path& index, const Take& take) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(index, none)) return;
  try {
    TextLines lines(index.string(), {"an index of jobs", std::uint64_t{64} << 20});
    std::string_view line;
    if (!lines.next(line) || !line.starts_with("number,file,")) return;
    std::vector<std::string> keys;
    for (const std::string_view cell : csv_cells(line, ',')) keys.emplace_back(cell);
    while (lines.next(line)) {
      const auto cells = csv_cells(line, ',');
      if (cells.size() >= fixed_columns && !take(keys, cells)) return;
    }
  } catch (const Error&) {  // a title does without
  }
}

bool motions_vary_in(const std::filesystem::path& index) {
  std::optional<std::string> first;
  bool vary = false;
  for_each_row(index, [&](const auto&, const auto& cells) {
    if (!first) first = cells[motion_column];
    vary = *first != cells[motion_column];
    return !vary;
  });
  return vary;
}

/// The indices in a folder, by name.
std::vector<std::filesystem::path> indices_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> indices;
  std::error_code none;
  std::filesystem::directory_iterator at(folder, none);
  for (; !none && at != std::filesystem::directory_iterator(); at.increment(none)) {
    const std::string name = at->path().filename().string();
    if (name == job_index_name || (name.starts_with("jobs-") && name.ends_with(".csv")))
      indices.push_back(at->path());
  }
  std::sort(indices.begin(), indices.end());
  return indices;
}

}  // namespace

std::string job_index_text(const std::vector<std::string>& keys, const std::vector<JobIndexRow>& rows) {
  std::string text = "number,file,scene,mesh,motion";
  for (const std::string& key : keys) {
    if (!has_own_column(key)) text += "," + csv_cell(key);
  }
  text += "\n";
  for (const JobIndexRow& row : rows) {
    text += std::to_string(row.number);
    for (const std::string& cell : {row.file, row.scene, row.mesh, row.motion}) text += "," + csv_cell(cell);
    for (const std::string& key : keys) {
      if (has_own_column(key)) continue;
      const auto found = std::find_if(row.values.begin(), row.values.end(),
                                      [&](const auto& value) { return value.first == key; });
      text += "," + (found != row.values.end() ? csv_cell(found->second) : "");
    }
    text += "\n";
  }
  return text;
}

std::string varied_in_job(const std::string& trace_path) {
  const std::filesystem::path path(trace_path);
  const std::string file = path.filename().string();
  std::string words;
  for (const auto& index : indices_in(path.parent_path().empty() ? "." : path.parent_path())) {
    for_each_row(index, [&](const auto& keys, const auto& cells) {
      if (cells[file_column] != file) return true;
      words = words_of(keys, cells, motions_vary_in(index));
      return false;
    });
    if (!words.empty()) break;
  }
  return words;
}

std::map<std::string, std::string> jobs_in_folder(const std::string& folder) {
  std::map<std::string, std::string> jobs;
  for (const auto& index : indices_in(folder)) {
    const bool motions_vary = motions_vary_in(index);
    for_each_row(index, [&](const auto& keys, const auto& cells) {
      std::string words = std::filesystem::path(cells[mesh_column]).filename().string();
      const std::string varied = words_of(keys, cells, motions_vary);
      words += words.empty() || varied.empty() ? varied : ", " + varied;
      jobs.emplace(cells[file_column], std::move(words));
      return true;
    });
  }
  return jobs;
}

}  // namespace fingerpad
