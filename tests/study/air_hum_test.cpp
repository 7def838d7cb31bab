#include "study/air_hum.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "study/hum_evidence.hpp"
#include "study/hum_verdict.hpp"
#include "support/pad_measurement.hpp"

namespace fingerpad::air_hum_test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

constexpr Sensed forces = &RecordedTrial::force_W;

/// Rubs at one speed, whose teeth stand near 50 Hz, with a third of a second in the air before and after.
RecordedMeasurement even_rubs(double hum_n, double hum_hz) {
  constexpr double speed_m_per_s = 0.033;
  test::KnownSensors sensors;
  sensors.force_noise_n = 0.003;
  sensors.air_s = 0.3;
  sensors.hum_n = hum_n;
  sensors.hum_hz = hum_hz;
  std::vector<test::KnownTrial> rubs;
  for (int k = 0; k < 6; ++k) {
    const double frequency_hz = 0.3 + 0.02 * k;
    rubs.push_back({2, 45, 0, speed_m_per_s / 4 / frequency_hz, frequency_hz, 4});
    rubs.back().is_even = true;
  }
  return test::known_measurement(rubs, {}, sensors, 3);
}

double rms(const Points& force_n) {
  return std::sqrt(force_n.squaredNorm() / static_cast<double>(force_n.cols()));
}

TEST(AirHum, WhatTeethHaveOfHumsFrequencyIsLeftIn) {
  const RecordedMeasurement without = even_rubs(0, 50);
  int clean = 0, trials = 0;
  for (const double hum_hz : {49.8, 50.0, 50.2}) {
    RecordedMeasurement with = even_rubs(0.02, hum_hz);
    const HumVerdict verdict = judge_hum(with.trials, forces, Mains::any);
    for (std::size_t i = 0; i < with.trials.size(); ++i) {
      const double hum_n = rms(with.trials[i].force_W - without.trials[i].force_W);
      take_off(verdict.lines[i], forces, with.trials[i]);
      const double left_n = rms(with.trials[i].force_W - without.trials[i].force_W);
      // A millinewton, of amplitude and phase; one whose moments in the air are not both seen keeps a third.
      EXPECT_LT(left_n, 0.4 * hum_n) << hum_hz << " " << i;
      clean += left_n < 1.2e-3 ? 1 : 0;
      ++trials;
    }
    if (hum_hz < 50.1) {  // further off, teeth's line is no larger than what stands about it
      EXPECT_THAT(verdict.left_in, Contains(HasSubstr("beyond the hum that is seen in the air"))) << hum_hz;
    }
  }
  EXPECT_GE(clean, trials - 2);
}

TEST(AirHum, HumAloneIsTakenOutAsTheWholeTrialTellsIt) {
  test::KnownSensors sensors;
  sensors.air_s = 0.3;
  sensors.hum_n = 0.02;
  const RecordedMeasurement recorded =
      test::known_measurement({{2, 45, 0}, {2, 45, 90}, {2, 45, 45}}, {}, sensors, 3);
  const HumVerdict verdict = judge_hum(recorded.trials, forces, Mains::any);
  for (const auto& lines : verdict.lines) {
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_FALSE(lines[0].is_of_air);
  }
  EXPECT_THAT(verdict.left_in, Not(Contains(HasSubstr("beyond the hum"))));
}

TEST(AirHum, OfOneMomentBoundsTheLineByItsSize) {
  RecordedMeasurement recorded = even_rubs(0.02, 50);
  RecordedTrial& trial = recorded.trials[0];
  std::vector<Eigen::Index> begin;
  for (Eigen::Index i = 0; i < 250; ++i) begin.push_back(i);
  const std::vector<HumLine> lines = hum_lines(trial, forces, Mains::any);
  ASSERT_FALSE(lines.empty());
  HumLine line = lines[0];
  for (auto& phasor : line.phasors) phasor *= 5;  // mostly teeth's
  const auto bounded = AirHum(trial, forces, begin, 50).bounded(line, line.hz);
  ASSERT_TRUE(bounded);
  EXPECT_EQ(bounded->hz, line.hz);
  EXPECT_LT(bounded->amplitude(), 0.035);  // hum has half to one and a half of 20 mN
  EXPECT_GT(bounded->amplitude(), 0.005);
}

TEST(AirHum, WhereNothingHumsNothingIsBounded) {
  const RecordedMeasurement recorded = even_rubs(0, 50);
  for (const RecordedTrial& trial : recorded.trials) {
    std::vector<Eigen::Index> air;
    for (Eigen::Index i = 0; i < trial.samples(); ++i)
      if (i < 250 || i >= trial.samples() - 250) air.push_back(i);
    for (const HumLine& line : hum_lines(trial, forces, Mains::any)) {
      const AirHum in_air(trial, forces, air, line.nominal_hz);
      EXPECT_FALSE(in_air.bounded(line, line.hz)) << line.hz;
    }
  }
}

/// A finger that rubs at one speed is slower where it turns, by no other way of rubbing.
TEST(AirHum, TurnsOfARubAreNoOtherSpeeds) {
  test::KnownSensors sensors;
  sensors.force_noise_n = 0.003;
  sensors.hum_n = 0.03;
  test::KnownTrial rub{2, 45, 0, 0.02, 1.3, 8};
  rub.is_even = true;
  const RecordedMeasurement even = test::known_measurement({rub}, {}, sensors, 3);
  rub.is_even = false;
  const RecordedMeasurement swinging = test::known_measurement({rub}, {}, sensors, 3);
  const std::vector<HumLine> lines = hum_lines(even.trials[0], forces, Mains::any);
  ASSERT_FALSE(lines.empty());
  const HumEvidence evidence = hum_evidence(even.trials[0], forces, lines[0]);
  const auto turns = std::count_if(evidence.windows.begin(), evidence.windows.end(),
                                   [](const HumWindow& w) { return w.turns; });
  EXPECT_GT(turns, 4);
  const HumVerdict verdict = judge_hum(even.trials, forces, Mains::any);
  EXPECT_TRUE(verdict.lines[0].empty());
  EXPECT_THAT(verdict.left_in, Contains(HasSubstr("nothing tells it from teeth of stick and slip")));
  EXPECT_EQ(judge_hum(swinging.trials, forces, Mains::any).lines[0].size(), 1U);
}

}  // namespace
}  // namespace fingerpad::air_hum_test
