#include "replay/processor_time.hpp"

#include <gtest/gtest.h>

namespace fingerpad::processor_time_test {
namespace {

TEST(SharedSeconds, AreTheWorkOverTheProcessorsThatThreadsGet) {
  EXPECT_DOUBLE_EQ(shared_seconds(10, 1, 2, 2), 5);
  EXPECT_DOUBLE_EQ(shared_seconds(10, 1, 2, 0.5), 20) << "more threads get no more of a busy machine";
  EXPECT_DOUBLE_EQ(shared_seconds(10, 1, 1, 1), 10);
}

TEST(SharedSeconds, AreNoFewerThanTheLongestJobTakesOneThread) {
  EXPECT_DOUBLE_EQ(shared_seconds(10, 8, 4, 4), 8);
  EXPECT_DOUBLE_EQ(shared_seconds(10, 8, 4, 2), 16) << "half a processor each";
}

TEST(ProcessorsFor, AreAtMostOneAThread) {
  for (const int threads : {1, 3}) {
    const double processors = processors_for(threads);
    EXPECT_GT(processors, 0);
    EXPECT_LE(processors, threads);
  }
}

TEST(ProcessorS, Grows) {
  const double before_s = processor_s();
  processors_for(1);
  EXPECT_GT(processor_s(), before_s);
}

}  // namespace
}  // namespace fingerpad::processor_time_test
