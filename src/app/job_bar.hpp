#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

#include "app/next_line.hpp"
#include "app/progress_bar.hpp"
#include "replay/batch.hpp"

namespace fingerpad {

/// How many jobs are done, how far those under way are, at what pace, and what is being loaded for
/// the next: a bar on a terminal, elsewhere a line now and then. Thread-safe.
class JobBar {
 public:
  using Shown = ShownProgress;
  /// @param between_lines  at least so long passes from one line to the next
  JobBar(std::size_t total, Shown shown, std::chrono::milliseconds between_lines);

  /// From when the batch is told to stop, what it still waits for is said. Before the first job.
  /// @param by_ctrl_c  whether Ctrl-C told it, so that a second one ends it at once
  void watch_stop(std::function<bool()> is_told_to_stop, std::function<bool()> by_ctrl_c) {
    is_told_to_stop_ = std::move(is_told_to_stop);
    by_ctrl_c_ = std::move(by_ctrl_c);
  }

  void advance(const BatchJob& job);
  /// So many jobs have been ended by other ranks.
  void elsewhere(std::size_t count);
  void load(std::string_view stage, double done);
  void run(const BatchJob& job, double share_done);
  void finish() { bar_.finish(); }

 private:
  using Clock = std::chrono::steady_clock;
  /// @param name  of which the middle is left out where the line has no room for it
  void show(std::string_view name, const std::string& behind_it);
  std::string stop_words() const;
  void tell_stop();

  std::mutex mutex_;
  std::size_t total_, done_ = 0, elsewhere_ = 0;
  Shown shown_;
  NextLine next_line_;
  Clock::time_point start_;
  std::map<const BatchJob*, double> under_way_;  ///< the share that is done of each
  std::function<bool()> is_told_to_stop_, by_ctrl_c_;
  bool has_told_stop_ = false;  ///< in a line of its own
  ProgressBar bar_;
};

}  // namespace fingerpad
