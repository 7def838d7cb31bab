#include "replay/stale_traces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "replay/batch_files.hpp"
#include "replay/run_proof.hpp"

namespace fingerpad {
namespace {

namespace fs = std::filesystem;

/// The set that a trace is of by its name, "SET-0012.h5"; empty where that is no such name.
std::string set_of(const fs::path& file) {
  if (file.extension() != ".h5" && file.extension() != ".csv") return "";
  const std::string stem = file.stem().string();
  const std::size_t digits = stem.find_last_not_of("0123456789");
  constexpr std::size_t least_digits = 4;
  if (digits == std::string::npos || stem[digits] != '-' || stem.size() - digits - 1 < least_digits)
    return "";
  return stem.substr(0, digits);
}

}  // namespace

std::string words_of_stale_traces(const std::vector<BatchJob>& jobs, const BatchOptions& options) {
  std::set<std::string> sets, written;
  for (const BatchJob& job : jobs) {
    if (job.job.number == 0) continue;
    sets.insert(job.job.scene.name);
    if (options.traces) written.insert(trace_name(job.job, options.format));
  }
  std::vector<std::string> stale;
  std::error_code failure;
  for (fs::directory_iterator file(options.out_dir, failure), end; !failure && file != end;
       file.increment(failure)) {
    const std::string name = file->path().filename().string();
    if (!written.contains(name) && sets.contains(set_of(file->path())) && has_proof(file->path().string()))
      stale.push_back(name);
  }
  if (stale.empty()) return "";
  std::sort(stale.begin(), stale.end());
  const bool one = stale.size() == 1;
  return fmt::format(
      "{}: {} {} there from an earlier run, which this one does not write: {}{}; delete {} "
      "where nobody needs {}",
      options.out_dir, stale.size(), one ? "trace is" : "traces are", stale.front(),
      one ? "" : fmt::format(" to {}", stale.back()), one ? "it" : "them", one ? "it" : "them");
}

}  // namespace fingerpad
