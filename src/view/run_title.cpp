#include "view/run_title.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string_view>

#include "base/input_file.hpp"
#include "trace/job_index.hpp"

namespace fingerpad {
namespace {

constexpr const char* dot = " \xC2\xB7 ";

/// The job's number in "t-0003"; empty where the name is not of a set's job.
std::string job_number(const std::string& stem, const std::string& scene_name) {
  if (!stem.starts_with(scene_name + "-")) return "";
  const std::string digits = stem.substr(scene_name.size() + 1);
  const bool number = digits.size() >= 4 && std::all_of(digits.begin(), digits.end(),
                                                        [](unsigned char c) { return std::isdigit(c); });
  return number ? std::to_string(std::stoull(digits.substr(0, 15))) : "";
}

std::string stem_of(const std::string& path) {
  return path == "-" ? input_name(path) : std::filesystem::path(path).stem().string();
}

}  // namespace

std::string scene_title(const TraceInfo& info, const std::string& path) {
  constexpr std::size_t most_meshes = 3;
  if (info.scene_name.empty()) return stem_of(path);
  // The scene that a bare mesh makes is called after it.
  const std::filesystem::path mesh = info.mesh_files.empty() ? "" : info.mesh_files.front();
  if (info.mesh_files.size() == 1 && mesh.stem() == info.scene_name) return mesh.filename().string();
  std::string title = info.scene_name;
  for (std::size_t i = 0; i < std::min(info.mesh_files.size(), most_meshes); ++i) {
    title += (i == 0 ? ": " : ", ") + std::filesystem::path(info.mesh_files[i]).filename().string();
  }
  return info.mesh_files.size() > most_meshes ? title + ", ..." : title;
}

std::string run_title(const TraceInfo& info, const std::string& path) {
  const std::string title = scene_title(info, path);
  const std::string job = info.scene_name.empty() ? "" : job_number(stem_of(path), info.scene_name);
  if (job.empty()) return title;
  const std::string varied = path == "-" ? "" : varied_in_job(path);
  return title + dot + "job " + job + (varied.empty() ? "" : dot + varied);
}

std::string varied_words(const std::string& title) {
  const std::string_view between = dot;
  const std::size_t job = title.find(std::string(between) + "job ");
  if (job == std::string::npos) return "";
  std::string words = title.substr(job + between.size());
  for (std::size_t at = words.find(between); at != std::string::npos; at = words.find(between))
    words.replace(at, between.size(), ", ");
  return words;
}

}  // namespace fingerpad
