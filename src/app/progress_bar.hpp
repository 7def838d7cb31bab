#pragma once

#include <chrono>
#include <condition_variable>
#include <csignal>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "part/load_progress.hpp"

namespace fingerpad {

/// Whether standard error is a terminal: else a bar would be noise in a log.
bool stderr_is_terminal() noexcept;

/// How a command shows how far it is.
enum class ShownProgress { nothing, bar, lines };

/// Nothing where that is asked for; else a bar on a terminal, and a line now and then elsewhere.
ShownProgress shown_progress(bool quiet) noexcept;

/// A bar of one line on standard error, drawn by a thread of its own ten times a second, so that whoever
/// works only says how far it is. Says nothing and starts no thread if not shown. Thread-safe.
///
///     [=======             ]  38% bracket.stl: making normals
class ProgressBar {
 public:
  /// What is left of the line at the end: its last state, or nothing (what was quick leaves no trace at all).
  /// One that would be wiped is ended plainly where Ctrl-C ends the program.
  enum class End { kept, wiped };

  /// @param patience  nothing is drawn for so long
  ProgressBar(bool shown, std::chrono::milliseconds patience, End end);
  /// finish()
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// How many columns its words have, by the terminal as it is now; further ones are not drawn.
  static int words_width() noexcept;

  /// What the bar shows from now on. @param share_done  0 .. 1
  void show(double share_done, std::string what);

  /// A line of its own, whole, above the bar.
  void tell(const std::string& line);

  /// Ends the line, and the thread. Must come before anything else is written to the terminal.
  void finish();

 private:
  struct State {
    double share_done = 0;
    std::string what;
  };
  void end_line_on_interrupt();
  void draw_now_and_then(std::chrono::milliseconds patience);
  void draw(const State& state);
  void wipe();

  End end_;
  std::mutex mutex_;
  std::condition_variable woken_;
  std::optional<State> state_;  ///< none before the first show()
  bool finished_ = false, is_drawn_ = false;
  int drawn_columns_ = 0;   ///< of the line, as it was last drawn
  bool ends_line_ = false;  ///< Ctrl-C ends the line, then the program
  struct sigaction before_ {};
  std::thread drawer_;
};

/// A bar for loads, which shows itself where they take longer than half a second and wipes itself away:
/// what a load function is given as its progress.
class LoadBar {
 public:
  explicit LoadBar(bool shown) : bar_(shown, std::chrono::milliseconds(500), ProgressBar::End::wiped) {}

  /// @param file  named before each stage; empty where the load names its files itself
  /// The bar must live for as long as this is called.
  LoadProgress progress(const std::string& file = {});
  void finish() { bar_.finish(); }

 private:
  ProgressBar bar_;
};

}  // namespace fingerpad
