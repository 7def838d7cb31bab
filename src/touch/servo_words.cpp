#include "touch/servo_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/number_text.hpp"
#include "touch/rate_choice.hpp"

namespace fingerpad {
namespace {

/// "37 %", "0.12 %"; of some, however few, never 0.
std::string share_words(double share) {
  if (share > 0 && share < 1e-4) return "under 0.01 %";
  return fmt::format("{} %", rounded_text(100 * share, 2));
}

/// "12 ms", "250 us".
std::string time_words(double seconds) {
  if (seconds < 1e-3) return fmt::format("{} us", rounded_text(1e6 * seconds, 2));
  return seconds < 1 ? fmt::format("{} ms", rounded_text(1e3 * seconds, 2))
                     : fmt::format("{} s", rounded_text(seconds, 2));
}

std::string felt_words(const FeltSum& felt) {
  if (felt.touching == 0) return "none of them in touch";
  const double share = static_cast<double>(felt.touching) / static_cast<double>(felt.ticks);
  return fmt::format(
      "{} of them in touch; greatest force {} N, greatest normal force {} N{}, greatest friction {} N",
      share_words(share), rounded_text(felt.force_n, 3), rounded_text(felt.normal_force_n, 3),
      felt.several_walls ? " (where several walls held the finger, all of theirs added up)" : "",
      rounded_text(felt.friction_n, 3));
}

/// "--rate 1000 (rate_hz in the scene)": the highest rate below a given one that a tick of so long suits;
/// empty where none does.
std::string lower_rate_words(double rate_hz, double least_tick_s) {
  const auto suits = [&](double lower_hz) { return lower_hz < rate_hz && lower_hz * least_tick_s <= 1; };
  const auto found = std::find_if(std::rbegin(automatic_rates_hz), std::rend(automatic_rates_hz), suits);
  if (found == std::rend(automatic_rates_hz)) return "";
  return fmt::format("--rate {} (rate_hz in the scene)", number_text(*found));
}

/// @param mend  what may mend it
std::string lagging_words(double ticks, std::string_view where, std::string_view told,
                          std::string_view mend) {
  if (!(ticks > 0)) return {};
  return fmt::format(
      "{} unsettled {}{}: the proxy lags behind there, since a tick's work is bounded, and the force is not "
      "to be trusted{}; {} may mend it",
      ticks, ticks == 1 ? "tick" : "ticks", where, told, mend);
}

}  // namespace

void FeltSum::note(const TickRecord& tick) noexcept {
  ++ticks;
  unsettled += tick.unsettled ? 1 : 0;
  if (tick.phase == Phase::free) return;
  ++touching;
  several_walls |= tick.walls > 1;
  force_n = std::max(force_n, tick.force_W_n.norm());
  normal_force_n = std::max(normal_force_n, tick.normal_force_n);
  friction_n = std::max(friction_n, tick.friction_W_n.norm());
}

std::string touch_end_words(const FeltSum& felt, const ServoTiming& timing, double rate_hz) {
  const long count = timing.late_ticks;
  const std::string who = count == 0 ? "no tick"
                                     : fmt::format("{} {} ({})", count, count == 1 ? "tick" : "ticks",
                                                   share_words(timing.late_share()));
  const std::string late = fmt::format("{} began late, by more than a tick ({}); the worst by {}", who,
                                       time_words(1 / rate_hz), time_words(timing.worst_late_s));
  return fmt::format(
      "{} ticks at {} Hz, {}\n{}\nhalf of the ticks took up to {:.1f} us, 99.9 % up to {:.0f} us, the "
      "longest "
      "{:.0f} us\n",
      timing.ticks, number_text(rate_hz), felt_words(felt), late, 1e6 * timing.tick_s(0.5),
      1e6 * timing.tick_s(0.999), 1e6 * timing.worst_tick_s);
}

std::string unsettled_words(double ticks, std::string_view where, std::string_view told) {
  return lagging_words(ticks, where, told, "a smaller depth, a slower motion or a higher motion.rate_hz");
}

std::string live_unsettled_words(double ticks) {
  return lagging_words(ticks, "", "", "a lighter press or a slower motion");
}

std::string late_advice(const ServoTiming& timing, double rate_hz, RealTime real_time) {
  constexpr double notable_share = 0.01, most_ticks = 0.9, in_time = 0.99;
  if (!(timing.late_share() > notable_share)) return {};
  const double period_s = 1 / rate_hz, tick_s = timing.tick_s(most_ticks);
  if (tick_s > period_s) {
    const std::string lower = lower_rate_words(rate_hz, 2 * tick_s);
    return fmt::format(
        "{} of the ticks were late because they take too long: a tenth of them over {}, where {} Hz leaves "
        "{}; {}",
        share_words(timing.late_share()), time_words(tick_s), number_text(rate_hz), time_words(period_s),
        lower.empty() ? "a coarser mesh or a cheaper contact.method is needed" : lower + " gives them time");
  }
  const std::string lower = lower_rate_words(rate_hz, timing.latenesses.quantile_s(in_time));
  const std::string also = lower.empty() ? "" : fmt::format("; {} leaves it more time", lower);
  const char* const what =
      real_time == RealTime::not_asked ? "--realtime asks for a core of its own and for precedence"
      : real_time == RealTime::granted ? "end what else runs there, or use a machine that is not shared"
                                       : "what --realtime was refused, above, would help";
  return fmt::format(
      "{} of the ticks were late though they are short, nine tenths up to {} of {}: the machine gave the "
      "thread "
      "its turn too late; {}{}",
      share_words(timing.late_share()), time_words(tick_s), time_words(period_s), what, also);
}

}  // namespace fingerpad
