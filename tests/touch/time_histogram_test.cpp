#include "touch/time_histogram.hpp"

#include <gtest/gtest.h>

namespace fingerpad::time_histogram_test {
namespace {

TEST(TimeHistogram, PutsATimeIntoTheBucketThatReachesToIt) {
  for (double seconds = 1e-7; seconds < 2; seconds *= 1.07) {
    const int bucket = TimeCounts::bucket_of(seconds);
    // The last takes all that is longer; the logarithm of a bucket's own end may round either way.
    if (bucket < TimeCounts::buckets - 1) {
      EXPECT_LE(seconds, TimeCounts::upper_s(bucket) * (1 + 1e-12));
    }
    if (bucket > 0) {
      EXPECT_GE(seconds * (1 + 1e-12), TimeCounts::upper_s(bucket - 1));
    }
  }
  EXPECT_EQ(TimeCounts::bucket_of(0), 0);
  EXPECT_EQ(TimeCounts::bucket_of(-1), 0);
  EXPECT_EQ(TimeCounts::bucket_of(1e9), TimeCounts::buckets - 1);
}

TEST(TimeHistogram, TellsASharesLongestTimeToWithinABucket) {
  TimeHistogram histogram;
  for (int i = 0; i < 990; ++i) histogram.note(3e-6);
  for (int i = 0; i < 10; ++i) histogram.note(1e-3);
  const TimeCounts counts = histogram.counts();
  EXPECT_EQ(counts.total(), 1000u);
  constexpr double bucket = 1.19;
  EXPECT_GE(counts.quantile_s(0.5), 3e-6);
  EXPECT_LE(counts.quantile_s(0.5), 3e-6 * bucket);
  EXPECT_GE(counts.quantile_s(0.999), 1e-3);
  EXPECT_LE(counts.quantile_s(0.999), 1e-3 * bucket);
  EXPECT_EQ(TimeCounts{}.quantile_s(0.5), 0);
}

TEST(ServoTiming, NoShareOfTheTicksTookLongerThanTheLongest) {
  ServoTiming timing;
  TimeHistogram times;
  for (int k = 0; k < 100; ++k) times.note(1e-5);
  timing.tick_times = times.counts();
  timing.worst_tick_s = 1e-5;
  EXPECT_EQ(timing.tick_s(0.999), 1e-5);
  timing.worst_tick_s = 1;
  EXPECT_EQ(timing.tick_s(0.5), timing.tick_times.quantile_s(0.5));
}

}  // namespace
}  // namespace fingerpad::time_histogram_test
