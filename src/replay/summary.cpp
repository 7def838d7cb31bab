#include "replay/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "base/error.hpp"
#include "base/number_text.hpp"

namespace fingerpad {
namespace {

/// A CSV cell: quoted where it must be (RFC 4180).
std::string cell(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

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

std::string summary_text(const std::vector<BatchJob>& jobs) {
  const auto keys = set_keys(jobs);
  std::string text = "scene,job";
  for (const std::string& key : keys) text += "," + cell(key);
  text += ",status";
  for (const std::string_view name : Figures::names()) text += fmt::format(",{}", name);
  text += ",contact_method,contact_normals\n";
  for (const BatchJob& job : jobs) {
    if (job.status.empty()) continue;
    text += fmt::format("{},{}", cell(job.job.scene.name), job.job.number);
    for (const std::string& key : keys) text += "," + cell(set_value(job, key));
    text += "," + cell(job.status);
    for (std::size_t i = 0; i < Figures::names().size(); ++i) {
      text += "," + number_text(job.status == "ok" ? job.figures[i] : TickRecord::nan);
    }
    text += fmt::format(",{},{}\n", job.contact_method, job.contact_normals);
  }
  return text;
}

std::string timing_text(const std::vector<BatchJob>& jobs) {
  std::string text = "scene,job,seconds\n";
  for (const BatchJob& job : jobs) {
    if (job.status.empty()) continue;
    text += fmt::format("{},{},{:.6f}\n", cell(job.job.scene.name), job.job.number, job.seconds);
  }
  return text;
}

void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw Error(ErrorKind::fault, path.string(), "cannot be written");
}

}  // namespace

void write_summary(const std::vector<BatchJob>& jobs, const BatchOptions& options) {
  const std::string shard =
      options.shard_count > 1 ? fmt::format("-{}of{}", options.shard, options.shard_count) : std::string();
  const std::filesystem::path folder(options.out_dir);
  write_text(folder / ("summary" + shard + ".csv"), summary_text(jobs));
  write_text(folder / ("timing" + shard + ".csv"), timing_text(jobs));
}

}  // namespace fingerpad
