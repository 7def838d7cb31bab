#include "touch/record_ring.hpp"

#include <gtest/gtest.h>

namespace fingerpad::record_ring_test {
namespace {

TEST(RecordRing, KeepsTheLastOnesWholeAndForgetsTheRest) {
  RecordRing ring(8);
  TickRecord record;
  EXPECT_FALSE(ring.get(0, record));
  EXPECT_FALSE(ring.get(1, record));
  for (int k = 1; k <= 20; ++k) {
    TickRecord tick;
    tick.t_s = k;
    tick.unsettled = k % 2 == 0;  // its last field
    ring.put(tick);
  }
  EXPECT_EQ(ring.count(), 20u);
  for (std::uint64_t k = 1; k <= 12; ++k) EXPECT_FALSE(ring.get(k, record)) << k;
  for (std::uint64_t k = 13; k <= 20; ++k) {
    ASSERT_TRUE(ring.get(k, record)) << k;
    EXPECT_EQ(record.t_s, static_cast<double>(k));
    EXPECT_EQ(record.unsettled, k % 2 == 0);
    EXPECT_EQ(record.surface, -1);
  }
  EXPECT_FALSE(ring.get(21, record));
}

}  // namespace
}  // namespace fingerpad::record_ring_test
