#include "study/static_friction.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "study/profile_text.hpp"
#include "support/effort.hpp"
#include "support/pad_measurement.hpp"

namespace fingerpad::static_friction_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// How one finger rubs to and fro.
struct Rubs {
  double times_mu = 1;  ///< of 0.4 in stick and 0.28 in slip
  int subject = 1;
  double load_n = 1, amplitude_m = 0.03;
  bool is_even = false;  ///< at one speed, above v_min: it is hardly seen to give way
};

/// Each thing rubbed across, along and between.
ProfileFit fit_of(const std::vector<Rubs>& fingers) {
  RecordedMeasurement all;
  int number = 0;
  for (const Rubs& own : fingers) {
    test::KnownFinger finger;
    finger.pad = assumed_profile(0.4 * own.times_mu, 200);
    finger.mu_dynamic = 0.28 * own.times_mu;
    std::vector<test::KnownTrial> trials;
    // The pad of the second of known_trials' subjects is the finger's own.
    for (const double bearing_deg : {0.0, 45.0, 90.0})
      trials.push_back({2, 45, bearing_deg, own.amplitude_m, 0.6, 4, own.load_n});
    for (test::KnownTrial& trial : trials) trial.is_even = own.is_even;
    RecordedMeasurement rubbed =
        test::known_measurement(trials, finger, {}, static_cast<std::uint64_t>(number + 1));
    for (RecordedTrial& trial : rubbed.trials) {
      trial.subject = own.subject;
      trial.number = ++number;
      all.trials.push_back(std::move(trial));
    }
  }
  return fit_profile(clean(std::move(all), {}), {});
}

double value(const ProfileFit& fit, PadNumber number) {
  return value_of(fit.values, number).value;
}

constexpr double true_rise = 0.4 / 0.28;

// Slip of the third is above the mean of what all ruptures come to: his ruptures count all the same.
TEST(StaticFriction, PeopleThatPassForOneAreCountedAndTold) {
  const ProfileFit fit = fit_of({{0.6}, {1}, {1.6, 1, 1, 0.06}});
  EXPECT_EQ(value_of(fit.values, PadNumber::mu_static).trials, 9);
  // Trials weigh by their ruptures in the one, by their slip in the other.
  constexpr double near = 0.04;
  EXPECT_NEAR(value(fit, PadNumber::mu_static) / value(fit, PadNumber::mu_dynamic), true_rise, near);
  EXPECT_THAT(fit_notes(fit), Contains(AllOf(HasSubstr("unlike one another: known, subject 1, trial"),
                                             HasSubstr("--columns subject=NAME"),
                                             HasSubstr("axes and stiffnesses may be farther off"))));
}

/// What a trial says that slips with so much of its load.
TrialEvidence slipping(double mu, double load_n) {
  constexpr long samples = 1000;
  TrialEvidence trial;
  trial.subject = 1;
  trial.slip_samples = samples;
  trial.slip_ratio = mu * samples;
  trial.slip_log_load = std::log(load_n) * samples;
  return trial;
}

TEST(StaticFriction, FrictionThatFallsWithTheTrialsLoadsIsTold) {
  const std::vector<std::string> names{"a", "b", "c", "d", "e", "f"};
  EXPECT_THAT(unlike_trials_words(names,
                                  {slipping(0.5, 0.5), slipping(0.3, 1), slipping(0.2, 2),
                                   slipping(0.49, 0.5), slipping(0.31, 1)},
                                  1.5),
              AllOf(HasSubstr("c slips with 0.2 of its load (2 N), a with 0.5 (0.5 N)"),
                    HasSubstr("it falls with the trials' loads")));
  // Two people, each with a load of his own; one trial of each of three loads; six of one.
  for (const std::vector<TrialEvidence>& trials :
       {std::vector{slipping(0.5, 1), slipping(0.3, 1.3), slipping(0.5, 1), slipping(0.3, 1.3),
                    slipping(0.51, 1), slipping(0.31, 1.3)},
        {slipping(0.5, 0.5), slipping(0.3, 1), slipping(0.2, 2)},
        {slipping(0.5, 1), slipping(0.3, 1), slipping(0.2, 1), slipping(0.5, 1), slipping(0.3, 1),
         slipping(0.2, 1)}})
    EXPECT_THAT(unlike_trials_words(names, trials, 1.5), HasSubstr("--columns subject=NAME"));
}

// Slippery trials alone are seen to rupture: what they stick by is less than what all slip by.
TEST(StaticFriction, IsToldByEachTrialsOwnSlipWhereThoseThatRuptureAreNotAsTheOthers) {
  if (test::sanitized()) GTEST_SKIP() << "a fit like the others, of other numbers";
  const ProfileFit fit = fit_of({{0.6}, {0.6}, {2, 1, 1, 0.09, true}});
  EXPECT_LT(value_of(fit.values, PadNumber::mu_static).trials, 9);
  constexpr double near = 0.03;
  EXPECT_NEAR(value(fit, PadNumber::mu_static) / value(fit, PadNumber::mu_dynamic), true_rise, near);
  EXPECT_THAT(fit_notes(fit), Contains(HasSubstr("told against each trial's own slip; without that")));
}

// Of the second subject no rupture is seen at all.
TEST(StaticFriction, BelowMuDynamicBothAreRefused) {
  const ProfileFit fit = fit_of({{0.6}, {2, 2, 1, 0.2, true}});
  for (const PadNumber number : {PadNumber::mu_static, PadNumber::mu_dynamic})
    EXPECT_THAT(value_of(fit.values, number).refusal,
                AllOf(HasSubstr("no pad slips with more than it sticks with"), HasSubstr("--leave-out")));
  EXPECT_THAT(profile_text(fit, ""), Not(HasSubstr("\nmu_dynamic = 0")));
}

TEST(StaticFriction, TrialsThatAreAlikeAreLeftAsTheyAre) {
  std::vector<TrialEvidence> alike{slipping(0.2, 1), slipping(0.22, 1)};
  for (TrialEvidence& trial : alike) trial.rupture_ratio = 3, trial.ruptures = 10;
  EXPECT_FALSE(is_friction_unlike(alike));
  EXPECT_EQ(unlike_trials_words({"a", "b"}, alike, 1.5), "");
  alike[1].ruptures = 0;
  alike[1].slip_ratio *= 2;
  EXPECT_TRUE(is_friction_unlike(alike));
}

}  // namespace
}  // namespace fingerpad::static_friction_test
