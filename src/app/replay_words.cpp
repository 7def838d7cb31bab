#include "app/replay_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string_view>

#include "app/standard_streams.hpp"
#include "base/build_identity.hpp"
#include "replay/batch_files.hpp"

namespace fingerpad {
namespace {

/// "3, 6, 9 and 15 more": of jobs of one scene.
std::string numbers_of(const std::vector<const BatchJob*>& jobs) {
  constexpr std::size_t most = 6;
  std::string words;
  for (std::size_t i = 0; i < std::min(jobs.size(), most); ++i) {
    const SceneJob& job = jobs[i]->job;
    words += (i > 0 ? ", " : "") + (job.number > 0 ? std::to_string(job.number) : job.scene.name);
  }
  return jobs.size() > most ? words + fmt::format(" and {} more", jobs.size() - most) : words;
}

/// The traces of an earlier run that these jobs leave in their place: the first, and how many more.
void tell_left_behind(const std::vector<const BatchJob*>& failed) {
  std::vector<std::string_view> left;
  for (const BatchJob* job : failed) {
    if (!job->left_behind.empty()) left.emplace_back(job->left_behind);
  }
  if (left.size() == 1)
    print_err("fingerpad: warning: {}: is an earlier run's, since this one failed\n", left[0]);
  if (left.size() > 1)
    print_err("fingerpad: warning: {} and {} more traces: are an earlier run's, since these jobs failed\n",
              left[0], left.size() - 1);
}

/// Each reason once, in the order of the first job that it stopped.
void tell_failures(const std::vector<BatchJob>& jobs) {
  std::vector<std::string_view> reasons;
  std::map<std::string_view, std::vector<const BatchJob*>> stopped;
  for (const BatchJob& job : jobs) {
    if (job.status.empty() || job.status == "ok") continue;
    if (stopped[job.status].empty()) reasons.push_back(job.status);
    stopped[job.status].push_back(&job);
  }
  for (const std::string_view reason : reasons) {
    const std::vector<const BatchJob*>& failed = stopped[reason];
    if (failed.size() > 1) {
      print_err("fingerpad: error: {} jobs ({}): {}\n", failed.size(), numbers_of(failed), reason);
    } else {
      print_err("fingerpad: error: {}\n", reason);
    }
    tell_left_behind(failed);
  }
}

/// Lines that many jobs share: each is told once, and no more than a screen can hold.
class DistinctLines {
 public:
  explicit DistinctLines(std::string_view start) : start_(start) {}

  /// @param lines  outlive this
  void add(const std::vector<std::string>& lines) {
    for (const std::string& line : lines) {
      if (seen_.insert(line).second && seen_.size() <= most_lines) print_err("{}{}\n", start_, line);
    }
  }
  std::size_t left_out() const noexcept { return seen_.size() - std::min(seen_.size(), most_lines); }

 private:
  static constexpr std::size_t most_lines = 12;  // a set has one for every mesh and every place
  std::string_view start_;
  std::set<std::string_view> seen_;
};

}  // namespace

void tell_doubts(const std::vector<BatchJob>& jobs) {
  tell_failures(jobs);
  long coarse_jobs = 0;
  double coarse_teeth = 0, remedied_ticks = 0, inside_starts = 0;
  for (const BatchJob& job : jobs) {
    if (job.status != "ok") continue;
    const double coarse = Figures::of(job.figures, "coarse_teeth");
    coarse_jobs += coarse > 0 ? 1 : 0;
    coarse_teeth += coarse;
    remedied_ticks += Figures::of(job.figures, "remedied_ticks");
    inside_starts += Figures::of(job.figures, "inside_starts");
  }
  if (remedied_ticks > 0) {
    print_err(
        "fingerpad: warning: the stick spring was too stiff for the loop on {} ticks, and "
        "friction.remedy acted (remedied_ticks in summary.csv)\n",
        remedied_ticks);
  }
  if (inside_starts > 0) {
    print_err(
        "fingerpad: warning: {} of the motions start inside of a part, or where the finger does not fit; the "
        "proxy was put at the nearest place outside, where there is one (inside_starts in summary.csv)\n",
        inside_starts);
  }
  if (coarse_jobs == 0) return;
  print_err(
      "fingerpad: warning: {} stick-slip teeth in {} {} lasted under two ticks, too short for any sampling "
      "to "
      "show (coarse_teeth in summary.csv); raise motion.rate_hz or soften the pad\n",
      coarse_teeth, coarse_jobs, coarse_jobs == 1 ? "trace" : "traces");
}

void tell_choices(const std::vector<BatchJob>& jobs) {
  DistinctLines told("fingerpad: ");
  for (const BatchJob& job : jobs) {
    for (const auto* lines : {&job.motion_notes, &job.contact_reasons}) told.add(*lines);
  }
  if (told.left_out() > 0)
    print_err("fingerpad: and {} more such lines; each trace keeps its own\n", told.left_out());
}

void tell_warnings_of_jobs(const std::vector<BatchJob>& jobs) {
  DistinctLines told("fingerpad: warning: ");
  for (const BatchJob& job : jobs) told.add(job.warnings);
  if (told.left_out() > 0)
    print_err(
        "fingerpad: warning: and {} more such lines; summary.csv has every job's figures (contact_ticks, "
        "max_depth_m and so on)\n",
        told.left_out());
}

void tell_made_again(const std::vector<BatchJob>& jobs, const BatchOptions& batch) {
  std::map<std::string_view, std::size_t> of_build;
  for (const BatchJob& job : jobs) {
    if (!job.other_build.empty()) ++of_build[job.other_build];
  }
  for (const auto& [build, count] : of_build)
    print_err(
        "fingerpad: warning: {} of {} {} in {} made again: {} of another build of the program ({}; this one "
        "is "
        "{}), and results of two builds are not mixed\n",
        count, jobs.size(), jobs.size() == 1 ? "job" : "jobs",
        fmt::format("{} {}", batch.out_dir, count == 1 ? "was" : "were"), count == 1 ? "it was" : "they were",
        build, short_build_identity());
}

int tell_lost(const std::vector<Error>& lost) {
  for (const Error& error : lost) print_err("fingerpad: error: {}\n", error.what());
  return lost.empty() ? 0 : static_cast<int>(ErrorKind::fault);
}

void tell_end(const std::vector<BatchJob>& jobs, bool any_table_lost, const BatchOptions& batch) {
  const auto count = [&jobs](auto which) { return std::count_if(jobs.begin(), jobs.end(), which); };
  const auto meant = count([](const BatchJob& job) { return !job.status.empty() || job.not_begun; });
  const auto good = count([](const BatchJob& job) { return job.status == "ok"; });
  const auto kept = count([](const BatchJob& job) { return job.kept; });
  const std::string table = any_table_lost ? "" : table_names(batch.shard, batch.shard_count).summary;
  const bool traces = batch.traces && good > 0;
  const char* both = traces && !table.empty() ? " and " : "";
  print_out("{} of {} {} done{}, {}{}{} in {}\n", good, meant, meant == 1 ? "job" : "jobs",
            kept > 0 ? fmt::format(" ({} kept from before)", kept) : "", traces ? "traces" : "", both,
            table.empty() && !traces ? "nothing" : table, batch.out_dir);
}

void tell_stopped(const std::vector<BatchJob>& jobs, const BatchOptions& batch) {
  const auto count = [&jobs](auto which) { return std::count_if(jobs.begin(), jobs.end(), which); };
  const auto left = count([](const BatchJob& job) { return job.not_begun; });
  const std::string then = batch.traces ? "the same command with --resume does the rest in " + batch.out_dir
                                        : "no traces were kept, so that the same command does all again";
  print_err("fingerpad: warning: stopped before {} {}; {}\n", left,
            left == 1 ? "job was begun" : "jobs were begun", then);
}

}  // namespace fingerpad
