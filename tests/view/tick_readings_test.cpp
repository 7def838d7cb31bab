#include "view/tick_readings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fingerpad::tick_readings_test {
namespace {

TEST(TimingReadings, AreWrittenOutHoweverLateTheTicksAre) {
  ServoTiming timing;
  timing.ticks = timing.late_ticks = 1000;
  timing.worst_late_s = 0.148;
  const auto readings = timing_readings(timing);
  EXPECT_THAT(readings, testing::Contains(Reading{"latest", "150 ms"}));
  EXPECT_THAT(readings, testing::Contains(Reading{"late ticks", "1000 (100 %)"}));
  timing.worst_late_s = 123;
  EXPECT_THAT(timing_readings(timing), testing::Contains(Reading{"latest", "120 s"}));
}

}  // namespace
}  // namespace fingerpad::tick_readings_test
