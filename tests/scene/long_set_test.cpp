// Sets of more values than any run has: what reads them must not take a time that grows with the square of
// their number. A watchdog ends these tests where it does: they would take an hour.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene_text.hpp"

namespace fingerpad::long_set_test {
namespace {

using test::plane_scene;
using test::refusal;
using testing::HasSubstr;

TEST(LongSet, AMillionValuesOnOneLineAreRefused) {
  std::string text = plane_scene + "[[set]]\nseed = [1";
  for (int i = 1; i < 1000000; ++i) text += ",1";
  EXPECT_THAT(refusal(text + "]\n"), HasSubstr("the set has over 100000 jobs"));
}

TEST(LongSet, AMillionValuesOnOneLineBehindALetterOfTwoBytesAreRefused) {
  std::string text = plane_scene + "[[set]]\nfriction.law = [\"\u00e9\"";
  for (int i = 1; i < 1000000; ++i) text += ",1";
  EXPECT_THAT(refusal(text + "]\n"), HasSubstr("the set has over 100000 jobs"));
}

TEST(LongSet, NumbersAreQuotedAsWrittenBehindLettersOfSeveralBytes) {
  const SceneFile file =
      read_scene_text(plane_scene +
                          "[[set]]\n\"plane\".\"mu_static\" = [ 0.30, 3e-1 , 0x1 , 0.4 ] # \u00e9\n"
                          "[[set]]\n\"plane\".\"mu_static\" = [ 0.50, 6e-1 ]\n",
                      "s.toml");
  std::vector<std::string> written;
  for (const SceneJob& job : file.jobs) written.push_back(job.set_keys.front().second);
  EXPECT_THAT(written, testing::ElementsAre("0.30", "3e-1", "0x1", "0.4", "0.50", "6e-1"));
}

}  // namespace
}  // namespace fingerpad::long_set_test
