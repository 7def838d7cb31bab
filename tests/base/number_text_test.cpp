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

TEST(RoundedText, IsWrittenOutForAPerson) {
  EXPECT_EQ(rounded_text(148, 2), "150");
  EXPECT_EQ(rounded_text(1234567, 3), "1230000");
  EXPECT_EQ(rounded_text(-56712.5, 3), "-56700");
  EXPECT_EQ(rounded_text(100, 2), "100");
  EXPECT_EQ(rounded_text(99.96, 3), "100");
  EXPECT_EQ(rounded_text(999.7, 3), "1000");
  EXPECT_EQ(rounded_text(0.012345, 3), "0.0123");
  EXPECT_EQ(rounded_text(0, 3), "0");
  EXPECT_EQ(rounded_text(2e-7, 3), "2e-07") << "nobody counts zeros";
  EXPECT_EQ(rounded_text(3.2e12, 3), "3.2e+12");
  EXPECT_EQ(rounded_text(-std::numeric_limits<double>::quiet_NaN(), 3), "nan");
  EXPECT_EQ(rounded_text(std::numeric_limits<double>::infinity(), 3), "inf");
}

TEST(NumberText, ForPeopleHasNoNegativeZero) {
  EXPECT_EQ(rounded_text(-0.0, 3), "0");
  EXPECT_EQ(fixed_text(-0.0, 3), "0.000");
  EXPECT_EQ(fixed_text(-0.0004, 3), "0.000");
  EXPECT_EQ(fixed_text(-0.0006, 3), "-0.001");
  EXPECT_EQ(fixed_text(-0.4, 0), "0");
  EXPECT_EQ(fixed_text(-10, 1), "-10.0");
  EXPECT_EQ(fixed_text(-std::nan(""), 1), "nan");
  EXPECT_EQ(number_text(-0.0), "-0") << "files keep the double";
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
