#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "study/measurement.hpp"
#include "study/profile_fit.hpp"
#include "support/pad_measurement.hpp"

namespace fingerpad::line_left_in_test {
namespace {

using testing::Contains;
using testing::HasSubstr;

/// Swift rubs of a pad that vibrates; no trial has a moment in the air.
/// @param vibration_hz  0: it does not
/// @param line_n  of 50 Hz that force and position have, so that it is left in
ProfileFit fit_of(double vibration_hz, double line_n, Mains mains = Mains::any) {
  std::vector<test::KnownTrial> trials;
  for (const double bearing_deg : {0.0, 90.0, 45.0, 0.0}) trials.push_back({2, 45, bearing_deg});
  test::KnownFinger finger;
  finger.pad.vibration_hz = vibration_hz > 0 ? vibration_hz : 89;
  if (!(vibration_hz > 0)) finger.vibration = 0;
  test::KnownSensors sensors;
  sensors.hum_n = line_n;
  sensors.hum_hz = 50;
  RecordedMeasurement recorded = test::known_measurement(trials, finger, sensors, 1);
  for (RecordedTrial& trial : recorded.trials)
    for (Eigen::Index i = 0; line_n > 0 && i < trial.samples(); ++i)
      trial.position_W(2, i) +=
          4e-5 * std::sin(2 * std::numbers::pi * 50 * static_cast<double>(i) / trial.rate_hz);
  CleaningSettings settings;
  settings.mains = mains;
  return fit_profile(clean(recorded, settings), {});
}

const PadValue& vibration(const ProfileFit& fit) {
  return value_of(fit.values, PadNumber::vibration);
}

/// A line that stands ten times as high as the vibration.
TEST(LineLeftIn, IsNotToldAsTheVibration) {
  const ProfileFit fit = fit_of(95, 0.03);
  EXPECT_THAT(fit.steps, Contains(HasSubstr("a line near 50 Hz is left in 4 of 4 trials")));
  ASSERT_EQ(vibration(fit).refusal, "");
  EXPECT_NEAR(vibration(fit).value, 95, 2) << "as without the line";
  EXPECT_NEAR(vibration(fit).value, vibration(fit_of(95, 0)).value, 1);
}

/// Where a line pulls, ruptures come early: at 40 mN by up to a seventh of mu_static.
TEST(LineLeftIn, IsAllowedForByMuStatic) {
  const ProfileFit fit = fit_of(95, 0.04);
  ASSERT_THAT(fit.steps, Contains(HasSubstr("a line near 50 Hz is left in 4 of 4 trials")));
  const auto& both = fit.interval[static_cast<std::size_t>(PadNumber::mu_static)];
  ASSERT_TRUE(both);
  EXPECT_LE(both->first, 0.3);
  EXPECT_GE(both->second, 0.3);
}

TEST(LineLeftIn, IsNotToldWhereAnOptionLeavesItInEither) {
  for (const Mains mains : {Mains::off, Mains::hz_60}) {
    const ProfileFit fit = fit_of(95, 0.03, mains);
    ASSERT_EQ(vibration(fit).refusal, "");
    EXPECT_NEAR(vibration(fit).value, 95, 2);
  }
}

TEST(LineLeftIn, LeavesAVibrationOfItsFrequencyUntold) {
  const ProfileFit fit = fit_of(52, 0.03);
  for (const PadNumber number : {PadNumber::vibration, PadNumber::vibration_bandwidth})
    EXPECT_THAT(value_of(fit.values, number).refusal,
                AllOf(HasSubstr("a line near 50 Hz is left in the forces"), HasSubstr("--mains 50"),
                      HasSubstr("in the air")));
}

TEST(LineLeftIn, IsNamedWhereNothingElseStandsOut) {
  EXPECT_THAT(vibration(fit_of(0, 0.03)).refusal,
              AllOf(HasSubstr("no frequency stands out of the spectrum of slip elsewhere"),
                    HasSubstr("a line near 50 Hz is left in the forces"), HasSubstr("--mains 50")));
}

TEST(LineLeftIn, IsNoVibrationOfThePads) {
  for (const double hz : {50.0, 55.0, 60.0}) {
    const ProfileFit told = fit_of(hz, 0);
    ASSERT_EQ(vibration(told).refusal, "") << hz;
    EXPECT_NEAR(vibration(told).value, hz, 2) << "four trials tell it to 1 Hz";
  }
}

}  // namespace
}  // namespace fingerpad::line_left_in_test
