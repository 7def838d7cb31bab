#include "replay/ranks_board.hpp"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <span>
#include <thread>

#include "base/content_hash.hpp"
#include "base/error.hpp"
#include "replay/batch_files.hpp"
#include "replay/claimed_folder.hpp"
#include "replay/rank_log.hpp"

namespace fingerpad {
namespace {

/// A rank that was killed at a job; none where a lower one than this lives, which tells of it.
/// @pre JobBoard::Hold is held
std::optional<int> killed_rank(const std::string& folder, const Ranks& ranks) {
  std::optional<int> killed;
  for (int rank = 0; rank < ranks.count; ++rank) {
    if (rank == ranks.rank) continue;
    const RankState state = rank_state(folder, rank);
    if (state == RankState::living && rank < ranks.rank) return std::nullopt;
    if (state == RankState::gone && read_rank_story(folder, rank).ends_at_a_job) killed = rank;
  }
  return killed;
}

std::string board_path(const BatchOptions& options) {
  return ranks_folder(options) + "/board";
}

/// Tells batches apart by their jobs' names and values.
std::uint64_t hash_of_jobs(const std::vector<BatchJob>& jobs) {
  std::uint64_t hash = content_hash({});
  const auto add = [&hash](const std::string& text) {
    hash = content_hash(std::as_bytes(std::span(text)), hash);
    hash = content_hash(std::as_bytes(std::span("\n")), hash);
  };
  for (const BatchJob& job : jobs) {
    add(job.job.scene.name);
    add(std::to_string(job.job.number));
    for (const auto& [key, value] : job.job.set_keys) add(fmt::format("{}={}", key, value));
  }
  return hash;
}

}  // namespace

void make_ranks_board(const std::vector<BatchJob>& jobs, const BatchOptions& options) {
  std::error_code failure;
  std::filesystem::create_directory(ranks_folder(options), failure);
  JobBoard::create(board_path(options), order_by_cost(jobs, jobs_of_shard(jobs.size(), options), 1),
                   hash_of_jobs(jobs));
}

JobBoard ranks_board(const std::vector<BatchJob>& jobs, const BatchOptions& options) {
  return {board_path(options), hash_of_jobs(jobs)};
}

bool has_ranks_board(const BatchOptions& options) {
  std::error_code none;
  return std::filesystem::exists(board_path(options), none);
}

void tell_of_killed_rank(const std::vector<BatchJob>& jobs, const BatchOptions& options, const Ranks& ranks) {
  using std::chrono::steady_clock;
  // The process that worked for it may be about to end; the launcher waits a second before it kills.
  constexpr std::chrono::milliseconds patience{300}, between_looks{20};
  std::optional<int> killed;
  try {
    const JobBoard board = ranks_board(jobs, options);
    for (const auto end = steady_clock::now() + patience; !killed && steady_clock::now() < end;) {
      {
        const auto hold = JobBoard::Hold::at_once(board);
        if (hold) killed = killed_rank(ranks_folder(options), ranks);
      }
      if (!killed) std::this_thread::sleep_for(between_looks);
    }
  } catch (const Error&) {
    return;  // the folder is gone
  }
  if (!killed || !options.on_unfinished) return;
  options.on_unfinished(fmt::format(
      "{}: rank {} was killed: where nobody asked for the end, what started the ranks ends the others for "
      "that; {}. Open MPI lets the others go on where it is told `mpirun --enable-recovery`",
      options.out_dir, *killed, mend_of_unfinished(options)));
}

}  // namespace fingerpad
