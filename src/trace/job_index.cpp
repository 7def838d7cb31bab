#include "trace/job_index.hpp"

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "base/csv_cell.hpp"
#include "base/csv_cells.hpp"
#include "base/error.hpp"
#include "base/text_lines.hpp"

namespace fingerpad {
namespace {

/// Before the set keys.
constexpr std::size_t fixed_columns = 5, file_column = 1, mesh_column = 3;

/// "mu_static 0.3, law dahl" of a row; the mesh has its own place in a title.
std::string words_of(const std::vector<std::string>& keys, const std::vector<std::string_view>& cells) {
  std::string words;
  for (std::size_t i = fixed_columns; i < std::min(keys.size(), cells.size()); ++i) {
    const std::string& key = keys[i];
    if (cells[i].empty() || key == "mesh" || key == "part.mesh") continue;
    const bool is_file = key == "motion" || key == "motion.file";
    words += words.empty() ? "" : ", ";
    words += is_file ? std::filesystem::path(cells[i]).filename().string()
                     : key.substr(key.rfind('.') + 1) + " " + std::string(cells[i]);
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
  for (const std::string& key : keys) text += "," + csv_cell(key);
  text += "\n";
  for (const JobIndexRow& row : rows) {
    text += std::to_string(row.number);
    for (const std::string& cell : {row.file, row.scene, row.mesh, row.motion}) text += "," + csv_cell(cell);
    for (const std::string& key : keys) {
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
      words = words_of(keys, cells);
      return false;
    });
    if (!words.empty()) break;
  }
  return words;
}

std::map<std::string, std::string> jobs_in_folder(const std::string& folder) {
  std::map<std::string, std::string> jobs;
  for (const auto& index : indices_in(folder)) {
    for_each_row(index, [&](const auto& keys, const auto& cells) {
      std::string words = std::filesystem::path(cells[mesh_column]).filename().string();
      const std::string varied = words_of(keys, cells);
      words += words.empty() || varied.empty() ? varied : ", " + varied;
      jobs.emplace(cells[file_column], std::move(words));
      return true;
    });
  }
  return jobs;
}

}  // namespace fingerpad
