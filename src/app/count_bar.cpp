#include "app/count_bar.hpp"

#include <fmt/format.h>

#include <utility>

#include "app/pace_words.hpp"
#include "app/standard_streams.hpp"

namespace fingerpad {

CountBar::CountBar(std::size_t total, std::string many, std::string done, ShownProgress shown,
                   std::chrono::milliseconds between_lines, std::chrono::milliseconds patience)
    : total_(total),
      many_(std::move(many)),
      done_(std::move(done)),
      shown_(shown),
      next_line_(between_lines),
      start_(Clock::now()),
      bar_(shown == ShownProgress::bar, patience, ProgressBar::End::wiped) {}

void CountBar::advance() {
  ++count_;
  const bool is_due = shown_ == ShownProgress::lines && next_line_.is_due();
  if (shown_ != ShownProgress::bar && !is_due) return;
  const auto count = static_cast<double>(count_), total = static_cast<double>(total_);
  const std::string pace =
      pace_words(count, total, std::chrono::duration<double>(Clock::now() - start_).count(), many_);
  if (shown_ == ShownProgress::bar) {
    bar_.show(count / total, fmt::format("{}/{}{}", count_, total_, pace));
    return;
  }
  print_err("fingerpad: {} of {} {} {}, {:.0f}%{}\n", count_, total_, many_, done_, 100 * count / total,
            pace);
}

}  // namespace fingerpad
