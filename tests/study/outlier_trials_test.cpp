#include "study/outlier_trials.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <string>
#include <vector>

#include "base/random_stream.hpp"
#include "study/press_fit.hpp"

namespace fingerpad::outlier_trials_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Names of the outliers among trials of one subject that slip with these coefficients.
std::vector<std::string> outliers(const std::vector<double>& coefficients) {
  std::vector<std::string> trials;
  std::vector<TrialEvidence> evidence;
  for (const double mu : coefficients) {
    trials.push_back(fmt::format("trial {}", evidence.size() + 1));
    TrialEvidence own;
    own.slip_samples = 1000;
    own.slip_ratio = 1000 * mu;
    evidence.push_back(own);
  }
  std::vector<std::string> names;
  for (const OutlierTrial& outlier : outlier_trials(trials, evidence, std::nullopt))
    names.push_back(outlier.name);
  return names;
}

TEST(OutlierTrials, OfThreeOrFourAreTheOneThatIsFarOffTrialsThatAgree) {
  EXPECT_THAT(outliers({0.2, 0.2005, 0.3}), ElementsAre("trial 3"));
  EXPECT_THAT(outliers({0.1, 0.2, 0.2005}), ElementsAre("trial 1"));
  EXPECT_THAT(outliers({0.2, 0.202, 0.3}), IsEmpty()) << "those two differ too much to say so";
  EXPECT_THAT(outliers({0.2, 0.202, 0.3, 0.203}), ElementsAre("trial 3"));
  EXPECT_THAT(outliers({0.2, 0.202, 0.3, 0.21}), IsEmpty());
  // As the README says: 0.6 % of its distance, and of four 8 %.
  EXPECT_THAT(outliers({1, 1.0059, 2}), ElementsAre("trial 3"));
  EXPECT_THAT(outliers({1, 1.0061, 2}), IsEmpty());
  EXPECT_THAT(outliers({1, 1.03, 1.073, 2}), ElementsAre("trial 4"));
  EXPECT_THAT(outliers({1, 1.03, 1.075, 2}), IsEmpty());
  EXPECT_THAT(outliers({0.2, 0.3}), IsEmpty()) << "which of two is off, nobody can tell";
  EXPECT_THAT(outliers({0.2, 0.2, 0.21}), IsEmpty()) << "less than a tenth is not worth a word";
}

/// Each of two numbers' three (four) trials is hardly ever named where all are alike but for chance.
TEST(OutlierTrials, OfFewTrialsThatDifferByChanceAreHardlyEver) {
  RandomStream random(1);
  for (const int count : {3, 4}) {
    int named = 0;
    constexpr int sets = 2000;
    for (int set = 0; set < sets; ++set) {
      std::vector<double> trials;
      for (int i = 0; i < count; ++i) trials.push_back(1 + 0.1 * random.normal());
      named += outliers(trials).empty() ? 0 : 1;
    }
    EXPECT_LT(named, 0.02 * sets) << count;  // the test's level is one in a hundred; three deviations above
  }
}

/// Of a trial in which the hand moves, and the force says nothing of the height, nothing is judged.
TEST(OutlierTrials, APressThatExplainsNothingIsNoStiffness) {
  TrialEvidence trial;
  trial.press_groups = 100;
  trial.press_load_2 = 100;
  trial.press(0, 0) = 100 * 1e-6;
  trial.press(1, 1) = 100;
  const auto depth = [&](double depth_m) {
    trial.press(0, 1) = depth_m * trial.press(1, 1);
    return own_depth_at_1_n_m(trial);
  };
  ASSERT_TRUE(depth(9e-4).has_value());
  EXPECT_DOUBLE_EQ(*depth(9e-4), 9e-4);
  EXPECT_FALSE(depth(5e-4).has_value()) << "a quarter of the height";
  EXPECT_FALSE(depth(-9e-4).has_value());
}

}  // namespace
}  // namespace fingerpad::outlier_trials_test
