#include "replay/claimed_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>

#include "base/error.hpp"
#include "base/output_place.hpp"
#include "replay/batch_files.hpp"
#include "replay/kept_summary.hpp"
#include "replay/run_proof.hpp"
#include "replay/stale_traces.hpp"
#include "replay/summary.hpp"

namespace fingerpad {
namespace {

/// Thrown while a folder is being claimed for a run that has ended.
struct RunHasEnded {};

/// Whether the ranks have ended without this one, which comes late. Another start can have the same name (one
/// of a launcher with the same process number, as in a container): tables are believed that were written
/// after its own launcher began.
bool has_ended(const BatchOptions& options, const Ranks& ranks) {
  std::filesystem::file_time_type written_at;
  if (!ranks.are_many() || !is_summed_up_without(ranks.rank, options, ranks.run, written_at)) return false;
  const auto launched_at = launch_time(ranks);
  return launched_at && std::chrono::file_clock::to_sys(written_at) > *launched_at;
}

/// The root comes first, so that it tells what is refused; if it does not come, another does its work. Where
/// the tables say that the ranks have ended without this one, it waits a moment only, for a root that its
/// launcher has called again. One that is asked to stop waits no longer: it leaves all for --resume.
void wait_for_root(const BatchOptions& options, const Ranks& ranks) {
  using std::chrono::steady_clock;
  constexpr std::chrono::milliseconds between_looks{20};
  constexpr std::chrono::duration<double> moment{1};
  const std::chrono::duration<double> patience =
      has_ended(options, ranks) ? std::min(options.patience, moment) : options.patience;
  for (const auto end = steady_clock::now() + patience; steady_clock::now() < end;) {
    if (RunLock::is_registered(options.out_dir, ranks.run) || launcher_is_gone(ranks)) return;
    if (options.should_stop && options.should_stop()) return;
    std::this_thread::sleep_for(between_looks);
  }
}

/// Said before hours are spent on it, by the first traces that are there; empty where none is another
/// build's.
std::string words_of_other_build(const std::vector<BatchJob>& jobs, const BatchOptions& options) {
  constexpr std::size_t most_looked_at = 1000;  // on a shared disk each takes a moment
  const std::vector<std::size_t> ours = jobs_of_shard(jobs.size(), options);
  for (std::size_t k = 0; k < std::min(ours.size(), most_looked_at); ++k) {
    const std::string path =
        fmt::format("{}/{}", options.out_dir, trace_name(jobs[ours[k]].job, options.format));
    if (const auto build = other_build_of(path))
      return fmt::format("{}: holds traces of {}: they are made again", options.out_dir,
                         other_build_words(*build));
  }
  return "";
}

}  // namespace

std::string ranks_folder(const BatchOptions& options) {
  return fmt::format("{}/{}/ranks-{}of{}", options.out_dir, state_folder, options.shard, options.shard_count);
}

ClaimedFolder claimed_folder(const std::vector<BatchJob>& jobs, const BatchOptions& options,
                             const Ranks& ranks, const std::function<void()>& when_first) {
  if (!ranks.is_root()) wait_for_root(options, ranks);
  // Nobody waits for it, and another run may be at work here by now.
  if (ranks.are_many() && launcher_is_gone(ranks))
    throw Error(ErrorKind::fault, options.out_dir,
                fmt::format("rank {} writes nothing there: what started it is gone", ranks.rank));
  if (!RunLock::is_registered(options.out_dir, ranks.run) && has_ended(options, ranks)) return {};
  // Of its run nobody has come: who works there is another run, or has just ended, and its tables stay.
  if (!ranks.is_root() && !RunLock::is_registered(options.out_dir, ranks.run) && options.should_stop &&
      options.should_stop())
    throw StoppedBeforeTheFirst();
  ClaimedFolder folder;
  const bool others_came = ranks.are_many() && RunLock::is_registered(options.out_dir, ranks.run);
  if (!others_came) {
    refuse_collisions(jobs, options);
    folder.made = make_folder(options.out_dir);
  }
  const auto as_first = [&](const RunLock& lock) {
    if (has_ended(options, ranks)) throw RunHasEnded();  // between two looks
    if (others_came) refuse_collisions(jobs, options);   // who came was of an earlier run
    for (const std::string& run : lock.unfinished()) {
      if (options.on_unfinished)
        options.on_unfinished(
            fmt::format("{}: {} ended before it was done; this run takes its place", options.out_dir, run));
    }
    // A lone scene may yet be refused, and leaves the folder as it was then: the summary is kept as it
    // begins.
    if (!is_lone_scene(jobs)) keep_other_summary(jobs, options);
    if (options.on_kept && options.resume) {
      const std::string words = words_of_other_build(jobs, options);
      if (!words.empty()) options.on_kept(words);
    }
    if (options.on_kept) {
      const std::string words = words_of_stale_traces(jobs, options);
      if (!words.empty()) options.on_kept(words);
    }
    std::error_code ignored;
    std::filesystem::remove_all(ranks_folder(options), ignored);
    when_first();
  };
  try {
    folder.lock = std::make_unique<RunLock>(options.out_dir, output_names(jobs, options), ranks.run, as_first,
                                            folder.made.size());
  } catch (const RunHasEnded&) {
    return {};
  }
  return folder;
}

}  // namespace fingerpad
