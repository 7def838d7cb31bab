#include "trace/trace_folder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "base/error.hpp"
#include "base/printable_text.hpp"
#include "trace/trace.hpp"
#include "trace/trace_glance.hpp"

namespace fingerpad {
namespace {

namespace fs = std::filesystem;

/// Files whose names may be a trace's, by name; of a huge folder some.
std::vector<std::string> candidates_in(const std::string& folder) {
  constexpr std::size_t most = 10'000;
  std::vector<std::string> files;
  std::error_code failure;
  for (fs::directory_iterator at(folder, failure); !failure && at != fs::directory_iterator();
       at.increment(failure)) {
    const std::string ending = at->path().extension().string();
    if (ending == ".h5" || ending == ".csv") files.push_back(at->path().string());
    if (files.size() == most) break;
  }
  std::sort(files.begin(), files.end());
  return files;
}

bool is_trace(const std::string& path) {
  return (is_hdf5(path) && !is_foreign_hdf5(path)) || is_csv_trace(path) || is_partial_csv_trace(path);
}

}  // namespace

void refuse_trace_folder(const std::string& path, std::string_view wanted) {
  std::error_code none;
  if (!fs::is_directory(path, none)) return;
  constexpr std::size_t most_named = 3;
  std::vector<std::string> named;
  bool are_more = false;
  for (const std::string& file : candidates_in(path)) {
    if (!is_trace(file)) continue;
    are_more = named.size() == most_named;
    if (are_more) break;
    named.push_back(printable(file, 200));
  }
  const std::string traces =
      named.empty() ? "no trace is in it"
                    : fmt::format("name one: {}{}", fmt::join(named, ", "), are_more ? ", ..." : "");
  throw refused(path, fmt::format("is a folder, not {}; {}", wanted, traces));
}

}  // namespace fingerpad
