#include "study/friction_vibration.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace fingerpad::friction_vibration_test {
namespace {

constexpr Restick both[] = {Restick::level, Restick::crossing};

TEST(FrictionVibration, AboveVMinItIsAsStrongAsAskedWithEitherReading) {
  for (const double rate_hz : {1000.0, 4000.0}) {
    for (const Restick restick : both) {
      const VibrationFelt felt =
          vibration_felt({.speed_m_per_s = 0.15, .rate_hz = rate_hz, .restick = restick});
      EXPECT_EQ(felt.slip_share, 1);
      // Four seconds of a peak 20 Hz broad are some 125 independent values of its power: 9 % of scatter in
      // it, half of that in the RMS.
      EXPECT_NEAR(felt.band_share / asked_band_share(), 1, 0.1) << rate_hz;
    }
  }
}

TEST(FrictionVibration, BelowVMinLevelLeavesTheTeethAlone) {
  // 0.05 m/s: teeth of 0.1 mm beat at 500 Hz, far from the band.
  const VibratingDrag drag{.speed_m_per_s = 0.05, .rate_hz = 4000, .restick = Restick::level};
  VibratingDrag still = drag;
  still.vibrates = false;
  EXPECT_EQ(vibration_felt(drag).slip_share, 0);
  EXPECT_EQ(vibration_felt(drag).force_n, vibration_felt(still).force_n);
  EXPECT_LT(vibration_felt(drag).band_share, 0.05 * asked_band_share());
}

TEST(FrictionVibration, BelowVMinCrossingKeepsIt) {
  const VibrationFelt felt = vibration_felt({.speed_m_per_s = 0.02, .restick = Restick::crossing});
  EXPECT_EQ(felt.slip_share, 1);
  EXPECT_NEAR(felt.band_share / asked_band_share(), 1, 0.1);
}

TEST(FrictionVibration, StrokesUnderLevelSlipForTheShareOfTimeAboveVMin) {
  // 0.2 m/s at the most: above 0.1 for 2/pi acos(1/2) = 2/3 of the time, at both ends to a tick of some 300.
  const VibratingDrag strokes{.speed_m_per_s = 0.2, .restick = Restick::level, .strokes = true};
  EXPECT_NEAR(vibration_felt(strokes).slip_share, 2.0 / 3, 4.0 / 300);
}

TEST(FrictionVibration, TeethBeatAtTheVibrationsOwnFrequencyWithoutAny) {
  // 0.01 m/s over teeth of 0.1 mm: 100 Hz, whose first harmonic is (mu_s - mu_d)/(pi mu_d sqrt 2) of mu_d n.
  const VibrationFelt felt = vibration_felt({.speed_m_per_s = 0.01, .rate_hz = 4000, .vibrates = false});
  EXPECT_NEAR(felt.band_share, 0.5 / std::numbers::pi / std::numbers::sqrt2, 0.001);
}

}  // namespace
}  // namespace fingerpad::friction_vibration_test
