#pragma once

#include <chrono>
#include <string>

#include "app/next_line.hpp"
#include "app/progress_bar.hpp"

namespace fingerpad {

/// How many of a row of things are done, one after another, at what pace, and how long the rest will take:
///
///     [=======             ]  38% 190/500, 21 traces/s, 15 s left
///     fingerpad: 190 of 500 traces read, 38%, 21 traces/s, 15 s left
class CountBar {
 public:
  /// @param many           what is counted: "traces"
  /// @param done           what becomes of them: "read"
  /// @param between_lines  at least so long passes from one line to the next
  /// @param patience       no bar is drawn for so long
  CountBar(std::size_t total, std::string many, std::string done, ShownProgress shown,
           std::chrono::milliseconds between_lines,
           std::chrono::milliseconds patience = std::chrono::milliseconds(500));

  /// One more is done.
  void advance();
  /// Must come before anything else is written to the terminal.
  void finish() { bar_.finish(); }

 private:
  using Clock = std::chrono::steady_clock;

  std::size_t total_, count_ = 0;
  std::string many_, done_;
  ShownProgress shown_;
  NextLine next_line_;
  Clock::time_point start_;
  ProgressBar bar_;
};

}  // namespace fingerpad
