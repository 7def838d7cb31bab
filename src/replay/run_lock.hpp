#pragma once

#include <memory>
#include <string>
#include <vector>

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
  /// process writes one of them, and names it; Error (fault) if the folder cannot be written.
  RunLock(const std::string& folder, const std::vector<std::string>& names);
  /// Ends the registration; the state folder goes too if nothing is left in it.
  ~RunLock();
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;

  /// Runs that were found registered but ended before they were done: "process 12 on HOST (COMMAND)".
  const std::vector<std::string>& unfinished() const noexcept { return unfinished_; }

  /// Of the registration, for join().
  const std::string& path() const noexcept { return path_; }
  /// Another process of the same run holds the registration with it, so that it lasts until all have ended.
  /// Where the file cannot be seen (on another machine), or locks do not work, there is nothing to hold.
  static std::shared_ptr<void> join(const std::string& path);

 private:
  std::string folder_, path_;
  int file_ = -1;
  std::vector<std::string> unfinished_;
};

}  // namespace fingerpad
