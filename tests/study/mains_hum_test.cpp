#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "base/random_stream.hpp"
#include "study/hum_evidence.hpp"
#include "study/hum_verdict.hpp"
#include "study/measurement.hpp"
#include "support/effort.hpp"
#include "support/pad_measurement.hpp"

namespace fingerpad::mains_hum_test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr Sensed forces = &RecordedTrial::force_W;

/// Rubs at one speed, both ways: a pad of 2 mm and coefficients of 0.3 and 0.2 gives way every 0.67 mm, which
/// is 50 times a second here.
std::vector<test::KnownTrial> even_rubs(double frequency_step_hz, int trials = 6) {
  constexpr double speed_m_per_s = 0.033;
  std::vector<test::KnownTrial> rubs;
  for (int k = 0; k < trials; ++k) {
    const double frequency_hz = 0.3 + frequency_step_hz * k;
    test::KnownTrial trial{2, 45, 0, speed_m_per_s / 4 / frequency_hz, frequency_hz, 4};
    trial.is_even = true;
    rubs.push_back(trial);
  }
  return rubs;
}

const std::vector<test::KnownTrial> swift_rubs{{2, 45, 0}, {2, 45, 90}, {2, 45, 45}};

test::KnownSensors sensors_with(double air_s, double hum_n) {
  test::KnownSensors sensors;
  sensors.force_noise_n = 0.003;
  sensors.air_s = air_s;
  sensors.hum_n = hum_n;
  return sensors;
}

/// A sine on the first axis of some samples.
void add_sine(RecordedTrial& trial, double hz, double amplitude_n, Eigen::Index from, Eigen::Index to) {
  for (Eigen::Index i = from; i < to; ++i)
    trial.force_W(0, i) +=
        amplitude_n * std::sin(2 * std::numbers::pi * hz * static_cast<double>(i) / trial.rate_hz);
}

long taken(const HumVerdict& verdict, double nominal_hz) {
  long lines = 0;
  for (const auto& trial : verdict.lines)
    lines += std::count_if(trial.begin(), trial.end(),
                           [&](const HumLine& line) { return line.nominal_hz == nominal_hz; });
  return lines;
}

long standing(const RecordedMeasurement& recorded, double nominal_hz) {
  long lines = 0;
  for (const RecordedTrial& trial : recorded.trials)
    for (const HumLine& line : hum_lines(trial, forces, Mains::any))
      lines += line.nominal_hz == nominal_hz ? 1 : 0;
  return lines;
}

TEST(MainsHum, TeethOfStickAndSlipAreNone) {
  for (const auto& [air_s, frequency_step_hz, trials] :
       test::cases({std::tuple(0.0, 0.02, 6), std::tuple(0.0, 0.01, 10), std::tuple(0.0, 0.0, 6),
                    std::tuple(0.3, 0.02, 6), std::tuple(0.3, 0.0, 6), std::tuple(0.0, 0.02, 1),
                    std::tuple(0.0, 0.009, 10)})) {
    const RecordedMeasurement recorded =
        test::known_measurement(even_rubs(frequency_step_hz, trials), {}, sensors_with(air_s, 0), 3);
    EXPECT_GT(standing(recorded, 50), 0)
        << "nothing to be taken for hum " << air_s << " " << frequency_step_hz;
    const HumVerdict verdict = judge_hum(recorded.trials, forces, Mains::any);
    EXPECT_EQ(taken(verdict, 50), 0) << air_s << " " << frequency_step_hz;
    EXPECT_THAT(verdict.left_in, Contains(HasSubstr("a line near 50 Hz is left in")));
    EXPECT_THAT(clean(recorded, {}).steps,
                Contains(HasSubstr("mains hum: none is taken out; a line near 50 Hz")));
  }
}

TEST(MainsHum, TheUsersWordOverridesIt) {
  const RecordedMeasurement recorded = test::known_measurement(even_rubs(0.02), {}, sensors_with(0.3, 0), 3);
  EXPECT_EQ(taken(judge_hum(recorded.trials, forces, Mains::hz_50), 50), standing(recorded, 50));
  EXPECT_EQ(taken(judge_hum(recorded.trials, forces, Mains::hz_60), 50), 0);
}

TEST(MainsHum, IsTakenOutBesideTeeth) {
  for (const double air_s : {0.0, 0.3}) {
    const RecordedMeasurement recorded =
        test::known_measurement(even_rubs(0.02), {}, sensors_with(air_s, 0.02), 3);
    const HumVerdict verdict = judge_hum(recorded.trials, forces, Mains::any);
    EXPECT_EQ(taken(verdict, 60), 6) << air_s;
    EXPECT_EQ(taken(verdict, 50), 0) << air_s;
  }
}

TEST(MainsHum, OfOneTrialIsToldByGoingOnAtOtherSpeeds) {
  const RecordedMeasurement recorded = test::known_measurement({swift_rubs[0]}, {}, sensors_with(0, 0.01), 3);
  EXPECT_EQ(taken(judge_hum(recorded.trials, forces, Mains::any), 60), 1);
}

TEST(MainsHum, ALineThatIsNotThereInTheAirIsNone) {
  // Of one frequency, amplitude and phase in every trial, but in contact alone.
  RecordedMeasurement recorded = test::known_measurement(swift_rubs, {}, sensors_with(0.3, 0), 3),
                      in_air_too = recorded;
  for (std::size_t k = 0; k < recorded.trials.size(); ++k) {
    RecordedTrial &trial = recorded.trials[k], &other = in_air_too.trials[k];
    const auto air = static_cast<Eigen::Index>(0.3 * trial.rate_hz);
    add_sine(trial, 50, 0.02, air, trial.samples() - air);
    add_sine(other, 50, 0.02, 0, trial.samples());
  }
  const HumVerdict verdict = judge_hum(recorded.trials, forces, Mains::any);
  EXPECT_EQ(taken(verdict, 50), 0);
  EXPECT_THAT(verdict.left_in, Contains(HasSubstr("not there where nothing touches the sensor")));
  EXPECT_THAT(verdict.left_in, Contains(HasSubstr("in 3 of 3 trials, of at most 0.02")));
  EXPECT_EQ(taken(judge_hum(in_air_too.trials, forces, Mains::any), 50), 3);
}

/// A finger that itself vibrates is pressed by a force that does, at any speed of its rubs: only the air
/// tells it from hum.
TEST(MainsHum, ALineThatThePositionHasTooIsNoneUnlessItIsInTheAir) {
  const auto judged = [](double air_s, double position_hz) {
    RecordedMeasurement recorded = test::known_measurement(swift_rubs, {}, sensors_with(air_s, 0), 3);
    for (RecordedTrial& trial : recorded.trials) {
      add_sine(trial, 50, 0.05, 0, trial.samples());
      for (Eigen::Index i = 0; i < trial.samples(); ++i)
        trial.position_W(2, i) +=
            4e-5 * std::sin(2 * std::numbers::pi * position_hz * static_cast<double>(i) / trial.rate_hz);
    }
    return judge_hum(recorded.trials, forces, Mains::any);
  };
  const HumVerdict vibrates = judged(0, 50);
  EXPECT_EQ(taken(vibrates, 50), 0);
  EXPECT_THAT(vibrates.left_in, Contains(HasSubstr("the finger's position moves at that frequency too")));
  EXPECT_EQ(taken(judged(0, 70), 50), 3) << "at another frequency";
  EXPECT_EQ(taken(judged(0.3, 50), 50), 3) << "in the air too";
}

TEST(MainsHum, IsAskedForInTheAirBeforeMostTrialsAre) {
  // One trial of six hums, in the air too.
  std::vector<test::KnownTrial> rubs = swift_rubs;
  rubs.insert(rubs.end(), swift_rubs.begin(), swift_rubs.end());
  RecordedMeasurement recorded = test::known_measurement(rubs, {}, sensors_with(0.3, 0), 3);
  add_sine(recorded.trials[2], 50, 0.02, 0, recorded.trials[2].samples());
  EXPECT_EQ(taken(judge_hum(recorded.trials, forces, Mains::any), 50), 1);
}

/// What is weighed as air is no window of the rest: four seconds on the plate, one in the air before and
/// after.
TEST(MainsHum, MomentsInTheAirAreWeighedOnce) {
  const RecordedMeasurement recorded = test::known_measurement(swift_rubs, {}, sensors_with(1, 0.02), 3);
  for (const RecordedTrial& trial : recorded.trials) {
    const std::vector<HumLine> lines = hum_lines(trial, forces, Mains::any);
    ASSERT_EQ(lines.size(), 1U);
    const HumEvidence evidence = hum_evidence(trial, forces, lines[0]);
    EXPECT_GT(evidence.still.share(), 0.9);
    EXPECT_LE(evidence.windows.size(), 22U) << "of 0.2 s";
    EXPECT_GE(evidence.windows.size(), 5U);
  }
}

TEST(MainsHum, FilledGapsAreNoAir) {
  // The air was not recorded: straight lines stand in it, without hum.
  RecordedMeasurement recorded = test::known_measurement(swift_rubs, {}, sensors_with(0.3, 0.02), 3);
  for (RecordedTrial& trial : recorded.trials) {
    const auto air = static_cast<Eigen::Index>(0.3 * trial.rate_hz);
    for (Eigen::Index i = 0; i < trial.samples(); ++i) {
      if (i >= air && i < trial.samples() - air) continue;
      trial.force_W.col(i) = Vec3(0, 0, 0.003 * (i % 2 == 0 ? 1 : -1));
      if (i % 100 > 5) trial.origin[static_cast<std::size_t>(i)] = SampleOrigin::filled;
    }
  }
  EXPECT_EQ(taken(judge_hum(recorded.trials, forces, Mains::any), 60), 3);
}

TEST(MainsHum, ALineThatIsNotThereWhileTheFingerRestsIsNone) {
  for (const bool hums : {true, false}) {
    RecordedMeasurement recorded = test::known_measurement(swift_rubs, {}, sensors_with(0, 0), 3);
    for (RecordedTrial& trial : recorded.trials) {
      const auto rest = static_cast<Eigen::Index>(0.25 * static_cast<double>(trial.samples()));
      for (Eigen::Index i = 0; i < rest; ++i) trial.position_W.col(i) = trial.position_W.col(rest);
      add_sine(trial, 50, 0.02, hums ? 0 : rest, trial.samples());
    }
    const HumVerdict verdict = judge_hum(recorded.trials, forces, Mains::any);
    EXPECT_EQ(taken(verdict, 50), hums ? 3 : 0);
    if (!hums) {
      EXPECT_THAT(verdict.left_in, Contains(HasSubstr("or the finger stands still")));
    }
  }
}

TEST(MainsHum, ALineThatDoesNotLastIsNone) {
  RecordedMeasurement recorded = test::known_measurement(swift_rubs, {}, sensors_with(0, 0), 3);
  for (RecordedTrial& trial : recorded.trials) add_sine(trial, 50, 0.02, 0, trial.samples() / 2);
  ASSERT_EQ(standing(recorded, 50), 3);
  const HumVerdict verdict = judge_hum(recorded.trials, forces, Mains::any);
  EXPECT_EQ(taken(verdict, 50), 0);
  EXPECT_THAT(verdict.left_in, Contains(HasSubstr("does not keep its amplitude and phase")));
}

TEST(MainsHum, OnlyTrialsThatCanShowALineAreCounted) {
  // All three of those that last for a second. Their hum is too weak for windows to tell it.
  std::vector<test::KnownTrial> rubs;
  for (int k = 0; k < 3; ++k) {
    rubs.push_back(even_rubs(0, 1)[0]);
    rubs.back().amplitude_m *= 1 - 0.1 * k;
  }
  for (int k = 0; k < 5; ++k) rubs.push_back({2, 45, 0, 0.06, 0.6, 0.8});
  RecordedMeasurement recorded = test::known_measurement(rubs, {}, sensors_with(0, 0), 3);
  for (RecordedTrial& trial : recorded.trials) add_sine(trial, 60, 0.0025, 0, trial.samples());
  EXPECT_EQ(taken(judge_hum(recorded.trials, forces, Mains::any), 60), 3);
  EXPECT_FALSE(can_show_line(recorded.trials.back(), forces, 60));
}

/// Torques about a sensor 20 mm below the plate, which alone tell where the finger is.
void add_torques(RecordedMeasurement& measurement, double hum_n_m) {
  for (RecordedTrial& trial : measurement.trials) {
    trial.sensor = ContactSensor{Vec3(0, 0, -0.02), 0};
    trial.tracked_W = trial.position_W;
    trial.torque_W_n_m = Points::Zero(3, trial.samples());
    for (Eigen::Index i = 0; i < trial.samples(); ++i) {
      const Vec3 arm = trial.position_W.col(i) + Vec3(0, 0, 0.02);
      trial.torque_W_n_m.col(i) = arm.cross(Vec3(trial.force_W.col(i)));
      trial.torque_W_n_m(0, i) +=
          hum_n_m * std::sin(2 * std::numbers::pi * 60 * static_cast<double>(i) / trial.rate_hz);
    }
    trial.tracked_W.topRows(2).setZero();  // nothing else sees it along the plate
  }
}

TEST(MainsHum, IsTakenOutOfTorquesThoughForcesHaveNone) {
  RecordedMeasurement recorded = test::known_measurement(swift_rubs, {}, sensors_with(0.3, 0), 3);
  RecordedMeasurement still = recorded;
  add_torques(recorded, 2e-3);
  add_torques(still, 0);
  const auto roughness = [](const Measurement& measurement) {
    const std::vector<Vec2>& p = measurement.trials.front().position_m;
    double sum = 0;
    for (std::size_t i = 900; i < 2900; ++i) sum += (p[i] - 2 * p[i - 1] + p[i - 2]).squaredNorm();
    return sum;
  };
  CleaningSettings settings, left;
  settings.takes_delay = left.takes_delay = false;
  left.mains = Mains::off;
  const double without = roughness(clean(still, settings)),
               hummed = roughness(clean(recorded, left)) - without;
  EXPECT_GT(hummed, 2 * without) << "the hum is too small to be seen";
  EXPECT_LT(roughness(clean(recorded, settings)) - without, 0.05 * hummed);
  const std::vector<std::string> steps = clean(recorded, settings).steps;
  EXPECT_THAT(steps, Contains(HasSubstr("mains hum: none stands out")));
  EXPECT_THAT(steps, Contains(HasSubstr("mains hum of torques: taken out of 3 of 3 trials, at most 2")));
}

TEST(MainsHum, OnlyTrialsWithTorquesAreCountedForThem) {
  // Torques of three trials hum, too weakly for windows to tell it; four have none.
  std::vector<test::KnownTrial> rubs;
  for (int k = 0; k < 7; ++k) {
    rubs.push_back(even_rubs(0, 1)[0]);
    rubs.back().amplitude_m *= 1 - 0.2 * (k % 3);
    rubs.back().duration_s = 12;
  }
  RecordedMeasurement all = test::known_measurement(rubs, {}, sensors_with(0, 0), 3), sensed = all;
  sensed.trials.resize(3);
  add_torques(sensed, 0);
  RandomStream random(1);
  for (RecordedTrial& trial : sensed.trials) {
    for (Eigen::Index i = 0; i < trial.samples(); ++i)
      trial.torque_W_n_m.col(i) =
          Vec3(2.5e-5 * std::sin(2 * std::numbers::pi * 60 * static_cast<double>(i) / trial.rate_hz) +
                   1e-4 * random.normal(),
               1e-4 * random.normal(), 1e-4 * random.normal());
  }
  std::copy(sensed.trials.begin(), sensed.trials.end(), all.trials.begin());
  EXPECT_EQ(taken(judge_hum(all.trials, &RecordedTrial::torque_W_n_m, Mains::any), 60), 3);
  EXPECT_THAT(clean(all, {}).steps, Contains(HasSubstr("mains hum of torques: taken out of 3 of 3 trials")));
}

TEST(MainsHum, TeethNearFiftyHertzLeaveTheLawFitting) {
  std::vector<test::KnownTrial> rubs = even_rubs(0.02);
  for (const test::KnownTrial& rub : swift_rubs) rubs.push_back(rub);
  const Measurement measurement = clean(test::known_measurement(rubs, {}, sensors_with(0, 0), 3), {});
  EXPECT_EQ(fit_profile(measurement, {}).residual.misfit, "");
}

}  // namespace
}  // namespace fingerpad::mains_hum_test
