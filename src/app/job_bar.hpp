#pragma once

#include <chrono>
#include <map>
#include <mutex>
#include <string>
#include <string_view>

#include "app/progress_bar.hpp"
#include "replay/batch.hpp"

namespace fingerpad {

/// How many jobs are done, how far those under way are, at what pace, and what is being loaded for
/// the next: a bar on a terminal, elsewhere a line now and then. Thread-safe.
class JobBar {
 public:
  enum class Shown { nothing, bar, lines };
  /// @param between_lines  at least so long passes from one line to the next
  JobBar(std::size_t total, Shown shown, std::chrono::milliseconds between_lines);

  void advance(const BatchJob& job);
  /// So many jobs have been ended by other ranks.
  void elsewhere(std::size_t count);
  void load(std::string_view stage, double done);
  void run(const BatchJob& job, double share_done);
  void finish() { bar_.finish(); }

 private:
  using Clock = std::chrono::steady_clock;
  void show(const std::string& what);
  std::string pace_words(double done, double seconds) const;

  std::mutex mutex_;
  std::size_t total_, done_ = 0, elsewhere_ = 0;
  Shown shown_;
  std::chrono::milliseconds between_lines_;
  Clock::time_point start_, last_line_;
  std::map<const BatchJob*, double> under_way_;  ///< the share that is done of each
  ProgressBar bar_;
};

}  // namespace fingerpad
