#include "study/zero_doubt.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "study/profile_text.hpp"
#include "support/effort.hpp"
#include "support/pad_measurement.hpp"

namespace fingerpad::zero_doubt_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::vector<test::KnownTrial> rubs{{2, 45, 0}, {2, 45, 90}, {2, 45, 45}, {2, 45, 0}, {2, 45, 90}};

/// A fit to trials without a moment in the air, whose sensor is off.
ProfileFit fitted(const Vec3& offset_n, const CleaningSettings& settings = {},
                  const test::KnownFinger& finger = {}, const std::vector<test::KnownTrial>& trials = rubs) {
  RecordedMeasurement recorded = test::known_measurement(trials, finger, {}, 1);
  for (RecordedTrial& trial : recorded.trials) trial.force_W.colwise() += offset_n;
  return fit_profile(clean(recorded, settings), {});
}

const PadValue& of(const ProfileFit& fit, PadNumber number) {
  return fit.values[static_cast<std::size_t>(number)];
}

bool holds(const ProfileFit& fit, PadNumber number, double truth) {
  const auto& interval = fit.interval[static_cast<std::size_t>(number)];
  return interval && interval->first <= truth && truth <= interval->second;
}

constexpr PadNumber coefficients[] = {PadNumber::mu_static, PadNumber::mu_dynamic, PadNumber::stick_stiffness,
                                      PadNumber::longitudinal_stiffness};

TEST(ZeroDoubt, AnOffsetAlongTheNormalRefusesWhatItMoves) {
  // Friction of 0.2 is told as 0.31 and as 0.15.
  for (const double offset_n : test::cases({-0.35, 0.35})) {
    const ProfileFit fit = fitted({0, 0, offset_n});
    for (const PadNumber number : coefficients)
      EXPECT_THAT(of(fit, number).refusal,
                  AllOf(HasSubstr("no moment in the air tells the force's zero in 5 of 5 trials"),
                        HasSubstr("offset along the normal look alike"),
                        HasSubstr("record a second without contact"), HasSubstr("--no-tare")))
          << offset_n;
    EXPECT_EQ(of(fit, PadNumber::mu_load_exponent).reason, RefusalReason::unknown_zero);
    // Where a spring ends does not rest on it: what the pull is told too much, the ratio is too.
    EXPECT_TRUE(holds(fit, PadNumber::lateral_axis, 0.002)) << offset_n;
    EXPECT_THAT(missing_axes_words(fit), Not(HasSubstr("as mu_dynamic")));
    // Nor is where stick ends unknown.
    EXPECT_THAT(fit.doubts, Not(testing::Contains(HasSubstr("straight springs")))) << offset_n;
  }
}

/// What it adds to friction makes ruptures seem to need more, and axes longer.
TEST(ZeroDoubt, AxesAllowForAnOffsetAlongThePlateOrAreRefused) {
  const ProfileFit off = fitted({0.1, 0.1, 0}, {}, {}, test::every(5, test::known_trials()));
  EXPECT_GT(of(off, PadNumber::lateral_axis).value, 1.03 * 0.002);
  EXPECT_TRUE(holds(off, PadNumber::lateral_axis, 0.002));
  EXPECT_TRUE(holds(off, PadNumber::longitudinal_axis, 0.0016));
  const ProfileFit far_off = fitted({0.2, 0.2, 0});
  EXPECT_THAT(of(far_off, PadNumber::lateral_axis).refusal,
              AllOf(HasSubstr("the force is off by 0.28 N along the plate"), HasSubstr("--no-tare")));
}

/// Whatever is said of the normal.
TEST(ZeroDoubt, AxesThatAllowForAnOffsetAlongThePlateAreToldWithIt) {
  ProfileFit fit;
  for (PadValue& value : fit.values) value.refusal = "not here";
  fit.trials = fit.offset.untared = fit.offset.told = fit.offset.off = 4;
  fit.offset.typical_n = 0.08;
  fit.mu_load_n = 1;
  for (const auto& [number, value] : {std::pair(PadNumber::mu_static, 0.3),
                                      {PadNumber::mu_load_exponent, -0.05},
                                      {PadNumber::mu_dynamic, 0.2},
                                      {PadNumber::lateral_axis, 0.002}}) {
    const auto k = static_cast<std::size_t>(number);
    fit.values[k] = {value, 1000, 4, ""};
    fit.interval[k] = {value - 0.1 * std::abs(value), value + 0.1 * std::abs(value)};
  }
  doubt_zero(zero_doubt(fit, false), fit);
  EXPECT_THAT(fit.doubts,
              testing::ElementsAre(AllOf(HasSubstr("offset along the normal look alike"),
                                         HasSubstr("mu_dynamic"), Not(HasSubstr("lateral_axis_m"))),
                                   AllOf(HasSubstr("off by 0.08 N along the plate"),
                                         HasSubstr("lateral_axis_m"), Not(HasSubstr("normal")))));
}

TEST(ZeroDoubt, TheUsersWordThatItWasZeroedIsTaken) {
  test::KnownFinger rising;
  rising.rises_with_less_load = true;
  CleaningSettings zeroed;
  zeroed.takes_tare = false;
  const ProfileFit doubted = fitted({0, 0, 0}, {}, rising), known = fitted({0, 0, 0}, zeroed, rising);
  EXPECT_EQ(of(doubted, PadNumber::mu_dynamic).reason, RefusalReason::unknown_zero);
  for (const PadNumber number : coefficients) EXPECT_EQ(of(known, number).refusal, "");
  EXPECT_TRUE(holds(known, PadNumber::mu_load_exponent, -1.0 / 3));
}

TEST(ZeroDoubt, FrictionThatHardlyChangesWithTheLoadSpeaksForNoOffset) {
  const ProfileFit fit = fitted({0, 0, 0});
  CleaningSettings zeroed;
  zeroed.takes_tare = false;
  const ProfileFit known = fitted({0, 0, 0}, zeroed);
  const auto& own = fit.interval[static_cast<std::size_t>(PadNumber::mu_dynamic)];
  const auto& without = known.interval[static_cast<std::size_t>(PadNumber::mu_dynamic)];
  ASSERT_TRUE(own && without);
  EXPECT_LT(own->second - own->first, 0.02);
  EXPECT_GT(own->second - own->first, without->second - without->first);
  EXPECT_TRUE(holds(fit, PadNumber::mu_static, 0.3));
  EXPECT_TRUE(holds(fit, PadNumber::mu_dynamic, 0.2));
}

TEST(ZeroDoubt, ASmallOffsetIsInTheIntervals) {
  for (const double offset_n : test::cases({-0.05, 0.05})) {
    const ProfileFit fit = fitted({0, 0, offset_n});
    for (const auto& [number, truth] : {std::pair(PadNumber::mu_static, 0.3),
                                        {PadNumber::mu_dynamic, 0.2},
                                        {PadNumber::stick_stiffness, 150.0}})
      EXPECT_TRUE(!of(fit, number).refusal.empty() || holds(fit, number, truth))
          << offset_n << " " << pad_number_keys[static_cast<std::size_t>(number)];
  }
}

/// Where nothing tells how friction changes with the load.
ProfileFit untold(std::size_t told, double along_n) {
  ProfileFit fit;
  for (PadValue& value : fit.values) value.refusal = "not here";
  fit.trials = fit.offset.untared = 4;
  fit.offset.told = told;
  fit.offset.off = along_n > 0.01 ? told : 0;
  fit.offset.typical_n = along_n;
  fit.mu_load_n = 1;
  const auto k = static_cast<std::size_t>(PadNumber::mu_dynamic);
  fit.values[k] = {0.2, 1000, 4, ""};
  fit.interval[k] = {0.19, 0.21};
  doubt_zero(zero_doubt(fit, false), fit);
  return fit;
}

TEST(ZeroDoubt, UnderOneLoadTheNormalsZeroIsUnknownWhateverThePlateTells) {
  // Of one newton that is told 0.8 to 1.2 press: a channel of the sensor that is right says nothing of
  // another's zero.
  for (const std::size_t told : {std::size_t{4}, std::size_t{0}}) {
    const ProfileFit fit = untold(told, told > 0 ? 0.003 : 0);
    EXPECT_TRUE(holds(fit, PadNumber::mu_dynamic, 0.259)) << told;
    EXPECT_FALSE(holds(fit, PadNumber::mu_dynamic, 0.261)) << told;
    EXPECT_TRUE(holds(fit, PadNumber::mu_dynamic, 0.158)) << told;
    EXPECT_FALSE(holds(fit, PadNumber::mu_dynamic, 0.155)) << told;
    EXPECT_THAT(fit.doubts, testing::ElementsAre(
                                HasSubstr("force's zero: no moment in the air tells it in 4 of 4 trials")));
  }
  EXPECT_THAT(of(untold(4, 0.1), PadNumber::mu_dynamic).refusal, HasSubstr("off by 0.1 N along the plate"));
}

/// What n = (depth/1.5 mm)^2 comes to of loads that swing by 60 % about a usual one and are told 0.2 N too
/// large or too small.
TEST(ZeroDoubt, ANormalLawIsDoubtedAtTheLoadThatItWasToldAt) {
  constexpr double true_stiffness_n_per_m = 2 / 1.5e-3;
  struct Told {
    double usual_n, exponent, stiffness;  ///< the last over the true one
  };
  // By least squares of the depth on n^w.
  for (const Told& told :
       {Told{2.022, 2.275, 0.9071}, Told{1.571, 1.780, 1.0962}, Told{2.923, 2.176, 0.9224},
        Told{2.472, 1.848, 1.0817}, Told{1.571, 2.383, 0.8975}, Told{0.665, 1.596, 1.0937}}) {
    ProfileFit fit;
    for (PadValue& value : fit.values) value.refusal = "not here";
    fit.trials = fit.offset.untared = 4;
    fit.mu_load_n = told.usual_n;
    for (const auto& [number, value] :
         {std::pair(PadNumber::normal_exponent, told.exponent),
          {PadNumber::normal_stiffness, told.stiffness * true_stiffness_n_per_m}}) {
      const auto k = static_cast<std::size_t>(number);
      fit.values[k] = {value, 1000, 4, ""};
      fit.interval[k] = {0.999 * value, 1.001 * value};
    }
    doubt_zero(zero_doubt(fit, false), fit);
    EXPECT_TRUE(holds(fit, PadNumber::normal_exponent, 2)) << told.usual_n;
    EXPECT_TRUE(holds(fit, PadNumber::normal_stiffness, true_stiffness_n_per_m)) << told.usual_n;
  }
}

TEST(ZeroDoubt, AMomentInTheAirLeavesNone) {
  test::KnownSensors sensors;
  sensors.air_s = 0.3;
  sensors.tare_n = 0.2;
  const ProfileFit fit = fit_profile(clean(test::known_measurement(rubs, {}, sensors, 1), {}), {});
  EXPECT_TRUE(zero_doubt(fit, false).words.empty());
  EXPECT_TRUE(holds(fit, PadNumber::mu_dynamic, 0.2));
}

}  // namespace
}  // namespace fingerpad::zero_doubt_test
