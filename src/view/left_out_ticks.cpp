#include "view/left_out_ticks.hpp"

#include <cmath>

namespace fingerpad {

std::uint64_t ticks_a_row(const Trace& trace) {
  const auto& rows = trace.rows;
  if (trace.info.every > 1 || !trace.info.scene_text.empty() || rows.size() < 3) return trace.info.every;
  constexpr double rounding = 1e-3;  // of a time that was written with few digits, in steps
  constexpr std::uint64_t most = 10'000;
  const double last_s = rows.back().t_s - rows[rows.size() - 2].t_s;
  const double step_s = (rows[rows.size() - 2].t_s - rows.front().t_s) / static_cast<double>(rows.size() - 2);
  if (!(step_s > 0) || !(last_s < (1 - rounding) * step_s)) return 1;
  // Both are whole numbers of ticks.
  for (std::uint64_t every = 2; every <= most; ++every) {
    const double ticks = last_s / step_s * static_cast<double>(every);
    if (ticks > 0.5 && std::abs(ticks - std::round(ticks)) < rounding) return every;
  }
  return 2;
}

}  // namespace fingerpad
