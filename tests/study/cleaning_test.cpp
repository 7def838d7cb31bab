#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/random_stream.hpp"
#include "study/force_tare.hpp"
#include "study/hum_verdict.hpp"
#include "study/measurement.hpp"
#include "study/position_delay.hpp"
#include "study/profile_fit.hpp"
#include "support/effort.hpp"
#include "support/pad_measurement.hpp"

namespace fingerpad::cleaning_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

const std::vector<test::KnownTrial> rubs{{1, 45, 0}, {1, 45, 90}, {1, 45, 45, 0.003, 1.0}};

test::KnownSensors sensors_in_the_air() {
  test::KnownSensors sensors;
  sensors.air_s = 0.3;
  return sensors;
}

Measurement cleaned(const test::KnownSensors& sensors, const CleaningSettings& settings = {}) {
  return clean(test::known_measurement(rubs, {}, sensors, 1), settings);
}

TEST(Cleaning, TakesADriftingTareOff) {
  test::KnownSensors sensors = sensors_in_the_air();
  sensors.tare_n = 0.2;
  sensors.drift_n_per_s = 0.02;
  RecordedMeasurement with = test::known_measurement(rubs, {}, sensors, 1);
  for (RecordedTrial& trial : with.trials) {
    TrialCleaning cleaning;
    const Vec3 before = trial.force_W.leftCols(200).rowwise().mean();
    EXPECT_GT(before.norm(), 0.02);
    take_tare(trial, cleaning);
    EXPECT_GT(cleaning.free_samples, 400);
    // The mean of 200 samples of 5 mN noise.
    EXPECT_LT(trial.force_W.leftCols(200).rowwise().mean().norm(), 2e-3);
    EXPECT_LT(trial.force_W.rightCols(200).rowwise().mean().norm(), 2e-3);
  }
}

/// What a six-axis sensor 20 mm below the plate records of trials, which nothing else watches along the
/// plate.
RecordedMeasurement sensed_by_torque(std::uint64_t seed, const Vec3& force_offset_n,
                                     const Vec3& torque_offset_n_m, bool has_air) {
  RecordedMeasurement recorded =
      test::known_measurement(rubs, {}, has_air ? sensors_in_the_air() : test::KnownSensors(), seed);
  for (RecordedTrial& trial : recorded.trials) {
    trial.sensor = ContactSensor{Vec3(0.01, 0.005, -0.02), 0};
    trial.tracked_W = trial.position_W;
    trial.tracked_W.topRows(2).setZero();
    trial.torque_W_n_m.resize(3, trial.samples());
    for (Eigen::Index i = 0; i < trial.samples(); ++i) {
      const Vec3 at(trial.position_W(0, i), trial.position_W(1, i), 0), force = trial.force_W.col(i);
      trial.torque_W_n_m.col(i) = (at - trial.sensor->origin_W).cross(force) + torque_offset_n_m;
      trial.force_W.col(i) += force_offset_n;
    }
  }
  return recorded;
}

TEST(Cleaning, TellsContactPointsFromTheWrenchThatItsTareIsOff) {
  const Vec3 force_n(0.05, -0.03, 0.15), torque_n_m(2e-3, -3e-3, 1e-3);
  const Measurement zeroed = clean(sensed_by_torque(1, Vec3::Zero(), Vec3::Zero(), true), {}),
                    offset = clean(sensed_by_torque(1, force_n, torque_n_m, true), {});
  EXPECT_THAT(offset.steps, Contains(HasSubstr("force and torque in 3 trials, after the tare")));
  ASSERT_EQ(offset.trials.size(), 3U);
  double worst_m = 0;
  const MeasuredTrial &one = zeroed.trials[0], &other = offset.trials[0];
  for (std::size_t i = 500; i < 3500; ++i)
    worst_m = std::max(worst_m, (one.position_m[i] - other.position_m[i]).norm());
  EXPECT_LT(worst_m, 1e-4);  // 3 mm off with the offsets left in
  // The finger of subject 1: 0.8 of 2 mm.
  const ProfileFit fit = fit_profile(offset, {});
  EXPECT_NEAR(fit.values[static_cast<std::size_t>(PadNumber::stick_stiffness)].value, 150 / 0.8, 4);
}

/// In stick the contact point stays where the skin holds on to the plate: it tells no spring.
TEST(Cleaning, TakesATrackedFingersPlacesAndNotItsContactPoints) {
  RecordedMeasurement recorded = sensed_by_torque(1, Vec3::Zero(), Vec3::Zero(), true);
  const Measurement plain = clean(test::known_measurement(rubs, {}, sensors_in_the_air(), 1), {});
  for (RecordedTrial& trial : recorded.trials) {
    trial.tracked_W = trial.position_W;
    for (Eigen::Index i = 0; i < trial.samples(); ++i)
      trial.torque_W_n_m.col(i) = Vec3(0.01, 0, 0.02).cross(Vec3(trial.force_W.col(i)));
  }
  const Measurement tracked = clean(recorded, {});
  EXPECT_THAT(tracked.steps, Contains(HasSubstr("contact points: passed over in 3 trials")));
  ASSERT_EQ(tracked.trials.size(), plain.trials.size());
  EXPECT_EQ(tracked.trials[0].position_m, plain.trials[0].position_m);
}

/// A marker that is lost for a sample is seen elsewhere; one that rests is seen with noise.
TEST(Cleaning, TakesNoNoiseOfAPlaceThatRestsForATrackedFinger) {
  RecordedMeasurement recorded = sensed_by_torque(1, Vec3::Zero(), Vec3::Zero(), true);
  RandomStream random(1);
  recorded.trials[0].tracked_W(0, 700) += 2e-3;
  for (const std::size_t trial : {1, 2}) {
    const double noise_m = trial == 1 ? 0.2e-3 : 0.6e-3;
    Points& places = recorded.trials[trial].tracked_W;
    for (Eigen::Index i = 0; i < places.cols(); ++i)
      places.col(i) += noise_m * Vec3(random.normal(), random.normal(), 0);
  }
  const Measurement cleaned = clean(recorded, {});
  EXPECT_THAT(cleaned.steps, Contains(HasSubstr("told from force and torque in 3 trials, after the tare")));
  EXPECT_THAT(cleaned.steps, Not(Contains(HasSubstr("passed over"))));
  EXPECT_EQ(cleaned.trials.size(), 3U);
}

TEST(Cleaning, TellsHowFarContactPointsLieFromATrackedFingerThatPresses) {
  RecordedMeasurement recorded = sensed_by_torque(1, Vec3::Zero(), Vec3::Zero(), true);
  for (RecordedTrial& trial : recorded.trials) trial.tracked_W.topRows(2) = trial.position_W.topRows(2);
  recorded.trials[1].force_W.row(2).setConstant(-1);
  CleaningSettings untared;
  untared.takes_tare = false;
  EXPECT_THAT(clean(recorded, untared).steps,
              Contains(AllOf(HasSubstr("passed over in 3 trials"), HasSubstr("mm from the tracked finger"),
                             HasSubstr("median of the 2 in which it presses"), Not(HasSubstr("nan")))));
  for (RecordedTrial& trial : recorded.trials) trial.force_W.row(2).setConstant(-1);
  EXPECT_THAT(clean(recorded, untared).steps, Contains(AllOf(HasSubstr("passed over in 3 trials"),
                                                             HasSubstr("as the finger presses in none"))));
}

TEST(Cleaning, SaysWhereContactPointsRestOnNoTare) {
  const Measurement pressed = clean(sensed_by_torque(1, Vec3::Zero(), Vec3::Zero(), false), {});
  EXPECT_THAT(pressed.steps, Contains(HasSubstr("in 3 of them no tare was taken off")));
}

/// A tenth of a second in the air, beside a second in which it comes down slowly.
TEST(Cleaning, TakesTheTareOfAShortMomentBesideSlowRamps) {
  test::KnownSensors sensors;
  sensors.air_s = 0.1;
  sensors.tare_n = 0.2;
  std::vector<test::KnownTrial> slow = rubs;
  for (test::KnownTrial& trial : slow) trial.ramp_s = 1;
  RecordedMeasurement with = test::known_measurement(slow, {}, sensors, 1);
  for (RecordedTrial& trial : with.trials) {
    TrialCleaning cleaning;
    EXPECT_GT(trial.force_W.leftCols(100).rowwise().mean().norm(), 0.02);
    take_tare(trial, cleaning);
    EXPECT_GT(cleaning.free_samples, 100) << trial_name(trial);
    // The mean of 100 samples of 5 mN noise, and what of the ramp's begin passes for none.
    EXPECT_LT(trial.force_W.leftCols(100).rowwise().mean().norm(), 3e-3);
    EXPECT_LT(trial.force_W.rightCols(100).rowwise().mean().norm(), 3e-3);
  }
}

TEST(Cleaning, AFingerThatOnlyPressesLessIsNoTare) {
  test::KnownFinger quiet;
  quiet.vibration = 0;  // so that even slip is as still as the noise
  for (const test::KnownFinger& finger : {test::KnownFinger{}, quiet}) {
    RecordedMeasurement pressed = test::known_measurement(test::fewer_trials(), finger, {}, 6);
    for (RecordedTrial& trial : pressed.trials) {
      TrialCleaning cleaning;
      take_tare(trial, cleaning);
      EXPECT_EQ(cleaning.free_samples, 0) << trial_name(trial);
    }
  }
}

/// The bottom of such a swing is as still as its noise, and low; of a quick and deep one it is short.
TEST(Cleaning, NeitherIsOneWhoseLoadSwings) {
  struct Swing {
    double middle_n, share, hz;
  };
  const RecordedTrial rub = test::known_measurement(rubs, {}, {}, 1).trials[0];
  RandomStream random(3);
  for (const Swing& swing : {Swing{0.8, 0.25, 0.4}, Swing{1, 0.8, 0.5}, Swing{1.5, 0.8, 0.5},
                             Swing{2, 0.8, 0.5}, Swing{3, 0.8, 0.5}, Swing{2, 0.8, 1}}) {
    for (const double noise_n : {0.004, 0.005, 0.01, 0.02}) {
      for (int begin = 0; begin < 12; ++begin) {
        RecordedTrial trial = rub;
        for (Eigen::Index i = 0; i < trial.samples(); ++i) {
          const double turns = begin / 12.0 + swing.hz * static_cast<double>(i) / trial.rate_hz;
          const double load_n = swing.middle_n * (1 + swing.share * std::sin(2 * std::numbers::pi * turns));
          const Vec3 noise(random.normal(), random.normal(), random.normal());
          trial.force_W.col(i) = load_n * (trial.normal_W - 0.35 * Vec3::UnitX()) + noise_n * noise;
        }
        TrialCleaning cleaning;
        take_tare(trial, cleaning);
        EXPECT_EQ(cleaning.free_samples, 0) << swing.middle_n << " " << noise_n << " " << begin;
      }
    }
  }
}

/// What watches a finger whose load steps between a light one and 1.5 N, .4 s each, as it rubs to and fro.
struct SteppingLoad {
  double rate_hz = 1000, light_n = 0.3;
  bool has_height = true, rubs = true;
  double lifted_m = 0;  ///< above the plate in place of pressing lightly
  double ramp_s = 0.06;
};

RecordedTrial stepping(const SteppingLoad& load, std::uint64_t seed) {
  constexpr double noise_n = 2e-3, noise_m = 2e-6, step_s = 0.4, mu = 0.25, depth_at_1_n_m = 1.5e-3,
                   press_n = 1.5;
  constexpr double turn_s = 0.53;  // of the rub, so that light moments fall on both ways
  RandomStream random(seed);
  RecordedTrial trial;
  trial.rate_hz = load.rate_hz;
  const Eigen::Index n = std::lround(6 * load.rate_hz);
  trial.position_W.resize(3, n);
  trial.force_W.resize(3, n);
  trial.origin.assign(static_cast<std::size_t>(n), SampleOrigin::recorded);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double t = static_cast<double>(i) / load.rate_hz, turns = std::fmod(t / step_s, 2);
    const double in_step_s = step_s * std::fmod(turns, 1),
                 up = load.ramp_s > 0 ? std::min(1.0, in_step_s / load.ramp_s) : 1;
    const double share = turns < 1 ? up : 1 - up;
    const double low_m = load.lifted_m > 0 ? load.lifted_m : -depth_at_1_n_m * std::sqrt(load.light_n);
    const double height_m = low_m + share * (-depth_at_1_n_m * std::sqrt(press_n) - low_m);
    const double normal_n = height_m < 0 ? height_m * height_m / (depth_at_1_n_m * depth_at_1_n_m) : 0;
    const double to_and_fro = std::fmod(t / turn_s, 2), along = to_and_fro < 1 ? to_and_fro : 2 - to_and_fro;
    const double way = load.rubs ? (to_and_fro < 1 ? 1 : -1) : 0;
    trial.position_W.col(i) = Vec3(load.rubs ? 0.02 * along : 0, 0, load.has_height ? height_m : 0) +
                              noise_m * Vec3(random.normal(), random.normal(), random.normal());
    trial.force_W.col(i) = Vec3(0.03 - mu * way * normal_n, -0.02, 0.05 + normal_n) +
                           noise_n * Vec3(random.normal(), random.normal(), random.normal());
  }
  return trial;
}

TEST(Cleaning, NeitherIsOneThatGoesOnPressingLightly) {
  for (const double rate_hz : {250.0, 500.0, 1000.0}) {
    for (const double light_n : {0.1, 0.3}) {
      // By height alone, by friction alone, by both.
      for (const auto& [has_height, rubs] : {std::pair{true, false}, {false, true}, {true, true}}) {
        RecordedTrial trial = stepping({rate_hz, light_n, has_height, rubs}, 5);
        TrialCleaning cleaning;
        take_tare(trial, cleaning);
        EXPECT_EQ(cleaning.free_samples, 0) << rate_hz << " " << light_n << " " << has_height << rubs;
        EXPECT_TRUE(cleaning.presses_on);
      }
    }
  }
}

TEST(Cleaning, AFingerThatIsLiftedByHalfAMillimetreIsOffThePlate) {
  for (const double rate_hz : {250.0, 500.0, 1000.0}) {
    for (const auto& [has_height, rubs] : {std::pair{true, false}, {false, true}, {true, true}}) {
      SteppingLoad lifted{rate_hz, 0, has_height, rubs};
      lifted.lifted_m = 5e-4;
      RecordedTrial trial = stepping(lifted, 5);
      TrialCleaning cleaning;
      take_tare(trial, cleaning);
      EXPECT_GT(cleaning.free_samples, 0.2 * static_cast<double>(trial.samples())) << rate_hz;
      EXPECT_NEAR(cleaning.tare_begin_n.z(), 0.05, 2e-3);
    }
  }
}

TEST(Cleaning, AFingerThatIsLiftedWithinOneSampleIsSaidToLookLikeOneThatPressesOn) {
  for (const double ramp_s : {0.0, 0.06}) {
    for (const double lifted_m : {0.0, 2e-3}) {
      SteppingLoad at_once{1000, 0.1, true, false};
      at_once.lifted_m = lifted_m;
      at_once.ramp_s = ramp_s;
      RecordedTrial trial = stepping(at_once, 5);
      TrialCleaning cleaning;
      take_tare(trial, cleaning);
      const bool is_tared = lifted_m > 0 && ramp_s > 0;
      EXPECT_EQ(cleaning.free_samples > 0, is_tared) << ramp_s << " " << lifted_m;
      EXPECT_EQ(cleaning.falls_at_once, ramp_s == 0) << ramp_s << " " << lifted_m;
    }
  }
  SteppingLoad at_once{1000, 0, true, false, 2e-3, 0};
  RecordedMeasurement recorded;
  recorded.trials.push_back(stepping(at_once, 5));
  EXPECT_THAT(clean(std::move(recorded), {}).steps,
              Contains(HasSubstr("in 1 of them the force falls or rises there within one sample")));
}

/// A second in the air at its begin, in which the sensor drifts by more than its noise; then loads that swing
/// slowly through half of the press.
TEST(Cleaning, ADriftingSensorIsFreeInTheAirAllTheSame) {
  constexpr double drift_n_per_s = 8e-3, touch_s = 1;
  RandomStream random(7);
  RecordedTrial trial = stepping({1000, 0.5}, 5);
  for (Eigen::Index i = 0; i < trial.samples(); ++i) {
    const double t = static_cast<double>(i) / trial.rate_hz, pressed_s = t - touch_s;
    const double normal_n = pressed_s < 0 ? 0 : std::min(1.0, pressed_s / 0.05) * (1 + 0.5 * std::sin(3 * t));
    trial.position_W(2, i) =
        pressed_s < 0 ? std::min(3e-3, -0.03 * pressed_s) : -1.5e-3 * std::sqrt(normal_n);
    trial.force_W.col(i) = Vec3(0.03, -0.02, 0.05) + drift_n_per_s * t * Vec3(1, 0, 1.3) +
                           normal_n * Vec3(-0.2, 0, 1) +
                           2e-3 * Vec3(random.normal(), random.normal(), random.normal());
  }
  TrialCleaning cleaning;
  take_tare(trial, cleaning);
  EXPECT_GT(cleaning.free_samples, 800);
  EXPECT_LT(trial.force_W.leftCols(900).rowwise().mean().norm(), 1e-3);
}

TEST(Cleaning, SlowSamplesTellALiftToo) {
  for (const double rate_hz : {60.0, 80.0, 125.0}) {
    SteppingLoad lifted{rate_hz, 0, true, false};
    lifted.lifted_m = 5e-4;
    RecordedTrial trial = stepping(lifted, 5);
    TrialCleaning cleaning;
    take_tare(trial, cleaning);
    EXPECT_FALSE(cleaning.presses_on) << rate_hz;
    EXPECT_GT(cleaning.free_samples, 0) << rate_hz;
  }
}

TEST(Cleaning, TakesMainsHumOutAndLeavesTheRest) {
  test::KnownSensors sensors, still;
  sensors.hum_n = 0.02;
  sensors.hum_hz = 50;
  RecordedMeasurement with = test::known_measurement(rubs, {}, sensors, 1),
                      without = test::known_measurement(rubs, {}, still, 1);
  const HumVerdict lines = judge_hum(with.trials, &RecordedTrial::force_W, Mains::any);
  for (std::size_t i = 0; i < with.trials.size(); ++i) {
    const double before = (with.trials[i].force_W - without.trials[i].force_W).rowwise().norm().maxCoeff();
    const MainsHum hum = take_off(lines.lines[i], &RecordedTrial::force_W, with.trials[i]);
    EXPECT_NEAR(hum.frequency_hz, 50, 0.1);
    EXPECT_LT((with.trials[i].force_W - without.trials[i].force_W).rowwise().norm().maxCoeff(), 0.2 * before);
    EXPECT_TRUE(hum_lines(without.trials[i], &RecordedTrial::force_W, Mains::any).empty());
  }
}

/// Over a minute frequencies lie 16 mHz apart, of which the peak's parabola tells a twentieth.
TEST(Cleaning, FindsTheHumsFrequencyInALongTrial) {
  RecordedTrial trial = test::known_measurement({{1, 45, 0, 0.06, 0.6, 60}}, {}, {}, 1).trials[0];
  for (const double hum_hz : {49.62, 50.113}) {
    RecordedTrial with = trial;
    for (Eigen::Index i = 0; i < trial.samples(); ++i) {
      const double t_s = static_cast<double>(i) / trial.rate_hz;
      with.force_W(1, i) += 0.02 * std::sin(2 * std::numbers::pi * hum_hz * t_s + 1);
    }
    const MainsHum hum =
        take_off(hum_lines(with, &RecordedTrial::force_W, Mains::hz_50), &RecordedTrial::force_W, with);
    EXPECT_NEAR(hum.frequency_hz, hum_hz, 1e-3);
    EXPECT_NEAR(hum.amplitude, 0.02, 1e-3);
  }
}

TEST(Cleaning, FindsTheDelayOfForceBehindPosition) {
  for (const double delay_s : {-0.0042, 0.0, 0.0127}) {
    test::KnownSensors sensors;
    sensors.delay_s = delay_s;
    const Measurement measurement = cleaned(sensors);
    ASSERT_EQ(measurement.delays.front().estimate.refusal, "");
    // A third of a sample: it rests on some seconds of stick.
    EXPECT_NEAR(measurement.delays.front().estimate.delay_s, delay_s, 3.5e-4);
    EXPECT_THAT(measurement.steps, Contains(HasSubstr("taken out")));
  }
}

/// Trials as if of one file.
RecordedMeasurement of_file(const std::string& name, const std::vector<test::KnownTrial>& trials,
                            double delay_s, std::uint64_t seed) {
  test::KnownSensors sensors;
  sensors.delay_s = delay_s;
  RecordedMeasurement recorded = test::known_measurement(trials, {}, sensors, seed);
  for (RecordedTrial& trial : recorded.trials) trial.file = name;
  return recorded;
}

RecordedMeasurement joined(const std::vector<RecordedMeasurement>& files) {
  RecordedMeasurement all;
  for (const RecordedMeasurement& file : files)
    all.trials.insert(all.trials.end(), file.trials.begin(), file.trials.end());
  return all;
}

TEST(Cleaning, EachFileHasADelayOfItsOwn) {
  const Measurement measurement =
      clean(joined({of_file("one.csv", rubs, 2e-3, 1), of_file("other.csv", rubs, 11.4e-3, 2)}), {});
  ASSERT_EQ(measurement.delays.size(), 2u);
  EXPECT_NEAR(measurement.delays[0].estimate.delay_s, 2e-3, 3.5e-4);  // a third of a sample, as above
  EXPECT_NEAR(measurement.delays[1].estimate.delay_s, 11.4e-3, 3.5e-4);
  EXPECT_THAT(measurement.steps,
              Contains(testing::AllOf(HasSubstr("one.csv: force lags position by 2."),
                                      HasSubstr("other.csv: force lags position by 11."))));
}

TEST(Cleaning, AFileThatIsNamedTwiceHasOneDelay) {
  const RecordedMeasurement one = of_file("one.csv", rubs, 2e-3, 1),
                            other = of_file("other.csv", rubs, 11.4e-3, 2);
  const Measurement once = clean(joined({one, other}), {}), twice = clean(joined({one, other, one}), {});
  ASSERT_EQ(twice.delays.size(), 2u);
  EXPECT_NEAR(twice.delays[0].estimate.delay_s, once.delays[0].estimate.delay_s, 1e-12);
}

/// A tenth of a second of stick alone says nothing; that of several files does.
TEST(Cleaning, FilesThatDoNotTellTheirDelayAreTakenTogether) {
  std::vector<RecordedMeasurement> files;
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
    files.push_back(of_file("short" + std::to_string(seed), {{1, 45, 0, 0.003, 4.0, 0.25}}, 5e-3, seed));
  const Measurement measurement = clean(joined(files), {});
  ASSERT_EQ(measurement.delays.size(), 1u);
  EXPECT_EQ(measurement.delays[0].files.size(), 6u);
  EXPECT_EQ(measurement.delays[0].estimate.refusal, "");
  EXPECT_NEAR(measurement.delays[0].estimate.delay_s, 5e-3, 1e-3);
  EXPECT_THAT(measurement.steps, Contains(HasSubstr("6 files together: force lags position")));
}

/// The bend of a cubic spring must not pass for a delay.
TEST(Cleaning, ACubicSpringsDelayIsFoundToo) {
  test::KnownFinger finger;
  finger.cubic_share = 0.3;
  test::KnownSensors sensors;
  sensors.delay_s = 7.3e-3;
  const Measurement measurement = clean(test::known_measurement(rubs, finger, sensors, 1), {});
  // Its soft begin passes for slip, which leaves a millisecond or two; a straight spring would be three to
  // four off.
  EXPECT_NEAR(measurement.delays.front().estimate.delay_s, 7.3e-3, 2.5e-3);
}

TEST(Cleaning, LooksForADelayWithin50MillisecondsAtEachRate) {
  static_assert(delay_lags_each_way * delay_step_s == 0.05);
  for (const double rate_hz : {40.0, 100.0, 700.0, 1000.0, 1400.0, 1600.0, 5000.0}) {
    MeasuredTrial trial;
    trial.rate_hz = rate_hz;
    EXPECT_EQ(delay_sums(trial, {}).xx[0].size(), 101U) << rate_hz;
  }
}

/// Over lags a sample of 5 ms apart the delay would come out 0.6 ms short, at 333 Hz 0.24 ms.
TEST(Cleaning, FindsTheDelayOfSlowRecordings) {
  for (const double rate_hz : test::cases({200.0, 333.0, 500.0})) {
    test::KnownSensors sensors;
    sensors.rate_hz = rate_hz;
    sensors.delay_s = 4e-3;
    const Measurement measurement = clean(test::known_measurement(test::known_trials(), {}, sensors, 1), {});
    const DelayEstimate& delay = measurement.delays.front().estimate;
    // Three hundredths of a sample, and the tenth of a millisecond that is left at 1 kHz.
    EXPECT_NEAR(delay.delay_s, 4e-3, 0.03 / rate_hz + 0.05e-3) << rate_hz;
    ASSERT_TRUE(delay.interval_s) << rate_hz;
    EXPECT_LT(delay.interval_s->first, 4e-3) << rate_hz;
    EXPECT_GT(delay.interval_s->second, 4e-3) << rate_hz;
    EXPECT_NEAR(delay.unsure_s, 0.05 / rate_hz, 1e-9);
    EXPECT_THAT(measurement.steps, Contains(HasSubstr("ms apart leave 0."))) << rate_hz;
  }
}

TEST(Cleaning, AKnownDelayIsTakenOutInstead) {
  test::KnownSensors sensors;
  sensors.delay_s = 0.01;
  CleaningSettings settings;
  settings.delay_s = 0.01;
  const Measurement told = cleaned(sensors, settings);
  ASSERT_FALSE(told.trials.empty());
  const MeasuredTrial& trial = told.trials.front();
  // In the middle of a rub: places are those of the forces' moments, 10 ms at 0.2 m/s being 2 mm.
  for (std::size_t i = 500; i < 3000; i += 100) {
    const double t = trial.t_s[i];
    const double place_m = 0.06 * std::sin(2 * std::numbers::pi * 0.6 * t);
    EXPECT_NEAR(trial.position_m[i].norm(), std::abs(place_m), 1e-4);  // five deviations of noise
  }
}

TEST(Cleaning, FillsShortGapsAndLeavesLongOnesOut) {
  test::KnownSensors sensors;
  sensors.lost_share = 0.02;
  const Measurement measurement = cleaned(sensors);
  long filled = 0, missing = 0, samples = 0;
  for (const TrialCleaning& trial : measurement.cleanings) {
    filled += trial.filled;
    missing += trial.missing;
    samples += trial.samples;
  }
  EXPECT_GT(filled, samples / 200);
  EXPECT_GT(missing, 20);
  CleaningSettings unfilled;
  unfilled.longest_fill_s = 0;
  EXPECT_EQ(cleaned(sensors, unfilled).cleanings.front().filled, 0);
}

TEST(Cleaning, EachStepCanBeLeftOutAndIsSaidSo) {
  CleaningSettings none;
  none.mains = Mains::off;
  none.takes_tare = false;
  none.takes_delay = false;
  const Measurement measurement = cleaned(test::bad_sensors(), none);
  EXPECT_THAT(measurement.steps, Contains(HasSubstr("mains hum: left in (off)")));
  EXPECT_THAT(measurement.steps, Contains(HasSubstr("tare: left as it is (off)")));
  EXPECT_THAT(measurement.steps, Contains(HasSubstr("left in (off)")));
  EXPECT_THAT(measurement.steps, Contains(HasSubstr("low pass: off")));
}

TEST(Cleaning, TheLowPassLeavesNoDelayAndLessNoise) {
  CleaningSettings smooth;
  smooth.smoothing_hz = 100;
  smooth.takes_delay = false;
  CleaningSettings raw;
  raw.takes_delay = false;
  const Measurement passed = cleaned({}, smooth), plain = cleaned({}, raw);
  const auto roughness = [](const MeasuredTrial& trial) {
    double sum = 0;
    for (std::size_t i = 502; i < 3000; ++i)
      sum += (trial.position_m[i] - 2 * trial.position_m[i - 1] + trial.position_m[i - 2]).squaredNorm();
    return sum;
  };
  EXPECT_LT(roughness(passed.trials.front()), 0.05 * roughness(plain.trials.front()));
  for (std::size_t i = 500; i < 3000; i += 50)
    EXPECT_NEAR((passed.trials.front().position_m[i] - plain.trials.front().position_m[i]).norm(), 0, 1.2e-4);
}

}  // namespace
}  // namespace fingerpad::cleaning_test
