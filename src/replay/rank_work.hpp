#pragma once

#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "replay/batch.hpp"
#include "replay/job_board.hpp"
#include "replay/job_runner.hpp"
#include "replay/rank_log.hpp"
#include "replay/watched_rank.hpp"

namespace fingerpad {

/// One rank's part in a shared batch: it takes jobs from the board, does them, logs what becomes of each, and
/// at the end puts together what all have logged.
class RankWork {
 public:
  RankWork(std::vector<BatchJob>& jobs, const BatchOptions& options, const Ranks& ranks, RankLog& log,
           WatchedRank& watched);

  /// Does jobs until the board has none left.
  void run(const std::function<void(const BatchJob&)>& on_done);
  /// Leaves, unless no other is left.
  /// @returns whether this is the last, who stays to the end
  bool is_last();
  /// Whether nobody finds the ranks' files any more.
  bool is_removed() const noexcept { return !log_.is_in_place(); }
  /// Where it is removed: what others did is not known.
  void lose_all();
  /// Puts together what all ranks tell; then does itself what was taken by one that is gone.
  void end(const std::function<void(const BatchJob&)>& on_done);

 private:
  bool stops() const { return options_.should_stop && options_.should_stop(); }
  void take(const std::vector<std::size_t>& jobs);
  std::optional<std::size_t> next();
  void ended(std::size_t job);
  void collect();

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

}  // namespace fingerpad
