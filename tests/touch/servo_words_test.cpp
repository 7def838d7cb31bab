#include "touch/servo_words.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fingerpad::servo_words_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// A loop whose ticks take so long, of which a share begins late by so much.
ServoTiming timing_of(double tick_s, double late_share, double late_s, double rate_hz) {
  constexpr long ticks = 10000;
  ServoTiming timing;
  timing.ticks = ticks;
  const auto late = std::lround(late_share * ticks);
  const auto count = [](TimeCounts& counts, double seconds, long times) {
    counts.counts[static_cast<std::size_t>(TimeCounts::bucket_of(seconds))] +=
        static_cast<std::uint64_t>(times);
  };
  count(timing.tick_times, tick_s, ticks);
  count(timing.latenesses, late_s, late);
  count(timing.latenesses, 1e-6, ticks - late);
  timing.late_ticks = late_s > 1 / rate_hz ? late : 0;
  timing.worst_late_s = late_s;
  timing.worst_tick_s = tick_s;
  return timing;
}

TEST(LateAdvice, IsSilentWhereHardlyATickIsLate) {
  EXPECT_EQ(late_advice(timing_of(5e-6, 0, 0, 1000), 1000, RealTime::not_asked), "");
  EXPECT_EQ(late_advice(timing_of(5e-6, 0.01, 0.004, 1000), 1000, RealTime::not_asked), "");
  EXPECT_EQ(late_advice(ServoTiming(), 1000, RealTime::not_asked), "");
}

TEST(LateAdvice, NamesALowerRateWhereTheTicksThemselvesTakeTooLong) {
  const std::string words = late_advice(timing_of(300e-6, 0.9, 0.5, 4000), 4000, RealTime::not_asked);
  EXPECT_THAT(words, AllOf(HasSubstr("90 % of the ticks were late because they take too long"),
                           HasSubstr("4000 Hz leaves 250 us"),
                           HasSubstr("--rate 1000 (rate_hz in the scene)"), Not(HasSubstr("--realtime"))));
  EXPECT_THAT(late_advice(timing_of(0.1, 0.9, 5, 1000), 1000, RealTime::granted),
              AllOf(HasSubstr("a coarser mesh or a cheaper contact.method"), Not(HasSubstr("--rate"))));
}

TEST(LateAdvice, NamesTheMachineWhereTheTicksAreShort) {
  const ServoTiming timing = timing_of(5e-6, 0.24, 700e-6, 4000);
  const std::string words = late_advice(timing, 4000, RealTime::not_asked);
  EXPECT_THAT(words, AllOf(HasSubstr("24 % of the ticks were late though they are short"),
                           HasSubstr("--realtime asks for a core of its own"), HasSubstr("--rate 1000 ")));
  EXPECT_THAT(late_advice(timing, 4000, RealTime::refused),
              AllOf(HasSubstr("what --realtime was refused, above"), Not(HasSubstr("--realtime asks"))));
  EXPECT_THAT(late_advice(timing, 4000, RealTime::granted),
              AllOf(Not(HasSubstr("--realtime")), HasSubstr("end what else runs there")));
  EXPECT_THAT(late_advice(timing_of(5e-6, 0.24, 2, 4000), 4000, RealTime::not_asked),
              Not(HasSubstr("--rate")))
      << "none of its rates has two seconds a tick";
}

TickRecord touching(const Vec3& force_W_n, double normal_force_n, const Vec3& friction_W_n) {
  TickRecord tick;
  tick.phase = Phase::slip;
  tick.force_W_n = force_W_n;
  tick.normal_force_n = normal_force_n;
  tick.friction_W_n = friction_W_n;
  return tick;
}

TEST(TouchEndWords, TellContactForceAndWhatLateMeans) {
  FeltSum felt;
  for (int k = 0; k < 3; ++k) felt.note(TickRecord());
  felt.note(touching(Vec3(3, 0, 4), 4, Vec3(3, 0, 0)));
  const std::string words = touch_end_words(felt, timing_of(5e-6, 0.24, 900e-6, 4000), 4000);
  EXPECT_THAT(
      words,
      AllOf(HasSubstr("10000 ticks at 4000 Hz, 25 % of them in touch; greatest force 5 N, "
                      "greatest normal force 4 N, greatest friction 3 N\n"),
            HasSubstr("\n2400 ticks (24 %) began late, by more than a tick (250 us); the worst by 900 us\n"),
            HasSubstr("half of the ticks took up to 5.0 us")));
}

// The sum of what walls push with, each its own way, may be more than the force.
TEST(TouchEndWords, SayWhatTheNormalForceOfSeveralWallsIs) {
  FeltSum felt;
  TickRecord corner = touching(Vec3(3, 4, 0), 7, Vec3::Zero());
  corner.walls = 2;
  felt.note(corner);
  EXPECT_THAT(
      touch_end_words(felt, timing_of(5e-6, 0, 20e-6, 1000), 1000),
      HasSubstr("greatest force 5 N, greatest normal force 7 N (where several walls held the finger, all of "
                "theirs added up), greatest friction 0 N"));
}

TEST(TouchEndWords, OfATouchOfNothing) {
  FeltSum felt;
  felt.note(TickRecord());
  EXPECT_THAT(touch_end_words(felt, timing_of(5e-6, 0, 20e-6, 1000), 1000),
              AllOf(HasSubstr("10000 ticks at 1000 Hz, none of them in touch\n"),
                    HasSubstr("\nno tick began late, by more than a tick (1 ms); the worst by 20 us\n")));
}

// As its trace does, replayed.
TEST(ServoWords, TellOfUnsettledTicks) {
  FeltSum felt;
  TickRecord tick;
  felt.note(tick);
  EXPECT_EQ(unsettled_words(static_cast<double>(felt.unsettled), "", ""), "");
  tick.unsettled = true;
  felt.note(tick);
  felt.note(tick);
  EXPECT_EQ(unsettled_words(static_cast<double>(felt.unsettled), "", "").find("2 unsettled ticks: the proxy"),
            0);
  EXPECT_EQ(unsettled_words(1, " in job 3", " (here)").find("1 unsettled tick in job 3: the proxy"), 0);
  EXPECT_THAT(unsettled_words(1, "", ""), HasSubstr("a higher motion.rate_hz may mend it"));
  EXPECT_EQ(live_unsettled_words(0), "");
  // Whoever holds a mouse has no rate to turn.
  EXPECT_THAT(live_unsettled_words(2), AllOf(HasSubstr("2 unsettled ticks: "), Not(HasSubstr("rate")),
                                             HasSubstr("a lighter press or a slower motion may mend it")));
}

}  // namespace
}  // namespace fingerpad::servo_words_test
