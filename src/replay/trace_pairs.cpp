#include "replay/trace_pairs.hpp"

#include <filesystem>
#include <map>

#include "base/error.hpp"
#include "base/path_words.hpp"
#include "trace/trace.hpp"
#include "trace/trace_glance.hpp"

namespace fingerpad {
namespace {

/// "s-0001.csv" of "s-0001.h5", and the other way round.
std::string in_other_format(const std::string& name) {
  return std::filesystem::path(name).replace_extension(name.ends_with(".h5") ? ".csv" : ".h5").string();
}

/// What the other folder has of a trace's job; empty for nothing.
std::string counterpart(const std::string& name, const std::set<std::string>& of_own,
                        const std::set<std::string>& of_other) {
  if (of_other.contains(name)) return name;
  const std::string other = in_other_format(name);
  return of_other.contains(other) && !of_own.contains(other) ? other : "";
}

}  // namespace

std::set<std::string> traces_in(const std::string& folder) {
  namespace fs = std::filesystem;
  std::set<std::string> names;
  std::error_code failure;
  for (fs::directory_iterator at(folder, failure); !failure && at != fs::directory_iterator();
       at.increment(failure)) {
    std::error_code none;
    if (!at->is_regular_file(none)) continue;
    const std::string path = at->path().string();
    if ((path.ends_with(".h5") && is_hdf5(path) && !is_foreign_hdf5(path)) ||
        (path.ends_with(".csv") && (is_csv_trace(path) || is_partial_csv_trace(path))))
      names.insert(at->path().filename().string());
  }
  if (failure) throw refused(folder, "cannot be read: " + folder_words(folder, failure.value()));
  return names;
}

void add_damaged(const std::string& folder, const std::set<std::string>& of_other,
                 std::set<std::string>& own) {
  for (const std::string& name : of_other) {
    std::error_code none;
    if (counterpart(name, of_other, own).empty() &&
        std::filesystem::is_regular_file(std::filesystem::path(folder) / name, none))
      own.insert(name);
  }
}

std::vector<TracePair> trace_pairs(const std::set<std::string>& in_a, const std::set<std::string>& in_b) {
  std::map<std::string, TracePair> by_name;
  for (const std::string& name : in_a) by_name[name] = {name, counterpart(name, in_a, in_b)};
  for (const std::string& name : in_b) {
    if (counterpart(name, in_b, in_a).empty()) by_name[name] = {"", name};
  }
  std::vector<TracePair> pairs;
  pairs.reserve(by_name.size());
  for (auto& [name, pair] : by_name) pairs.push_back(std::move(pair));
  return pairs;
}

}  // namespace fingerpad
