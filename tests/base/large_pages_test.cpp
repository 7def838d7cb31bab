#include "base/large_pages.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace fingerpad::large_pages_test {
namespace {

std::uint32_t number(std::size_t i) {
  return static_cast<std::uint32_t>(i * 2654435761U);
}

TEST(LargePages, MemoryKeepsWhatIsInItAndBesideIt) {
  std::vector<std::uint32_t> numbers(3'000'000);
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = number(i);
  keep_in_large_pages(numbers);
  keep_in_large_pages(numbers.data() + 12345, std::size_t{2500} << 10);
  keep_in_large_pages(numbers.data() + 7, 100);
  keep_in_large_pages(nullptr, 0);
  std::size_t changed = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) changed += numbers[i] == number(i) ? 0 : 1;
  EXPECT_EQ(changed, 0U);
}

TEST(LargePages, MemoryThatIsAskedForBeforeItIsWrittenTakesAllThatIsWritten) {
  std::vector<std::uint32_t> numbers;
  numbers.reserve(3'000'000);
  prefer_large_pages(numbers.data(), numbers.capacity() * sizeof(std::uint32_t));
  for (std::size_t i = 0; i < 3'000'000; ++i) numbers.push_back(number(i));
  keep_in_large_pages(numbers);
  std::size_t changed = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) changed += numbers[i] == number(i) ? 0 : 1;
  EXPECT_EQ(changed, 0U);
}

}  // namespace
}  // namespace fingerpad::large_pages_test
