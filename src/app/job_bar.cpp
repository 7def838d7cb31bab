#include "app/job_bar.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/pace_words.hpp"
#include "app/standard_streams.hpp"
#include "base/printable_text.hpp"

namespace fingerpad {

JobBar::JobBar(std::size_t total, Shown shown, std::chrono::milliseconds between_lines)
    : total_(std::max<std::size_t>(total, 1)),
      shown_(shown),
      next_line_(between_lines),
      start_(Clock::now()),
      bar_(shown == Shown::bar, std::chrono::milliseconds(0), ProgressBar::End::kept) {}

void JobBar::advance(const BatchJob& job) {
  {
    const std::lock_guard lock(mutex_);
    ++done_;
    under_way_.erase(&job);
  }
  show(job.job.scene.name, "");
}

void JobBar::elsewhere(std::size_t count) {
  const std::lock_guard lock(mutex_);
  elsewhere_ = count;
}

void JobBar::load(std::string_view stage, double done) {
  show(stage, fmt::format(" {:.0f}%", 100 * done));
}

void JobBar::run(const BatchJob& job, double share_done) {
  {
    const std::lock_guard lock(mutex_);
    under_way_[&job] = share_done;
  }
  show(job.job.scene.name, fmt::format(" {:.0f}%", 100 * share_done));
}

void JobBar::show(std::string_view name, const std::string& behind_it) {
  if (shown_ == Shown::nothing) return;
  const std::lock_guard lock(mutex_);
  const std::size_t ended = done_ + elsewhere_;
  auto done = static_cast<double>(ended);
  for (const auto& [job, share] : under_way_) done += share;
  const double share = std::min(1.0, done / static_cast<double>(total_));
  const std::string pace = pace_words(done, static_cast<double>(total_),
                                      std::chrono::duration<double>(Clock::now() - start_).count(), "jobs");
  const bool is_stopping = is_told_to_stop_ && is_told_to_stop_();
  if (shown_ == Shown::bar) {
    const std::string lead = fmt::format("{}/{}{} ", ended, total_, pace);
    constexpr std::size_t least_of_name = 12;
    const auto width = static_cast<std::size_t>(ProgressBar::words_width());
    const std::size_t beside = lead.size() + behind_it.size();
    const std::size_t room = std::max(least_of_name, width - std::min(width, beside));
    if (is_stopping && !has_told_stop_ && !under_way_.empty()) tell_stop();
    bar_.show(share, is_stopping ? fmt::format("{}/{} {}", ended, total_, stop_words())
                                 : lead + middle_left_out(name, room) + behind_it);
  } else if (is_stopping && !has_told_stop_ && !under_way_.empty()) {
    has_told_stop_ = true;
    print_err("fingerpad: {} of {} jobs done, {} first\n", ended, total_, stop_words());
  } else if (next_line_.is_due()) {
    print_err("fingerpad: {} of {} jobs done, {:.0f}%{}\n", ended, total_, 100 * share, pace);
  }
}

/// Of a batch that is told to stop: what it has begun it ends. Short enough for the bar of a narrow terminal.
std::string JobBar::stop_words() const {
  if (under_way_.empty()) return "stopped";
  return fmt::format("stopping: {} under way {}", under_way_.size(), under_way_.size() == 1 ? "ends" : "end");
}

/// Above the bar, which has no room for it.
void JobBar::tell_stop() {
  has_told_stop_ = true;
  const bool may_type = by_ctrl_c_ && by_ctrl_c_();
  bar_.tell(
      fmt::format("fingerpad: {} first{}", stop_words(), may_type ? "; Ctrl-C again ends at once" : ""));
}

}  // namespace fingerpad
