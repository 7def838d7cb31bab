#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "replay/locked_file.hpp"

namespace fingerpad {

/// What one rank tells the others: which jobs it has taken and begun, and how they ended. It holds a lock of
/// the kernel's on its file for as long as it lives: by that the others see whether it does.
class RankLog {
 public:
  /// Opens and locks it, made anew where it is not there. Throws Error: refused where another process holds
  /// it, fault where it cannot be written or locked.
  /// @pre JobBoard::Hold is held: else whoever looks by rank_state() may hold the lock at that moment
  RankLog(const std::string& folder, int rank);

  void took(const std::vector<std::size_t>& jobs);
  void begins(std::size_t job);
  /// @param outcome  outcome_text() of the job
  void ended(std::size_t job, const std::string& outcome);
  /// The process that ran its jobs has been ended by a signal.
  void died(int signal);
  /// It takes no more jobs, and no longer counts as living.
  void leave();
  /// Whether others can find it: its folder may have been removed.
  bool is_in_place() const noexcept;

 private:
  std::string path_;
  void add(std::string_view record);
  OpenFile file_;
};

enum class RankState { not_come, living, gone };

/// Looks whether a rank lives, without waiting, by trying for its lock.
/// @pre JobBoard::Hold is held
RankState rank_state(const std::string& folder, int rank);

/// What a rank's log says in the end.
struct RankStory {
  struct Lost {
    std::size_t job = 0;
    std::string reason;
  };
  std::vector<std::size_t> not_begun;  ///< that it took
  std::vector<std::string> outcomes;   ///< outcome_text()s
  std::vector<Lost> lost;              ///< begun, and nobody knows how they ended
  bool ends_at_a_job = false;          ///< it is at one, or was killed at it
};

/// Of a rank that has not come: nothing.
RankStory read_rank_story(const std::string& folder, int rank);

}  // namespace fingerpad
