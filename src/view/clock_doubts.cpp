#include "view/clock_doubts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/number_text.hpp"
#include "base/unit.hpp"

namespace fingerpad {
namespace {

/// Of two spans, how many times as long the longer one is.
double times_as_long(double a_s, double b_s) {
  return std::max(a_s, b_s) / std::min(a_s, b_s);
}

/// "plot.csv: its rows are 1 s apart ...", or nothing.
std::string doubt_of(const ComparedRun& table, const ComparedRun& longest) {
  constexpr std::size_t fewest_rows = 21;
  constexpr double slowest_recorder_hz = 10, least_likely_hz = 20, most_likely_hz = 20e3;
  constexpr double unlike = 20;  // as many times as long as the trace that it is laid over
  const double rate_hz = static_cast<double>(table.file_rows - 1) / table.lasts_s;
  if (table.file_rows < fewest_rows || !(rate_hz < slowest_recorder_hz)) return {};
  if (!(longest.lasts_s > 0) || table.lasts_s < unlike * longest.lasts_s) return {};
  for (const TimeUnit& unit : time_units) {
    const double likely_hz = rate_hz / unit.seconds;
    if (likely_hz < least_likely_hz || likely_hz > most_likely_hz) continue;
    if (times_as_long(table.lasts_s * unit.seconds, longest.lasts_s) > unlike) continue;
    return fmt::format(
        "{}: its rows are {} s apart, {} s in all, beside {} s of {}: t_s is in seconds; if it holds {}, "
        "divide it by {}",
        table.path, rounded_text(1 / rate_hz, 3), rounded_text(table.lasts_s, 4),
        rounded_text(longest.lasts_s, 4), longest.path, unit.name, rounded_text(1 / unit.seconds, 7));
  }
  return {};
}

}  // namespace

std::vector<std::string> clock_doubts(const std::vector<ComparedRun>& runs) {
  const ComparedRun* longest = nullptr;
  for (const ComparedRun& run : runs) {
    if (run.is_trace && (longest == nullptr || run.lasts_s > longest->lasts_s)) longest = &run;
  }
  std::vector<std::string> doubts;
  for (const ComparedRun& run : runs) {
    if (run.is_trace || longest == nullptr) continue;
    std::string words = doubt_of(run, *longest);
    if (!words.empty()) doubts.push_back(std::move(words));
  }
  return doubts;
}

}  // namespace fingerpad
