#include "replay/shared_batch.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "base/error.hpp"
#include "replay/batch_files.hpp"
#include "replay/claimed_folder.hpp"
#include "replay/rank_log.hpp"
#include "replay/rank_work.hpp"
#include "replay/ranks_board.hpp"
#include "replay/summary.hpp"
#include "replay/watched_rank.hpp"

namespace fingerpad {
namespace {

namespace fs = std::filesystem;

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
    if (has_ranks_board(options)) throw;
    const TableNames names = table_names(options.shard, options.shard_count);
    if (claim->is_older_than((fs::path(options.out_dir) / names.summary).string()))
      return {false, {}};  // the same, and it saw them leave
    // The folder was good when the run began: what is wrong with it now is no fault of the call.
    throw Error(ErrorKind::fault, "", error.what());
  }
}

}  // namespace fingerpad
