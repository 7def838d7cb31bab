#include "app/plan_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>

#include "app/distinct_lines.hpp"
#include "app/standard_streams.hpp"
#include "base/number_text.hpp"

namespace fingerpad {
namespace {

std::string file_name(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

std::string duration_words(double seconds) {
  constexpr double minute_s = 60, hour_s = 3600;
  if (seconds < 2 * minute_s) return fmt::format("{} s", rounded_text(seconds, 2));
  if (seconds < 2 * hour_s) return fmt::format("{:.0f} min", seconds / minute_s);
  return fmt::format("{:.1f} h", seconds / hour_s);
}

std::string size_words(double bytes) {
  constexpr const char* units[] = {"kB", "MB", "GB", "TB"};
  int unit = 0;
  for (bytes /= 1e3; bytes >= 1e3 && unit < 3; bytes /= 1e3) ++unit;
  return fmt::format("{} {}", rounded_text(bytes, 3), units[unit]);
}

/// "t-0003.h5: knob.stl, rub.csv, mu_static 0.3: 501 ticks".
/// @param first  of each reason to fail, the job that has told it
void tell_job(const PlannedJob& job, std::map<std::string, std::string>& first) {
  std::string what;
  for (const std::string& words : {file_name(job.mesh), file_name(job.motion), job.values}) {
    if (!words.empty()) what += (what.empty() ? "" : ", ") + words;
  }
  std::string end = fmt::format("{} ticks", job.ticks);
  if (!job.error.empty()) {
    const auto [told, is_new] = first.emplace(job.error, job.file);
    end = is_new ? "would fail: " + job.error : "would fail as " + told->second;
  }
  print_out("{}: {}{}{}\n", job.file, what, what.empty() ? "" : ": ", end);
}

/// The room on the disk of a folder that may not be there yet.
double room_for(const std::string& folder) {
  std::error_code none;
  std::filesystem::path place = std::filesystem::absolute(folder, none);
  while (!std::filesystem::exists(place, none) && place.has_relative_path()) place = place.parent_path();
  const std::filesystem::space_info space = std::filesystem::space(place, none);
  return none ? HUGE_VAL : static_cast<double>(space.available);
}

}  // namespace

bool tell_plan(const BatchPlan& plan, const BatchOptions& batch) {
  std::map<std::string, std::string> first;
  for (const PlannedJob& job : plan.jobs) tell_job(job, first);
  DistinctLines warnings("fingerpad: warning: ");
  warnings.add(plan.warnings);
  if (warnings.left_out() > 0) print_err("fingerpad: warning: and {} more such lines\n", warnings.left_out());
  const auto failing = std::count_if(plan.jobs.begin(), plan.jobs.end(),
                                     [](const PlannedJob& job) { return !job.error.empty(); });
  if (failing > 0 && failing == std::ssize(plan.jobs)) {
    print_out("{}; nothing was written\n",
              failing == 1 ? "the job would fail" : fmt::format("all {} jobs would fail", failing));
    return false;
  }
  print_out(
      "{} {}{}, {:.0f} ticks: about {} on {} {}, {}{} (from {} of {} kinds of jobs tried{}; nothing "
      "was written)\n",
      plan.jobs.size(), plan.jobs.size() == 1 ? "job" : "jobs",
      failing > 0 ? fmt::format(", of which {} would fail", failing) : "", plan.ticks,
      duration_words(plan.seconds), batch.threads, batch.threads == 1 ? "thread" : "threads",
      plan.bytes_unknown.empty() ? size_words(plan.bytes) : "unknown bytes",
      batch.out_dir.empty() ? "" : " in " + batch.out_dir, plan.measured, plan.kinds,
      plan.not_laid > 0 ? fmt::format("; not tried whether the motion of {} can be laid",
                                      plan.not_laid == 1 ? "1 job" : fmt::format("{} jobs", plan.not_laid))
                        : "");
  if (!plan.bytes_unknown.empty())
    print_err("fingerpad: warning: no trace could be tried, so the disk is not reckoned: {}\n",
              plan.bytes_unknown);
  const double room = room_for(batch.out_dir);
  if (plan.bytes > room)
    print_err("fingerpad: warning: {}: the disk has room for {} only\n", batch.out_dir, size_words(room));
  return failing == 0;
}

}  // namespace fingerpad
