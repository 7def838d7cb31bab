#include "study/pad_numbers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string_view>
#include <vector>

#include "study/next_point.hpp"

namespace fingerpad::pad_numbers_test {
namespace {

/// One a key: a key without its own here has "" and fails.
TEST(PadNumbers, HaveTheUnitThatTheirKeyEndsIn) {
  constexpr std::array<std::string_view, pad_number_keys.size()> units{
      "m", "m", "1/deg", "1/deg", "1", "1",   "1",  "1/m", "1/m", "1",
      "1", "1", "1",     "m",     "m", "m/s", "Hz", "Hz",  "N/m", "1"};
  for (std::size_t k = 0; k < units.size(); ++k)
    EXPECT_EQ(unit_of_key(pad_number_keys[k]), units[k]) << pad_number_keys[k];
}

/// A trial whose friction falls by an eighth above 0.1 m/s, which passes for stick that hides below.
TrialEvidence stepping_slip() {
  TrialEvidence trial;
  trial.subject = 1;
  for (double speed = 0.011; speed < 0.5; speed *= 1.01) {
    for (int i = 0; i < 5; ++i) {
      const double ratio = speed < 0.1 ? 0.23 : 0.2;
      trial.slip_by_speed.add(speed, ratio);
      trial.slip_ratio += ratio;
      ++trial.slip_samples;
    }
  }
  return trial;
}

/// Else the passes go to and fro: with the step no slip is left, without slip there is no step.
TEST(NextPoint, TakesNoStepAgainThatLeftNoSlip) {
  const std::vector<TrialEvidence> slipping{stepping_slip()};
  std::vector<TrialEvidence> without_slip{stepping_slip()};
  without_slip[0].slip_samples = 0;
  const FitPoint stepped = next_point(slipping, {});
  ASSERT_TRUE(stepped.v_min_by_step);
  EXPECT_TRUE(next_point(slipping, stepped).v_min_by_step) << "it left slip";
  const FitPoint doubted = next_point(without_slip, stepped);
  EXPECT_FALSE(doubted.v_min_by_step);
  const FitPoint again = next_point(slipping, doubted);
  EXPECT_FALSE(again.v_min_by_step);
  EXPECT_FALSE(again.slow_slip);
}

}  // namespace
}  // namespace fingerpad::pad_numbers_test
