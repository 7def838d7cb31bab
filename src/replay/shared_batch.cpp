#include "replay/shared_batch.hpp"

#include <fmt/format.h>

#include <chrono>
#include <deque>
#include <filesystem>
#include <mutex>
#include <thread>

#include "base/error.hpp"
#include "replay/batch_files.hpp"
#include "replay/claimed_folder.hpp"
#include "replay/job_outcome_text.hpp"
#include "replay/job_runner.hpp"
#include "replay/rank_log.hpp"
#include "replay/ranks_board.hpp"
#include "replay/summary.hpp"
#include "replay/watched_rank.hpp"

namespace fingerpad {
namespace {

namespace fs = std::filesystem;

/// This rank's part in it.
class RankWork {
 public:
  RankWork(std::vector<BatchJob>& jobs, const BatchOptions& options, const Ranks& ranks, RankLog& log,
           WatchedRank& watched)
      : jobs_(jobs),
        options_(options),
        ranks_(ranks),
        log_(log),
        watched_(watched),
        board_(ranks_board(jobs, options)),
        runner_(jobs, options) {
    // What a process that died had taken for this rank.
    const std::vector<std::size_t> taken = read_rank_story(ranks_folder(options), ranks.rank).not_begun;
    take(taken);
  }

  void run(const std::function<void(const BatchJob&)>& on_done) {
    runner_.run([this](std::size_t) { return next(); },
                [&](std::size_t job) {
                  ended(job);
                  on_done(jobs_[job]);
                });
    runner_.hold(std::nullopt);
  }

  /// Leaves, unless no other is left.
  /// @returns whether this is the last, who stays to the end
  bool is_last() {
    using std::chrono::steady_clock;
    constexpr std::chrono::milliseconds between_looks{50};
    for (const auto end = steady_clock::now() + options_.patience;;) {
      {
        const JobBoard::Hold hold(board_);
        int living = 0, missing = 0;
        for (int rank = 0; rank < ranks_.count; ++rank) {
          const RankState state =
              rank == ranks_.rank ? RankState::gone : rank_state(ranks_folder(options_), rank);
          living += state == RankState::living ? 1 : 0;
          missing += state == RankState::not_come ? 1 : 0;
        }
        if (!log_.is_in_place()) return true;  // the folder is removed: nobody finds the others, each tells
        if (living > 0) {
          watched_.has_left();
          log_.leave();
          return false;
        }
        const bool impatient = steady_clock::now() > end || stops();
        if (missing > 0 && impatient && options_.on_unfinished)
          options_.on_unfinished(fmt::format("{}: {} of {} ranks {}", options_.out_dir, missing, ranks_.count,
                                             stops() ? "had not come yet when it was told to stop"
                                                     : "never came; do all machines see this folder?"));
        if (missing == 0 || impatient) return true;
      }
      std::this_thread::sleep_for(between_looks);
    }
  }

  /// Whether nobody finds the ranks' files any more.
  bool is_removed() const noexcept { return !log_.is_in_place(); }

  /// Where it is removed: what others did is not known.
  void lose_all() {
    for (const std::size_t job : board_.jobs()) {
      if (!jobs_[job].status.empty()) continue;
      jobs_[job].status = fmt::format(
          "{}: was removed while ranks were at work, and how this job ended with it", options_.out_dir);
      jobs_[job].exit_code = static_cast<int>(ErrorKind::fault);
    }
  }

  /// Puts together what all ranks tell; then does itself what was taken by one that is gone.
  void end(const std::function<void(const BatchJob&)>& on_done) {
    collect();
    std::vector<std::size_t> left;
    for (const std::size_t job : board_.jobs()) {
      if (jobs_[job].status.empty()) left.push_back(job);
    }
    if (left.empty() || stops()) return;
    take(left);
    run(on_done);
    collect();
  }

 private:
  bool stops() const { return options_.should_stop && options_.should_stop(); }

  void take(const std::vector<std::size_t>& jobs) {
    runner_.expect(jobs);
    if (!jobs.empty()) runner_.hold(jobs.back());
    ours_.insert(ours_.end(), jobs.begin(), jobs.end());
  }

  std::optional<std::size_t> next() {
    const std::lock_guard lock(mutex_);
    if (stops()) return std::nullopt;
    if (ours_.empty()) {
      const std::vector<std::size_t> claimed = board_.claim(ranks_.count, done_since_);
      done_since_ = 0;
      log_.took(claimed);
      take(claimed);
      if (options_.on_elsewhere) options_.on_elsewhere(board_.done_count() - done_);
    }
    if (ours_.empty()) return std::nullopt;
    const std::size_t job = ours_.front();
    ours_.pop_front();
    log_.begins(job);
    watched_.begins_job();
    return job;
  }

  void ended(std::size_t job) {
    const std::lock_guard lock(mutex_);
    log_.ended(job, outcome_text(jobs_[job], job));
    ++done_since_;
    ++done_;
  }

  void collect() {
    std::vector<RankStory> stories;
    for (int rank = 0; rank < ranks_.count; ++rank) {
      stories.push_back(read_rank_story(ranks_folder(options_), rank));
      for (const std::string& outcome : stories.back().outcomes) take_outcome(jobs_, outcome);
    }
    for (const RankStory& story : stories) {
      for (const RankStory::Lost& lost : story.lost) {
        if (lost.job >= jobs_.size() || !jobs_[lost.job].status.empty()) continue;
        jobs_[lost.job].status = lost.reason;
        jobs_[lost.job].exit_code = static_cast<int>(ErrorKind::fault);
      }
    }
  }

  std::vector<BatchJob>& jobs_;
  const BatchOptions& options_;
  const Ranks& ranks_;
  RankLog& log_;
  WatchedRank& watched_;
  JobBoard board_;
  JobRunner runner_;
  std::mutex mutex_;
  std::deque<std::size_t> ours_;  ///< taken, not begun
  std::size_t done_ = 0, done_since_ = 0;
};

/// The run, and the ranks of it that have not come by its end: of those alone it has ended without them.
std::string run_and_missing(const BatchOptions& options, const Ranks& ranks) {
  std::string words = ranks.run;
  for (int rank = 0; rank < ranks.count; ++rank) {
    if (rank != ranks.rank && rank_state(ranks_folder(options), rank) == RankState::not_come)
      words += missing_rank_words(rank);
  }
  return words;
}

std::vector<Error> write_tables(std::vector<BatchJob>& jobs, const BatchOptions& options,
                                const Ranks& ranks) {
  mark_not_begun(jobs, jobs_of_shard(jobs.size(), options));
  std::vector<Error> lost;
  const fs::path index = fs::path(options.out_dir) / table_names(options.shard, options.shard_count).jobs;
  std::error_code none;
  if (!fs::exists(index, none))
    lost = write_job_index(jobs, options);  // the first could not, and told nobody
  for (const Error& error : write_summary(jobs, options, run_and_missing(options, ranks)))
    lost.push_back(error);
  return lost;
}

/// The log of a rank that comes, while nobody looks who is there. The board is closed again, so that a child
/// that dies with it held does not leave it held here.
RankLog log_of_own(const std::vector<BatchJob>& jobs, const BatchOptions& options, const Ranks& ranks) {
  const JobBoard board = ranks_board(jobs, options);
  const JobBoard::Hold hold(board);
  return RankLog(ranks_folder(options), ranks.rank);
}

/// Takes part, once the folder is claimed.
BatchEnd take_part(std::vector<BatchJob>& jobs, const BatchOptions& options, const Ranks& ranks,
                   const std::function<void(const BatchJob&)>& on_done, RunLock& claim) {
  RankLog log = log_of_own(jobs, options, ranks);
  WatchedRank watched(log, ranks,
                      [&] { tell_of_killed_rank(jobs, options, ranks); });  // from here on in a child process
  RankWork work(jobs, options, ranks, log, watched);
  work.run(on_done);
  if (!work.is_last()) return {false, {}};
  if (work.is_removed()) {
    work.lose_all();
    return {true,
            {Error(ErrorKind::fault, options.out_dir,
                   "was removed while ranks were at work, and the tables with it")}};
  }
  claim.stays_last();
  work.end(on_done);
  BatchEnd end{true, write_tables(jobs, options, ranks)};
  std::error_code ignored;
  fs::remove_all(ranks_folder(options), ignored);
  watched.has_left();
  return end;
}

}  // namespace

BatchEnd run_shared_batch(std::vector<BatchJob>& jobs, const BatchOptions& options, const Ranks& ranks,
                          const std::function<void(const BatchJob&)>& on_done) {
  std::unique_ptr<RunLock> claim;
  try {
    claim = claimed_folder(jobs, options, ranks, [&] {
              write_job_index(jobs, options);
              make_ranks_board(jobs, options);
            }).lock;
  } catch (const StoppedBeforeTheFirst&) {
    mark_not_begun(jobs, jobs_of_shard(jobs.size(), options));
    return {};
  }
  if (!claim) return {false, {}};  // it came too late: the others have done and told all
  try {
    return take_part(jobs, options, ranks, on_done, *claim);
  } catch (const Error& error) {
    std::error_code none;
    if (has_ranks_board(options)) throw;
    const TableNames names = table_names(options.shard, options.shard_count);
    if (claim->is_older_than((fs::path(options.out_dir) / names.summary).string()))
      return {false, {}};  // the same, and it saw them leave
    // The folder was good when the run began: what is wrong with it now is no fault of the call.
    throw Error(ErrorKind::fault, "", error.what());
  }
}

}  // namespace fingerpad
