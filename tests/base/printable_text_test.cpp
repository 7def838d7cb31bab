#include "base/printable_text.hpp"

#include <gtest/gtest.h>

namespace fingerpad::printable_text_test {
namespace {

TEST(MiddleLeftOut, KeepsBothEndsOfALongTextAndAShortOneWhole) {
  EXPECT_EQ(middle_left_out("plate-0003 45%", 14), "plate-0003 45%");
  EXPECT_EQ(middle_left_out("plate-0003 45%", 13), "plate...3 45%");
  EXPECT_EQ(middle_left_out("", 8), "");
}

TEST(MiddleLeftOut, CountsCharactersNotBytes) {
  EXPECT_EQ(middle_left_out("\u00e4\u00f6\u00fc\u00e4\u00f6\u00fc\u00e4\u00f6", 8),
            "\u00e4\u00f6\u00fc\u00e4\u00f6\u00fc\u00e4\u00f6");
  EXPECT_EQ(middle_left_out("\u00e4\u00f6\u00fc\u00e4\u00f6\u00fc\u00e4\u00f6\u00df", 8),
            "\u00e4\u00f6\u00fc...\u00f6\u00df");
}

}  // namespace
}  // namespace fingerpad::printable_text_test
