#include "app/progress_bar.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "app/standard_streams.hpp"

namespace fingerpad {
namespace {

// Beside the words of the line: "\r[====    ]  40% ", and a column that stays free.
constexpr int bar_width = 20, beside_words = bar_width + 9;

/// Of SIGINT, once: what the line said last stays, and the prompt stands below it.
void end_line_and_program(int signal) {
  constexpr char words[] = "\nfingerpad: stopped by Ctrl-C\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, words, sizeof(words) - 1);
  raise(signal);  // whose own way is back (SA_RESETHAND)
}

}  // namespace

bool stderr_is_terminal() noexcept {
  return isatty(STDERR_FILENO) != 0;
}

int ProgressBar::words_width() noexcept {
  constexpr int usual_columns = 80, least_width = 16, most_width = 200;
  winsize size{};
  const bool is_known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return std::clamp((is_known ? size.ws_col : usual_columns) - beside_words, least_width, most_width);
}

ShownProgress shown_progress(bool quiet) noexcept {
  if (quiet) return ShownProgress::nothing;
  return stderr_is_terminal() ? ShownProgress::bar : ShownProgress::lines;
}

ProgressBar::ProgressBar(bool shown, std::chrono::milliseconds patience, End end) : end_(end) {
  if (!shown) return;
  if (end == End::wiped) end_line_on_interrupt();
  drawer_ = std::thread([this, patience] { draw_now_and_then(patience); });
}

ProgressBar::~ProgressBar() {
  finish();
}

/// Unless somebody else waits for the signal.
void ProgressBar::end_line_on_interrupt() {
  sigaction(SIGINT, nullptr, &before_);
  if (before_.sa_handler != SIG_DFL) return;
  struct sigaction action {};
  action.sa_handler = end_line_and_program;
  action.sa_flags = SA_RESETHAND;
  sigemptyset(&action.sa_mask);
  ends_line_ = sigaction(SIGINT, &action, nullptr) == 0;
}

void ProgressBar::show(double share_done, std::string what) {
  const std::lock_guard lock(mutex_);
  state_ = {std::clamp(share_done, 0.0, 1.0), std::move(what)};
}

void ProgressBar::tell(const std::string& line) {
  const std::lock_guard lock(mutex_);
  wipe();
  print_err("{}\n", line);
  if (state_) draw(*state_);
}

void ProgressBar::finish() {
  if (!drawer_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    finished_ = true;
  }
  woken_.notify_all();
  drawer_.join();
  if (std::exchange(ends_line_, false)) sigaction(SIGINT, &before_, nullptr);
  if (end_ == End::kept && state_) {
    draw(*state_);
    print_err("\n");
  } else {
    wipe();
  }
  std::fflush(stderr);
}

void ProgressBar::wipe() {
  if (is_drawn_) print_err("\r{:{}}\r", "", drawn_columns_);
}

void ProgressBar::draw_now_and_then(std::chrono::milliseconds patience) {
  constexpr std::chrono::milliseconds between{100};
  std::unique_lock lock(mutex_);
  woken_.wait_for(lock, patience, [this] { return finished_; });
  while (!finished_) {
    if (state_) draw(*state_);
    woken_.wait_for(lock, between, [this] { return finished_; });
  }
}

void ProgressBar::draw(const State& state) {
  const int filled = static_cast<int>(std::floor(bar_width * state.share_done));
  const int width = words_width();
  print_err("\r[{:=<{}}{: <{}}] {:3.0f}% {:<{}.{}}", "", filled, "", bar_width - filled,
            std::floor(100 * state.share_done), state.what, width, width);
  drawn_columns_ = width + beside_words - 1;
  std::fflush(stderr);
  is_drawn_ = true;
}

LoadProgress LoadBar::progress(const std::string& file) {
  const std::string name = std::filesystem::path(file).filename().string();
  return [this, lead = name.empty() ? name : name + ": "](std::string_view stage, double share_done) {
    bar_.show(share_done, lead + std::string(stage));
  };
}

}  // namespace fingerpad
