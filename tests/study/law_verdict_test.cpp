#include "study/law_verdict.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/random_stream.hpp"
#include "study/profile_text.hpp"
#include "support/effort.hpp"
#include "support/pad_measurement.hpp"

namespace fingerpad::law_verdict_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

/// A trial of which the law leaves a share in stick.
TrialResidual leaving(double share) {
  TrialResidual trial;
  trial.stick = {share * share, 0.02 * 0.02, 1, 1000};
  trial.sure_stick = trial.stick;
  trial.gives = trial.drops = 3;
  return trial;
}

const std::vector<std::string> names{"a", "b", "c", "d", "e"};

TEST(LawVerdict, RestsOnMostTrials) {
  const std::vector<TrialResidual> one_bad(5, leaving(0.02));
  std::vector<TrialResidual> trials = one_bad;
  trials[3] = leaving(0.4);
  const LawResidual found = law_verdict(trials, names, {});
  EXPECT_GT(found.share, 0.15);
  EXPECT_EQ(found.misfit, "");
  EXPECT_THAT(found.odd_trials, ElementsAre(HasSubstr("d: it leaves 40.0 %")));
  trials[0] = trials[1] = leaving(0.1);
  EXPECT_THAT(law_verdict(trials, names, {}).misfit, HasSubstr("it leaves"));
  EXPECT_TRUE(law_verdict(trials, names, {}).odd_trials.empty());
}

TEST(LawVerdict, NamesAnOddTrialThoughAllTogetherFit) {
  std::vector<TrialResidual> trials(50, leaving(0.02));
  std::vector<std::string> of_fifty(50, "fits");
  trials[7] = leaving(0.3);
  of_fifty[7] = "odd";
  const LawResidual found = law_verdict(trials, of_fifty, {});
  EXPECT_LT(found.share, 0.06);
  EXPECT_EQ(found.misfit, "");
  EXPECT_THAT(found.odd_trials, ElementsAre(HasSubstr("odd: it leaves 30.0 %")));
}

TEST(LawVerdict, OfManyTrialsSomeAreFarByChance) {
  // About 0.048, a hundredth either way; and one that is beyond chance.
  RandomStream random(1);
  std::vector<TrialResidual> trials;
  for (int k = 0; k < 200; ++k) trials.push_back(leaving(std::hypot(0.048 + 0.01 * random.normal(), 0.02)));
  const auto beyond = std::count_if(trials.begin(), trials.end(), [](const TrialResidual& trial) {
    return trial.stick.left - trial.stick.expected > 0.06 * 0.06;
  });
  EXPECT_GT(beyond, 10);
  std::vector<std::string> of_all(200, "fits");
  EXPECT_THAT(law_verdict(trials, of_all, {}).odd_trials, testing::IsEmpty());
  trials[7] = leaving(0.15);
  of_all[7] = "odd";
  EXPECT_THAT(law_verdict(trials, of_all, {}).odd_trials, ElementsAre(HasSubstr("odd: it leaves 15.0 %")));
}

TEST(LawVerdict, NoTrialIsOddWhereTheLawDoesNotFit) {
  std::vector<TrialResidual> trials(5, leaving(0.02));
  trials[3] = leaving(0.4);
  for (TrialResidual& trial : trials) trial.drops = 0;
  const LawResidual found = law_verdict(trials, names, {});
  EXPECT_THAT(found.misfit, HasSubstr("without a drop of the force"));
  EXPECT_TRUE(found.odd_trials.empty());
}

TEST(LawVerdict, WithoutSlipIsUntoldThoughNothingIsLongEnough) {
  HiddenStick hidden;
  hidden.no_slip = "no slip";
  EXPECT_EQ(law_verdict({}, {}, hidden).untold, "no slip");
}

TEST(LawVerdict, WithoutSlipRestsOnStick) {
  HiddenStick hidden;
  hidden.no_slip = "no slip";
  hidden.unseen_drop = 0.1;
  const std::vector<TrialResidual> fitting(5, leaving(0.02));
  EXPECT_EQ(law_verdict(fitting, names, hidden).untold, "no slip");
  // Stick that surely does not give way leaves more than noise; of all of it more than unseen teeth drop.
  std::vector<TrialResidual> bent = fitting, far = fitting, near = fitting;
  for (TrialResidual& trial : bent) trial.sure_stick.left = 0.1 * 0.1;
  for (TrialResidual& trial : far) trial.stick.left = 0.2 * 0.2;
  for (TrialResidual& trial : near) trial.stick.left = 0.14 * 0.14;
  for (const auto* trials : {&bent, &far}) {
    EXPECT_THAT(law_verdict(*trials, names, hidden).misfit, HasSubstr("of the friction in stick (RMS)"));
    EXPECT_EQ(law_verdict(*trials, names, hidden).untold, "");
  }
  EXPECT_EQ(law_verdict(near, names, hidden).misfit, "");
}

TEST(LawVerdict, WhereStickPassesForSlipMuchIsDoubtedAndLittleIsNot) {
  HiddenStick hidden;
  hidden.is_likely = true;
  const std::vector<TrialResidual> near(5, leaving(0.14)), far(5, leaving(0.24));
  EXPECT_EQ(law_verdict(near, names, hidden).untold, "");
  EXPECT_THAT(law_verdict(far, names, hidden).untold, HasSubstr("it leaves 24.0 %"));
  EXPECT_EQ(law_verdict(far, names, hidden).misfit, "");
}

TEST(LawVerdict, WhereFrictionStepsSeveralTimesTheNoiseIsNotSaidToFit) {
  HiddenStick hidden;
  hidden.is_likely = hidden.is_stepped = true;
  const std::vector<TrialResidual> little(5, leaving(0.03)), much(5, leaving(0.07));
  EXPECT_EQ(law_verdict(little, names, hidden).untold, "");
  EXPECT_THAT(law_verdict(much, names, hidden).untold, HasSubstr("another law may be behind it"));
  std::vector<TrialResidual> undropped = little;
  for (TrialResidual& trial : undropped) trial.drops = 0;
  EXPECT_THAT(law_verdict(undropped, names, hidden).untold, HasSubstr("at 0 of its 15 ends"));
}

TEST(LawVerdict, MuchThatFewTrialsLeaveIsNotSaidToFitWhereNoneIsOdd) {
  HiddenStick hidden;
  hidden.is_likely = true;  // so that trials are not told to be odd
  std::vector<TrialResidual> trials(5, leaving(0.02));
  trials[1] = trials[3] = leaving(0.4);
  EXPECT_THAT(law_verdict(trials, names, hidden).untold, HasSubstr("than of others"));
}

// Its friction rises as the finger slows, which was taken for stick that hides in slip.
TEST(LawVerdict, AnotherLawWhoseFrictionStepsIsNotSaidToFit) {
  test::KnownFinger finger;
  finger.law = "lugre";
  test::KnownSensors sensors;
  sensors.air_s = 0.3;
  std::vector<test::KnownTrial> rubs;
  for (int k = 0; k < 4; ++k) rubs.push_back({2, 45, k % 3 * 45.0, 0.05, 0.5, 3, 1 + 0.2 * k});
  for (const std::uint64_t seed : test::cases<std::uint64_t>({1, 2, 4})) {
    const LawResidual found =
        fit_profile(clean(test::known_measurement(rubs, finger, sensors, seed), {}), {}).residual;
    EXPECT_FALSE(found.misfit.empty() && found.untold.empty()) << seed;
  }
}

TEST(LawVerdict, NamesTheOneTrialThatDoesNotFit) {
  std::vector<test::KnownTrial> rubs;
  for (int k = 0; k < 8; ++k) rubs.push_back({2, 45, k % 3 * 45.0});
  RecordedMeasurement recorded = test::known_measurement(rubs, {}, {}, 3);
  // Its sensor shook.
  RecordedTrial& odd = recorded.trials[5];
  for (Eigen::Index i = 0; i < odd.samples(); ++i)
    odd.force_W(0, i) += 0.5 * std::sin(44 * static_cast<double>(i) / odd.rate_hz);
  const ProfileFit fit = fit_profile(clean(recorded, {}), {});
  EXPECT_EQ(fit.residual.misfit, "");
  EXPECT_THAT(fit_notes(fit),
              Contains(testing::AllOf(HasSubstr("the pad's law fits most trials, but not known"),
                                      HasSubstr("trial 6: it leaves"))));
}

}  // namespace
}  // namespace fingerpad::law_verdict_test
