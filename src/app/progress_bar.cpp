#include "app/progress_bar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

namespace fingerpad {

void ProgressBar::advance(const std::string& what) {
  ++done_;
  if (!shown_) return;
  constexpr std::size_t width = 40;
  const std::size_t filled = std::min(width, width * done_ / std::max<std::size_t>(total_, 1));
  fmt::print(stderr, "\r[{:=<{}}{: <{}}] {}/{} {:<24.24}", "", filled, "", width - filled, done_, total_,
             what);
  std::fflush(stderr);
}

void ProgressBar::finish() {
  if (shown_ && done_ > 0) fmt::print(stderr, "\n");
}

}  // namespace fingerpad
