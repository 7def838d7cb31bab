#include "replay/rank_work.hpp"

#include <fmt/format.h>

#include <chrono>
#include <thread>

#include "base/error.hpp"
#include "replay/batch_files.hpp"
#include "replay/claimed_folder.hpp"
#include "replay/job_outcome_text.hpp"
#include "replay/ranks_board.hpp"

namespace fingerpad {
RankWork::RankWork(std::vector<BatchJob>& jobs, const BatchOptions& options, const Ranks& ranks, RankLog& log,
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

void RankWork::run(const std::function<void(const BatchJob&)>& on_done) {
  runner_.run([this](std::size_t) { return next(); },
              [&](std::size_t job) {
                ended(job);
                on_done(jobs_[job]);
              });
  runner_.hold(std::nullopt);
}

bool RankWork::is_last() {
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

void RankWork::lose_all() {
  for (const std::size_t job : board_.jobs()) {
    if (!jobs_[job].status.empty()) continue;
    jobs_[job].status = fmt::format(
        "{}: was removed while ranks were at work, and how this job ended with it", options_.out_dir);
    jobs_[job].exit_code = static_cast<int>(ErrorKind::fault);
  }
}

void RankWork::end(const std::function<void(const BatchJob&)>& on_done) {
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

void RankWork::take(const std::vector<std::size_t>& jobs) {
  runner_.expect(jobs);
  if (!jobs.empty()) runner_.hold(jobs.back());
  ours_.insert(ours_.end(), jobs.begin(), jobs.end());
}

std::optional<std::size_t> RankWork::next() {
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

void RankWork::ended(std::size_t job) {
  const std::lock_guard lock(mutex_);
  log_.ended(job, outcome_text(jobs_[job], job));
  ++done_since_;
  ++done_;
}

void RankWork::collect() {
  std::vector<RankStory> stories;
  for (int rank = 0; rank < ranks_.count; ++rank) {
    stories.push_back(read_rank_story(ranks_folder(options_), rank));
    for (const std::string& outcome : stories.back().outcomes) take_outcome(jobs_, outcome);
  }
  for (const RankStory& story : stories) {
    for (const RankStory::Lost& lost : story.lost) {
      if (lost.job >= jobs_.size() || !jobs_[lost.job].status.empty()) continue;
      jobs_[lost.job].status = fmt::format("{}; {}", lost.reason, mend_of_unfinished(options_));
      jobs_[lost.job].exit_code = static_cast<int>(ErrorKind::fault);
    }
  }
}

}  // namespace fingerpad
