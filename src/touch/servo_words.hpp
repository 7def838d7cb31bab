#pragma once

#include <string>
#include <string_view>

#include "touch/tick_record.hpp"
#include "touch/time_histogram.hpp"

namespace fingerpad {

/// What a live touch felt, over all of its ticks. Noted on the servo's thread, read when that has ended.
struct FeltSum {
  long ticks = 0, touching = 0, unsettled = 0;
  // Each the greatest of its own [N].
  double force_n = 0, normal_force_n = 0, friction_n = 0;
  bool several_walls = false;  ///< held the finger at some tick

  /// noexcept, allocates nothing.
  void note(const TickRecord& tick) noexcept;
};

/// What --realtime came to.
enum class RealTime { not_asked, granted, refused };

/// What was felt and how the ticks kept their time, in lines.
std::string touch_end_words(const FeltSum& felt, const ServoTiming& timing, double rate_hz);

/// That so many ticks of a replay were unsettled; empty where none was.
/// @param where  " in job 3"; empty where there is but one run
/// @param told   " (unsettled_ticks in summary.csv)": where each run's are written; empty where nowhere
std::string unsettled_words(double ticks, std::string_view where, std::string_view told);
/// The same of a touch that has just ended: what a hand may do about it.
std::string live_unsettled_words(double ticks);

/// Where over a hundredth of the ticks began late: whether the ticks themselves or the machine is too slow,
/// and what would mend it. Else empty.
///
/// Rule: the ticks are too slow where a tenth of them takes longer than a tick has. A rate would mend it, of
/// those that `rate_hz = "auto"` chooses from, at which nine tenths of them take half of a tick at most; of a
/// machine that is late, at which 99 % of the ticks would not have been.
std::string late_advice(const ServoTiming& timing, double rate_hz, RealTime real_time);

}  // namespace fingerpad
