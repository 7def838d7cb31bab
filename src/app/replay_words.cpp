#include "app/replay_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <string_view>
#include <utility>

#include "app/distinct_lines.hpp"
#include "app/standard_streams.hpp"
#include "base/count_words.hpp"
#include "base/number_text.hpp"
#include "contact/contact_method_table.hpp"
#include "replay/batch_files.hpp"
#include "replay/hard_press.hpp"
#include "touch/servo_words.hpp"

namespace fingerpad {
namespace {

/// Whether a number alone does not tell whose job it is.
bool are_of_several_sets(const std::vector<BatchJob>& jobs) {
  const std::string* set = nullptr;
  for (const BatchJob& job : jobs) {
    if (job.job.number == 0) continue;
    if (set == nullptr) set = &job.job.scene.name;
    if (*set != job.job.scene.name) return true;
  }
  return false;
}

/// "3, 6, 9 and 15 more"; in a batch of several sets as their traces are called: "lab-0003, knob-0001".
std::string numbers_of(const std::vector<const BatchJob*>& some, const std::vector<BatchJob>& jobs) {
  constexpr std::size_t most = 6;
  const bool by_set = are_of_several_sets(jobs);
  std::string words;
  for (std::size_t i = 0; i < std::min(some.size(), most); ++i) {
    const SceneJob& job = some[i]->job;
    words += (i > 0 ? ", " : "") + (job.number > 0 && !by_set ? std::to_string(job.number) : job_name(job));
  }
  return some.size() > most ? words + fmt::format(" and {} more", some.size() - most) : words;
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
    print_err("fingerpad: warning: {} and {}: are an earlier run's, since these jobs failed\n", left[0],
              count_words(left.size() - 1, "more trace"));
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
      print_err("fingerpad: error: {} jobs ({}): {}\n", failed.size(), numbers_of(failed, jobs), reason);
    } else if (failed[0]->job.number > 0) {
      print_err("fingerpad: error: job {}: {}\n", numbers_of(failed, jobs), reason);
    } else {
      print_err("fingerpad: error: {}\n", reason);
    }
    tell_left_behind(failed);
  }
}

/// The jobs that have some of one figure, and how much they have together.
struct Trouble {
  std::vector<const BatchJob*> jobs;
  double count = 0;
};

Trouble trouble_of(const std::vector<BatchJob>& jobs, std::string_view figure) {
  Trouble trouble;
  for (const BatchJob& job : jobs) {
    const double count = job.status == "ok" ? Figures::of(job.figures, figure) : 0;
    if (!(count > 0)) continue;
    trouble.jobs.push_back(&job);
    trouble.count += count;
  }
  return trouble;
}

/// "job 3", "3 jobs (3, 6, 9)"; of a scene without a set its name.
std::string jobs_words(const std::vector<const BatchJob*>& some, const std::vector<BatchJob>& jobs) {
  if (some.size() > 1) return fmt::format("{} jobs ({})", some.size(), numbers_of(some, jobs));
  return (some[0]->job.number > 0 ? "job " : "") + numbers_of(some, jobs);
}

void tell_pop_throughs(const std::vector<BatchJob>& jobs) {
  const Trouble pops = trouble_of(jobs, "pop_throughs");
  if (pops.jobs.empty()) return;
  const std::string_view firmest = contact_method_table().back().name;
  // Between planes no method is asked.
  const bool by_firmest = std::any_of(pops.jobs.begin(), pops.jobs.end(), [&](const BatchJob* job) {
    return job->contact_method == firmest || find_contact_method(job->contact_method) == nullptr;
  });
  print_err(
      "fingerpad: warning: {} {} in {}: the finger went through a wall, or was pushed out on its far side "
      "(pop_throughs in summary.csv); {}\n",
      pops.count, pops.count == 1 ? "pop-through" : "pop-throughs", jobs_words(pops.jobs, jobs),
      by_firmest ? "press less deep there" : fmt::format("contact.method = \"{}\" holds it", firmest));
}

void tell_unsettled(const std::vector<BatchJob>& jobs) {
  const Trouble unsettled = trouble_of(jobs, "unsettled_ticks");
  if (unsettled.jobs.empty()) return;
  print_err("fingerpad: warning: {}\n",
            unsettled_words(unsettled.count, " in " + jobs_words(unsettled.jobs, jobs),
                            " (unsettled_ticks in summary.csv)"));
}

/// Rubs that somewhere press far harder than they are to.
void tell_hard_presses(const std::vector<BatchJob>& jobs) {
  std::vector<const BatchJob*> hard;
  HardPress most{0, 1};
  for (const BatchJob& job : jobs) {
    const auto press = job.status == "ok" ? hard_press(job.job.scene, job.figures) : std::nullopt;
    if (!press) continue;
    hard.push_back(&job);
    if (press->felt_n * most.asked_n >= most.felt_n * press->asked_n) most = *press;
  }
  if (hard.empty()) return;
  print_err(
      "fingerpad: warning: the normal force is up to {} N where {} N is asked for, in {}: several walls or "
      "edges hold the finger there (max_normal_force_n in summary.csv); another motion.place leaves it out\n",
      rounded_text(most.felt_n, 3), rounded_text(most.asked_n, 3), jobs_words(hard, jobs));
}

/// "bracket, knob and 3 more: ".
std::string scenes_start(const std::vector<std::string_view>& names) {
  constexpr std::size_t most = 3;
  const auto named = std::span(names).first(std::min(names.size(), most));
  const std::string more = names.size() > most ? fmt::format(" and {} more", names.size() - most) : "";
  return fmt::format("{}{}: ", fmt::join(named, ", "), more);
}

/// The contact reasons of each job. They begin with the mesh, which scenes may share: of several scenes each
/// begins with those that it is of.
std::vector<std::vector<std::string>> reasons_by_scene(const std::vector<BatchJob>& jobs) {
  std::map<std::string_view, std::vector<std::string_view>> scenes_of;
  std::set<std::string_view> scenes;
  for (const BatchJob& job : jobs) {
    const std::string_view name = job.job.scene.name;
    scenes.insert(name);
    for (const std::string& reason : job.contact_reasons) {
      std::vector<std::string_view>& names = scenes_of[reason];
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    }
  }
  std::vector<std::vector<std::string>> reasons;
  reasons.reserve(jobs.size());
  for (const BatchJob& job : jobs) {
    std::vector<std::string>& own = reasons.emplace_back(job.contact_reasons);
    if (scenes.size() < 2) continue;
    for (std::size_t i = 0; i < own.size(); ++i)
      own[i] = scenes_start(scenes_of[job.contact_reasons[i]]) + own[i];
  }
  return reasons;
}

/// Of all jobs those of this shard.
long meant_jobs(const std::vector<BatchJob>& jobs) {
  return std::count_if(jobs.begin(), jobs.end(),
                       [](const BatchJob& job) { return !job.status.empty() || job.not_begun; });
}

}  // namespace

void tell_doubts(const std::vector<BatchJob>& jobs) {
  tell_failures(jobs);
  tell_pop_throughs(jobs);
  tell_unsettled(jobs);
  tell_hard_presses(jobs);
  const Trouble remedied = trouble_of(jobs, "remedied_ticks"), inside = trouble_of(jobs, "inside_starts"),
                coarse = trouble_of(jobs, "coarse_teeth");
  if (remedied.count > 0) {
    print_err(
        "fingerpad: warning: the stick spring was too stiff for the loop on {} ticks, and "
        "friction.remedy acted (remedied_ticks in summary.csv)\n",
        remedied.count);
  }
  if (inside.count > 0) {
    print_err(
        "fingerpad: warning: {} of the motions start inside of a part, or where the finger does not fit: it "
        "is "
        "pushed to the nearest place outside, where there is one (inside_starts in summary.csv)\n",
        inside.count);
  }
  if (coarse.count == 0) return;
  print_err(
      "fingerpad: warning: {} stick-slip teeth in {} {} lasted under two ticks, too short for any sampling "
      "to "
      "show (coarse_teeth in summary.csv); raise motion.rate_hz or soften the pad\n",
      coarse.count, coarse.jobs.size(), coarse.jobs.size() == 1 ? "trace" : "traces");
}

void tell_choices(const std::vector<BatchJob>& jobs) {
  DistinctLines told("fingerpad: ");
  const std::vector<std::vector<std::string>> reasons = reasons_by_scene(jobs);
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    told.add(jobs[i].motion_notes);
    told.add(reasons[i]);
  }
  if (told.left_out() > 0)
    print_err("fingerpad: and {} more such lines; each trace keeps its own\n", told.left_out());
}

/// Each once, with the jobs of a set that it is of.
void tell_warnings_of_jobs(const std::vector<BatchJob>& jobs) {
  std::vector<std::string_view> lines;  // in the order in which they came up
  std::map<std::string_view, std::vector<const BatchJob*>> of;
  for (const BatchJob& job : jobs) {
    for (const std::string& line : job.warnings) {
      std::vector<const BatchJob*>& warned = of[line];
      if (warned.empty()) lines.push_back(line);
      if (warned.empty() || warned.back() != &job) warned.push_back(&job);
    }
  }
  std::vector<std::string> told;
  for (const std::string_view line : lines) {
    const std::vector<const BatchJob*>& warned = of[line];
    const bool is_of_set = warned[0]->job.number > 0 && jobs.size() > 1;
    told.push_back(fmt::format("{}{}", line, is_of_set ? "; in " + jobs_words(warned, jobs) : ""));
  }
  DistinctLines distinct("fingerpad: warning: ");
  distinct.add(told);
  if (distinct.left_out() > 0)
    print_err(
        "fingerpad: warning: and {} more such lines; summary.csv has every job's figures (contact_ticks, "
        "max_depth_m and so on)\n",
        distinct.left_out());
}

void tell_made_again(const std::vector<BatchJob>& jobs, const BatchOptions& batch, bool quiet) {
  constexpr std::size_t most_reasons = 5;
  const long meant = meant_jobs(jobs);
  // By whether another build's traces were there, which comes first and is a warning; then by the reason.
  std::map<std::pair<bool, std::string_view>, std::size_t> for_reason;
  for (const BatchJob& job : jobs) {
    const MadeAgain& again = job.made_again;
    if (!again.why.empty() && (again.of_other_build || !quiet))
      ++for_reason[{!again.of_other_build, again.why}];
  }
  const bool any_kept = std::any_of(jobs.begin(), jobs.end(), [](const BatchJob& job) { return job.kept; });
  std::size_t told = 0, other_jobs = 0;
  for (const auto& [reason, count] : for_reason) {
    if (++told > most_reasons) {
      other_jobs += count;
      continue;
    }
    print_err("fingerpad: {}{}: {}{} of {} {} made again: {}\n",
              reason.first ? "" : "warning: ", batch.out_dir, any_kept ? "" : "no trace was kept: ", count,
              meant, fmt::format("{} {}", meant == 1 ? "job" : "jobs", count == 1 ? "was" : "were"),
              reason.second);
  }
  if (other_jobs > 0)
    print_err("fingerpad: {}: and {} more of them for other reasons\n", batch.out_dir, other_jobs);
}

int tell_lost(const std::vector<Error>& lost) {
  for (const Error& error : lost) print_err("fingerpad: error: {}\n", error.what());
  return lost.empty() ? 0 : static_cast<int>(ErrorKind::fault);
}

void tell_end(const std::vector<BatchJob>& jobs, bool any_table_lost, const BatchOptions& batch) {
  const auto count = [&jobs](auto which) { return std::count_if(jobs.begin(), jobs.end(), which); };
  const long meant = meant_jobs(jobs);
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
  print_err("fingerpad: warning: stopped before {} {}; {} in {}\n", left,
            left == 1 ? "job was begun" : "jobs were begun", mend_of_unfinished(batch), batch.out_dir);
}

}  // namespace fingerpad
