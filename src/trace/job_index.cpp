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
constexpr std::size_t fixed_columns = 5;

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

/// What one index says of a trace's file.
std::string varied_by(const std::filesystem::path& index, const std::string& file) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(index, none)) return "";
  try {
    TextLines lines(index.string(), {"an index of jobs", std::uint64_t{64} << 20});
    std::string_view line;
    if (!lines.next(line) || !line.starts_with("number,file,")) return "";
    std::vector<std::string> keys;
    for (const std::string_view cell : csv_cells(line, ',')) keys.emplace_back(cell);
    while (lines.next(line)) {
      const auto cells = csv_cells(line, ',');
      if (cells.size() > 1 && cells[1] == file) return words_of(keys, cells);
    }
  } catch (const Error&) {  // a title does without
  }
  return "";
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
  const std::filesystem::path folder = path.parent_path().empty() ? "." : path.parent_path();
  std::vector<std::filesystem::path> indices;
  std::error_code none;
  std::filesystem::directory_iterator at(folder, none);
  for (; !none && at != std::filesystem::directory_iterator(); at.increment(none)) {
    const std::string name = at->path().filename().string();
    if (name == job_index_name || (name.starts_with("jobs-") && name.ends_with(".csv")))
      indices.push_back(at->path());
  }
  std::sort(indices.begin(), indices.end());
  for (const std::filesystem::path& index : indices) {
    if (std::string words = varied_by(index, path.filename().string()); !words.empty()) return words;
  }
  return "";
}

}  // namespace fingerpad
