#include "view/recent_ticks.hpp"

#include <algorithm>

#include "view/touch_chart.hpp"

namespace fingerpad {

void RecentTicks::gather(const TouchWindowInput& input) {
  const TickRecord newest = input.latest();
  const double last_s = rows_.empty() ? newest.t_s - kept_s_ : rows_.back().t_s;
  if (!rows_.empty() && !(newest.t_s > last_s)) return;
  for (const TickRecord& row : input.recent(newest.t_s - last_s + 0.05)) {
    if (rows_.empty() || row.t_s > rows_.back().t_s) rows_.push_back(row);
  }
  const auto keep = std::find_if(rows_.begin(), rows_.end(),
                                 [&](const TickRecord& row) { return row.t_s >= newest.t_s - kept_s_; });
  rows_.erase(rows_.begin(), keep);
}

double RecentTicks::speed_m_per_s() const {
  if (rows_.empty()) return TickRecord::nan;
  const TickRecord& last = rows_.back();
  auto first = rows_.rbegin();
  while (first + 1 != rows_.rend() && (first + 1)->t_s >= last.t_s - 0.02) ++first;
  return shown_speed(*first, last);
}

}  // namespace fingerpad
