#include "device/latest.hpp"

#include <gtest/gtest.h>

#include <array>
#include <thread>

namespace fingerpad::latest_test {
namespace {

TEST(Latest, GivesTheNewestOnce) {
  Latest<int> latest;
  int value = -1;
  EXPECT_FALSE(latest.take(value));
  latest.put(1);
  latest.put(2);
  EXPECT_TRUE(latest.take(value));
  EXPECT_EQ(value, 2);
  EXPECT_FALSE(latest.take(value));
  latest.put(3);
  EXPECT_TRUE(latest.take(value));
  EXPECT_EQ(value, 3);
}

TEST(Latest, NeverGivesAHalfWrittenOrAnOlderOne) {
  Latest<std::array<long, 16>> latest;
  constexpr long last = 3'000'000;
  std::thread writer([&] {
    for (long k = 1; k <= last; ++k) {
      std::array<long, 16> value;
      value.fill(k);
      latest.put(value);
    }
  });
  std::array<long, 16> value{};
  for (long seen = 0; seen < last;) {
    if (!latest.take(value)) {
      std::this_thread::yield();
      continue;
    }
    for (const long part : value) EXPECT_EQ(part, value[0]);
    EXPECT_GT(value[0], seen);
    seen = value[0];
  }
  writer.join();
}

}  // namespace
}  // namespace fingerpad::latest_test
