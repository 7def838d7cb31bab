#include "base/number_text.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "base/random_stream.hpp"

namespace fingerpad::number_text_test {
namespace {

TEST(NumberText, ReadsBackAsTheSameBits) {
  RandomStream random(11);
  for (int i = 0; i < 20000; ++i) {
    const double value = std::bit_cast<double>(random.bits());
    if (std::isnan(value)) continue;
    const auto back = parse_number(number_text(value));
    ASSERT_TRUE(back.has_value());
    ASSERT_EQ(std::bit_cast<std::uint64_t>(*back), std::bit_cast<std::uint64_t>(value)) << number_text(value);
  }
}

TEST(NumberText, IsTheShortestForm) {
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(1.0 / 3), "0.3333333333333333");
  EXPECT_EQ(number_text(1), "1");
}

TEST(NumberText, HasOneNanAndItIsNeverNegative) {
  EXPECT_EQ(number_text(std::nan("")), "nan");
  EXPECT_EQ(number_text(-std::nan("")), "nan");
  EXPECT_EQ(number_text(-std::numeric_limits<double>::infinity()), "-inf");
}

TEST(ParseNumber, TakesWholeWordsOnly) {
  EXPECT_EQ(parse_number(" 1.5\t").value(), 1.5);
  EXPECT_EQ(parse_number("+2e-3").value(), 2e-3);
  for (const char* word : {"", " ", "1,5", "1.5x", "zwei", "--1", "+-1", "1 2", "0x10"}) {
    EXPECT_FALSE(parse_number(word).has_value()) << word;
  }
}

}  // namespace
}  // namespace fingerpad::number_text_test
