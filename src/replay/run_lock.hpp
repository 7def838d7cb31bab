#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "replay/locked_file.hpp"

namespace fingerpad {

/// The folder inside an output folder where runs keep what is no output: their locks and proofs.
inline constexpr const char* state_folder = ".fingerpad";

/// Keeps two runs from writing one file. A run registers the names that it is going to write in a file of
/// its own in the state folder, and holds a lock of the kernel's on it (flock). The kernel lets go of it when
/// the process ends, however it ends, so that what a killed run leaves behind never stands in the way of the
/// next. Runs with other names, such as the other shards of a batch, go on side by side.
class RunLock {
 public:
  /// Registers `names` for the output folder `folder`, which is there. Throws Error (refused) if a running
  /// process writes one of them, and names it; Error (fault) if the folder cannot be written. On a file
  /// system without locks a process alone registers nothing and goes on.
  /// @param run         of ranks: what they have in common. The first of them registers, the others hold the
  ///                    registration with it, so that it lasts until all have ended. Empty: a process alone
  /// @param when_first  called by the one who registers, before any other can join, and by a process alone
  ///                    where nobody can register; may be empty. What it throws ends the registration
  /// @param made        how many folders were made for this run: the output folder, and those above it.
  ///                    Whichever run of those that meet there ends last removes them if they are empty then
  RunLock(const std::string& folder, const std::vector<std::string>& names, const std::string& run = "",
          const std::function<void(const RunLock&)>& when_first = {}, std::size_t made = 0);
  /// Ends the registration (of ranks, the last does); the state folder goes too if nothing is left in it, and
  /// with it those that were made.
  ~RunLock();
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;

  /// Runs that were found registered but ended before they were done: "process 12 on HOST (COMMAND)".
  const std::vector<std::string>& unfinished() const noexcept { return unfinished_; }

  /// Of ranks this is the last: the registration ends with it. Who leaves before lets the others have it.
  void stays_last() noexcept { others_stay_ = false; }

  /// Whether that file was written since the run has registered.
  bool is_older_than(const std::string& path) const noexcept;

  /// Whether a rank of that run has registered in the folder, living or not.
  static bool is_registered(const std::string& folder, const std::string& run);

 private:
  bool join(const std::string& run);

  std::string folder_, path_;
  OpenFile file_;
  bool others_stay_ = false;
  std::vector<std::string> unfinished_;
};

}  // namespace fingerpad
