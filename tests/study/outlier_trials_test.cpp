#include "study/outlier_trials.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "base/random_stream.hpp"
#include "study/press_fit.hpp"
#include "support/effort.hpp"
#include "support/pad_measurement.hpp"

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

/// A trial of subject 1 that slips under a load with a coefficient.
TrialEvidence slipping(double load_n, double mu) {
  TrialEvidence trial;
  trial.slip_samples = 1000;
  trial.slip_ratio = 1000 * mu;
  trial.slip_log_load = 1000 * std::log(load_n);
  return trial;
}

std::vector<std::string> outliers_of(const std::vector<TrialEvidence>& evidence) {
  std::vector<std::string> trials, names;
  for (std::size_t i = 1; i <= evidence.size(); ++i) trials.push_back(fmt::format("trial {}", i));
  for (const OutlierTrial& outlier : outlier_trials(trials, evidence, std::nullopt))
    names.push_back(outlier.name);
  return names;
}

/// A number that goes with some power of the load makes no trial odd, and one that is off is named, with what
/// is usual under its own load.
TEST(OutlierTrials, AreNamedAgainstTrialsOfTheirLoadWhateverTheLawOverTheLoad) {
  RandomStream random(2);
  for (const double exponent : {-1.0, -1.0 / 3, 0.0, 0.5}) {
    std::vector<TrialEvidence> evidence;
    for (const double load_n : {1.0, 1.0, 1.0, 1.0, 1.5, 1.5, 1.5, 3.0, 3.0, 3.0})
      evidence.push_back(slipping(load_n, std::pow(load_n, exponent) * (1 + 0.01 * random.normal())));
    EXPECT_THAT(outliers_of(evidence), IsEmpty()) << exponent;
    evidence[5].slip_ratio *= 1.4;
    EXPECT_THAT(outliers_of(evidence), ElementsAre("trial 6")) << exponent;
    const std::vector<OutlierTrial> found =
        outlier_trials(std::vector<std::string>(evidence.size()), evidence, std::nullopt);
    ASSERT_EQ(found.size(), 1U) << exponent;
    EXPECT_NEAR(found.front().usual, std::pow(1.5, exponent), 0.05) << exponent;
  }
}

/// The lightest and the heaviest would bend the law over the load that they are judged by, and loads that
/// hardly differ tell no law.
TEST(OutlierTrials, AreNamedAtTheEndsOfTheLoadsToo) {
  RandomStream random(3);
  const std::vector<double> three{0.5, 0.5, 0.5, 1, 1, 1, 2, 2, 2}, each{0.6, 0.8, 1, 1.3, 1.7, 2.2},
      alike{0.9, 0.95, 1, 1.05, 1.1};
  for (const std::vector<double>& loads_n : {three, each, alike}) {
    for (const double exponent : {-1.0 / 3, 0.0}) {
      constexpr int sets = 300;
      int good = 0, found = 0;
      for (int set = 0; set < sets; ++set) {
        std::vector<TrialEvidence> evidence;
        for (const double load_n : loads_n)
          evidence.push_back(
              slipping(load_n, 0.2 * std::pow(load_n, exponent) * (1 + 0.02 * random.normal())));
        good += outliers_of(evidence).empty() ? 0 : 1;
        const bool is_first = set % 2 == 0;
        (is_first ? evidence.front() : evidence.back()).slip_ratio *= 1.3;
        const std::string odd = is_first ? "trial 1" : fmt::format("trial {}", loads_n.size());
        found += outliers_of(evidence) == std::vector<std::string>{odd} ? 1 : 0;
      }
      EXPECT_LE(good, 0.01 * sets) << loads_n.size() << ' ' << exponent;
      // By five trials it is hardly told what is usual.
      EXPECT_GE(found, (loads_n.size() > 5 ? 0.8 : 0.5) * sets) << loads_n.size() << ' ' << exponent;
    }
  }
}

/// Two loads, and one trial of the second is odd: which of its two says how the number goes with the load,
/// nobody can tell.
TEST(OutlierTrials, NobodyTellsWhereTheLoadMayExplainIt) {
  EXPECT_THAT(outliers_of({slipping(1, 0.2), slipping(1, 0.2005), slipping(2, 0.3)}), IsEmpty());
  EXPECT_THAT(outliers_of({slipping(1, 0.2), slipping(1.01, 0.2005), slipping(1.02, 0.3)}),
              ElementsAre("trial 3"))
      << "loads that are alike explain nothing";
  EXPECT_THAT(outliers_of({slipping(1, 0.2), slipping(1, 0.201), slipping(1, 0.199), slipping(1, 0.2),
                           slipping(2, 0.2), slipping(2, 0.3)}),
              IsEmpty());
}

/// One whose force drives it on is in no spring.
TEST(OutlierTrials, SaysWhetherTheFitCountsThem) {
  std::vector<TrialEvidence> evidence(6);
  for (TrialEvidence& trial : evidence) {
    trial.has_direction = true;
    trial.stick_samples = 1000;
    SpringSums& sums = trial.spring[0];
    sums(spring_ratio, spring_ratio) = sums(spring_straight, spring_straight) = 1;
    sums(spring_position, spring_ratio) = sums(spring_position, spring_straight) = 1e-2;
  }
  SpringSums &mirrored = evidence[1].spring[0], &stiff = evidence[4].spring[0];
  mirrored(spring_position, spring_ratio) = mirrored(spring_position, spring_straight) = -1e-2;
  stiff(spring_position, spring_ratio) = stiff(spring_position, spring_straight) = 5e-3;
  const std::vector<OutlierTrial> found =
      outlier_trials(std::vector<std::string>(evidence.size()), evidence, std::nullopt);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].trial, 1U);
  EXPECT_FALSE(found[0].is_counted);
  EXPECT_EQ(found[1].trial, 4U);
  EXPECT_TRUE(found[1].is_counted);
}

/// Were springs for each newton taken to be alike under all loads, a third of good trials were named where
/// they are as stiff under any load.
TEST(OutlierTrials, GoodTrialsOfAPadThatIsAsStiffUnderAnyLoadAreNone) {
  test::KnownFinger finger;
  finger.stiffness_exponent = -1;
  const auto trials = test::fewer_trials();
  RecordedMeasurement recorded = test::known_measurement(trials, finger, test::bad_sensors(), 3);
  const auto named = [](RecordedMeasurement of) {
    std::vector<std::string> names;
    for (const OutlierTrial& one : fit_profile(clean(std::move(of), {}), {}).outliers)
      names.push_back(one.name);
    return names;
  };
  EXPECT_THAT(named(recorded), IsEmpty());
  if (test::sanitized()) return;  // it goes the same way again
  test::KnownFinger stiff = finger;
  stiff.pad.lateral_axis_m /= 1.3;
  stiff.pad.longitudinal_axis_m /= 1.3;
  recorded.trials[15] =
      test::known_measurement(test::fewer_trials(), stiff, test::bad_sensors(), 4).trials[15];
  const std::vector<std::string> odd = named(std::move(recorded));
  EXPECT_THAT(odd, testing::Not(IsEmpty()));
  EXPECT_THAT(odd, testing::Each(testing::HasSubstr("trial 16")));
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
