#include "study/measurement_doubts.hpp"
#include "study/odd_trials.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "base/random_stream.hpp"
#include "study/air_offset.hpp"
#include "study/measurement.hpp"
#include "study/measurement_words.hpp"
#include "study/odd_trials.hpp"
#include "support/pad_measurement.hpp"
#include "support/refusal.hpp"

namespace fingerpad::measurement_doubts_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::vector<test::KnownTrial> rubs{{1, 45, 0, 0.04, 0.7, 1.5}, {1, 45, 45, 0.04, 0.7, 1.5}};

/// What is asked of a measurement whose trials were changed so.
template <typename Change>
std::string asked(const Change& change, const MeasurementFormat& format = {}) {
  RecordedMeasurement recorded = test::known_measurement(rubs, {}, test::bad_sensors(), 1);
  for (RecordedTrial& trial : recorded.trials) change(trial);
  return test::why_not([&] { refuse_doubtful(recorded, format, 0); });
}

TEST(MeasurementDoubts, NothingIsAskedOfWhatIsAsItShouldBe) {
  RecordedMeasurement recorded = test::known_measurement(test::fewer_trials(), {}, test::bad_sensors(), 2);
  EXPECT_NO_THROW(refuse_doubtful(recorded, {}, 0));
}

TEST(MeasurementDoubts, AForgottenUnitIsAskedFor) {
  EXPECT_THAT(asked([](RecordedTrial& trial) { trial.position_W *= 1e3; }),
              AllOf(HasSubstr("positions reach over 68.4 m"), HasSubstr("--unit mm")));
  EXPECT_THAT(asked([](RecordedTrial& trial) { trial.force_W *= 102; }),
              AllOf(HasSubstr("harder than a finger rubs"), HasSubstr("--force-unit mN (or gf)")));
  EXPECT_THAT(asked([](RecordedTrial& trial) { trial.force_W *= 1e-3; }),
              AllOf(HasSubstr("lighter than a finger rubs"), HasSubstr("--force-unit kN")));
  EXPECT_THAT(asked([](RecordedTrial& trial) { trial.rate_hz *= 1e-3; }),
              AllOf(HasSubstr("1 samples a second"), HasSubstr("--time-unit ms")));
  EXPECT_THAT(asked([](RecordedTrial& trial) { trial.rate_hz *= 1e-6; }),
              HasSubstr("--time-unit us (or ms)"));
  EXPECT_THAT(asked([](RecordedTrial& trial) { trial.rate_hz *= 1e3; }), HasSubstr("say in what they are"));
  EXPECT_THAT(asked([](RecordedTrial& trial) { trial.torque_W_n_m = 12 * trial.force_W; }),
              AllOf(HasSubstr("forces 12 m from the sensor's origin"), HasSubstr("--torque-unit N.mm")));
  EXPECT_EQ(asked([](RecordedTrial& trial) { trial.torque_W_n_m = 0.012 * trial.force_W; }), "taken");
}

TEST(MeasurementDoubts, WhatIsSaidIsBelieved) {
  MeasurementFormat format;
  format.says_unit = format.says_time_unit = format.says_force_unit = format.says_torque_unit = true;
  EXPECT_EQ(asked(
                [](RecordedTrial& trial) {
                  trial.torque_W_n_m = 12 * trial.force_W;
                  trial.position_W *= 1e3;
                  trial.force_W *= 102;
                  trial.rate_hz *= 1e-3;
                },
                format),
            "taken");
}

/// What is warned of a measurement whose trials were changed so.
template <typename Change>
std::vector<std::string> warned(const Change& change, bool is_said) {
  RecordedMeasurement recorded = test::known_measurement(rubs, {}, test::bad_sensors(), 1);
  for (RecordedTrial& trial : recorded.trials) change(trial);
  MeasurementFormat format;
  format.says_unit = format.says_time_unit = format.says_force_unit = is_said;
  return doubts_of(recorded, format);
}

TEST(MeasurementDoubts, ASaidUnitThatIsHardlyAFingersIsToldAsAWarning) {
  using testing::ElementsAre;
  EXPECT_THAT(warned([](RecordedTrial&) {}, true), testing::IsEmpty());
  const auto centimetres = [](RecordedTrial& trial) { trial.position_W *= 10; };
  EXPECT_THAT(warned(centimetres, true), ElementsAre(HasSubstr("positions reach over 684 mm, farther"),
                                                     HasSubstr("m/s, faster than a finger rubs")));
  const auto tiny = [](RecordedTrial& trial) { trial.position_W *= 5e-3; };
  EXPECT_THAT(warned(tiny, true), ElementsAre(HasSubstr("mm, less than a finger rubs")));
  MeasurementFormat as_mm;
  as_mm.says_unit = true;
  as_mm.metres_per_unit = 1e-3;
  RecordedMeasurement metres = test::known_measurement(rubs, {}, test::bad_sensors(), 1);
  for (RecordedTrial& trial : metres.trials) trial.position_W *= 1e-3;
  EXPECT_THAT(doubts_of(metres, as_mm), testing::Contains(HasSubstr("if they are metres, say --unit m")));
  const auto quick = [](RecordedTrial& trial) { trial.rate_hz *= 1e3; };
  EXPECT_THAT(warned(quick, true), ElementsAre(HasSubstr("1000000 samples a second"),
                                               HasSubstr("positions go at 37.3 m/s, faster")));
  const auto slow = [](RecordedTrial& trial) { trial.rate_hz *= 1e-2; };
  EXPECT_THAT(warned(slow, true), ElementsAre(HasSubstr("10 samples a second")));
  const auto hard = [](RecordedTrial& trial) { trial.force_W *= 102; };
  EXPECT_THAT(warned(hard, true), ElementsAre(HasSubstr("harder than a finger rubs")));
  const auto spike = [](RecordedTrial& trial) { trial.force_W(2, 1000) = 120; };
  EXPECT_THAT(warned(spike, true), ElementsAre(HasSubstr("forces reach 120 N")));
  // What is refused is not warned of too.
  EXPECT_THAT(warned(hard, false), testing::IsEmpty());
  EXPECT_THAT(warned(centimetres, false), testing::SizeIs(2));
}

TEST(MeasurementDoubts, WhatWasUnderstoodIsSaidInALine) {
  const RecordedMeasurement recorded = test::known_measurement(rubs, {}, {}, 1);
  EXPECT_THAT(
      measurement_words(recorded),
      AllOf(HasSubstr("understood as 2 trials of 1 subject, 1.5 s each at 1000 samples a second"),
            HasSubstr("positions reach over 8"), HasSubstr("at up to 0.17"), HasSubstr("forces up to 1.")));
  RecordedMeasurement short_ones = recorded;  // seconds taken for milliseconds: 12 ms is longer than they are
  for (RecordedTrial& trial : short_ones.trials) trial.rate_hz *= 1000;
  EXPECT_THAT(measurement_words(short_ones), testing::Not(HasSubstr("at up to 0 m/s")));
  EXPECT_EQ(measurement_words({}), "");
}

TEST(MeasurementDoubts, AForceOnThePlateIsToldByItsPress) {
  const auto turned = [](RecordedTrial& trial) { trial.force_W *= -1; };
  EXPECT_THAT(asked(turned), AllOf(HasSubstr("along the plate's normal"), HasSubstr("--force-on plate")));
  MeasurementFormat format;
  format.force_on_plate = true;
  EXPECT_THAT(asked(turned, format), HasSubstr("--force-on finger"));
}

/// A sensor that was not zeroed, and reads less than 0 even where it is pressed.
TEST(MeasurementDoubts, ASteadyPullInTheAirIsAnOffsetAndNoForceOnThePlate) {
  const auto shifted = [](RecordedTrial& trial) { trial.force_W.row(2).array() -= 4; };
  EXPECT_THAT(asked(shifted), AllOf(HasSubstr("in the air before and after the press"),
                                    HasSubstr("not zeroed"), testing::Not(HasSubstr("--force-on"))))
      << "where it is to stay";
  EXPECT_THAT(asked([&](RecordedTrial& trial) {
                shifted(trial);
                trial.position_W.row(2).setZero();
              }),
              HasSubstr("not zeroed"))
      << "friction tells it where no height was measured";
  EXPECT_THAT(asked([&](RecordedTrial& trial) {
                shifted(trial);
                RandomStream random(3);
                for (double& height_m : trial.position_W.row(2)) height_m = 20e-6 * random.normal();
              }),
              HasSubstr("not zeroed"))
      << "nor is its noise a height";
  RecordedMeasurement recorded = test::known_measurement(rubs, {}, test::bad_sensors(), 1), zeroed = recorded;
  for (RecordedTrial& trial : zeroed.trials) shifted(trial);
  EXPECT_THAT(take_off_hiding_offsets(recorded), testing::IsEmpty()) << "of a usual sensor";
  EXPECT_THAT(take_off_hiding_offsets(zeroed), testing::ElementsAre(HasSubstr("Taken off 2 trials")));
  EXPECT_NO_THROW(refuse_doubtful(zeroed, {}, 0));
  for (std::size_t k = 0; k < zeroed.trials.size(); ++k) {
    // Nothing of it is left but what the sensor's own offset, noise and drift are.
    const Points off_n = zeroed.trials[k].force_W - recorded.trials[k].force_W;
    EXPECT_LT(off_n.cwiseAbs().maxCoeff(), 0.5);
    EXPECT_LT((off_n.colwise() - off_n.col(0)).cwiseAbs().maxCoeff(), 1e-9) << "a constant";
  }
}

/// It presses the plate where its trial begins and ends, and is lifted in between.
TEST(MeasurementDoubts, AFingerLiftedInTheMiddleOfAForceOnThePlateHasNoOffset) {
  EXPECT_THAT(asked([](RecordedTrial& trial) {
                const Eigen::Index n = trial.samples();
                for (Eigen::Index i = 0; i < n; ++i) {
                  const bool presses = i < n / 4 || i > n - n / 4;
                  trial.force_W.col(i) = Vec3(0, 0, presses ? -2 : 0);
                  trial.position_W.col(i).z() = presses ? -1e-3 : 2e-3;
                }
              }),
              HasSubstr("--force-on plate"));
}

TEST(MeasurementDoubts, AWrongSignOfTheTangentialForcesAloneIsToldByItsWork) {
  EXPECT_THAT(asked([](RecordedTrial& trial) { trial.force_W.topRows(2) *= -1; }),
              AllOf(HasSubstr("drives the finger along its way"), HasSubstr("--sensor-turned 0,0,0,1")));
}

TEST(MeasurementDoubts, AForceThatComesLateIsNoWrongSignWhereTheDelayIsKnown) {
  // A finger that is pushed to and fro, once a second: a quarter of that later its force goes with the
  // motion.
  test::KnownSensors sensors;
  sensors.delay_s = 0.25;
  const RecordedMeasurement recorded =
      test::known_measurement({{1, 45, 0, 5e-3, 1}, {1, 45, 90, 5e-3, 1}}, {}, sensors, 1);
  EXPECT_THAT(test::why_not([&] { refuse_doubtful(recorded, {}, 0); }), HasSubstr("say --delay 7ms"));
  EXPECT_NO_THROW(refuse_doubtful(recorded, {}, 0.25));
}

TEST(MeasurementDoubts, AMirroredAxisIsNamed) {
  EXPECT_THAT(asked([](RecordedTrial& trial) { trial.force_W.row(1) *= -1; }),
              AllOf(HasSubstr("along y alone"), HasSubstr("mirrored")));
  EXPECT_THAT(asked([](RecordedTrial& trial) { trial.position_W.row(0) *= -1; }),
              AllOf(HasSubstr("along x alone"), HasSubstr("turn that column's sign")));
}

TEST(MeasurementDoubts, WhatWrongTimesMakeOfTrialsIsNotTold) {
  RecordedMeasurement recorded =
      test::known_measurement({rubs[0], rubs[1], rubs[0], rubs[1]}, {}, test::bad_sensors(), 1);
  recorded.trials[2].force_W.topRows(2) *= -1;
  EXPECT_THAT(doubts_of(recorded, {}), testing::Contains(HasSubstr("trial 3")));
  for (RecordedTrial& trial : recorded.trials) trial.rate_hz /= 1000;
  EXPECT_THAT(doubts_of(recorded, {}), testing::Not(testing::Contains(HasSubstr("trial 3"))));
}

TEST(MeasurementDoubts, AFingerInTheAirUnderASensorsOffsetIsNotMirrored) {
  // It comes down along both axes, forwards, at the trial's end: the offset does work along y.
  const auto mostly_airborne = [](RecordedTrial& trial, Eigen::Index pressed) {
    const Eigen::Index n = trial.samples();
    for (Eigen::Index i = 0; i < n; ++i) {
      const double along_m = 1e-4 * static_cast<double>(i);
      trial.position_W.col(i) = Vec3(along_m, along_m, i < n - pressed ? 1e-3 : -1e-3);
      const double noise_n = i % 2 == 0 ? 1e-3 : -1e-3;
      trial.force_W.col(i) = Vec3(-0.08, 0.25, -0.03 + noise_n);
      if (i >= n - pressed) trial.force_W.col(i) += Vec3(-0.15, -0.15, 1);
    }
  };
  for (const Eigen::Index pressed : {0, 200})
    EXPECT_THAT(asked([&](RecordedTrial& trial) { mostly_airborne(trial, pressed); }),
                testing::Not(HasSubstr("mirrored")));
  EXPECT_THAT(asked([&](RecordedTrial& trial) {
                mostly_airborne(trial, 200);
                trial.force_W.row(1) = (0.5 - trial.force_W.row(1).array()).matrix();
              }),
              HasSubstr("mirrored"));
}

/// What is warned of a file of four trials, one of which was changed so.
template <typename Change>
std::vector<std::string> warned_of_one(const Change& change) {
  RecordedMeasurement recorded =
      test::known_measurement({rubs[0], rubs[1], rubs[0], rubs[1]}, {}, test::bad_sensors(), 1);
  change(recorded.trials[2]);
  const MeasurementFormat format;
  EXPECT_NO_THROW(refuse_doubtful(recorded, format, 0));
  return doubts_of(recorded, format);
}

TEST(MeasurementDoubts, OneTrialInAnotherUnitIsNamed) {
  using testing::ElementsAre;
  EXPECT_THAT(warned_of_one([](RecordedTrial&) {}), testing::IsEmpty());
  EXPECT_THAT(warned_of_one([](RecordedTrial& trial) { trial.force_W *= 1e3; }),
              ElementsAre(AllOf(HasSubstr("known, subject 1, trial 3: its normal force is "),
                                HasSubstr("is it in another unit?"))));
  EXPECT_THAT(warned_of_one([](RecordedTrial& trial) { trial.force_W *= 1e-3; }),
              ElementsAre(HasSubstr("trial 3: its normal force is 0.0")));
  EXPECT_THAT(warned_of_one([](RecordedTrial& trial) { trial.force_W *= 5; }), testing::IsEmpty())
      << "pressed harder";
}

/// What is warned of trials, each of which is changed by its place.
template <typename Change>
std::vector<std::string> warned_of_each(const std::vector<test::KnownTrial>& trials, const Change& change) {
  RecordedMeasurement recorded = test::known_measurement(trials, {}, test::bad_sensors(), 1);
  for (std::size_t i = 0; i < recorded.trials.size(); ++i) change(i, recorded.trials[i]);
  return doubts_of(recorded, MeasurementFormat());
}

/// Though they are as many as the others, or in a file of their own.
TEST(MeasurementDoubts, TrialsInAThousandthOfTheUnitAreNamedWithIt) {
  using testing::ElementsAre;
  const std::vector<test::KnownTrial> two{rubs[0], rubs[1]}, four{rubs[0], rubs[1], rubs[0], rubs[1]};
  EXPECT_THAT(warned_of_each(two,
                             [](std::size_t i, RecordedTrial& trial) {
                               trial.file = i == 0 ? "a" : "b";
                               if (i == 1) trial.force_W *= 1e3;
                             }),
              testing::Contains(AllOf(HasSubstr("b, subject 1, trial 2: its normal force is "),
                                      HasSubstr(" times the other trials' "), HasSubstr("In mN?"))));
  EXPECT_THAT(
      warned_of_each(two,
                     [](std::size_t i, RecordedTrial& trial) {
                       if (i == 0) trial.force_W *= 1e-3;
                     }),
      ElementsAre(AllOf(HasSubstr("trial 1: its normal force is "), HasSubstr("Or are the others, in mN?"))));
  const std::vector<std::string> of_four = warned_of_each(four, [](std::size_t i, RecordedTrial& trial) {
    if (i < 2) trial.force_W *= 1e3;
  });
  EXPECT_THAT(of_four, testing::Contains(AllOf(HasSubstr("trial 1: "), HasSubstr("In mN?"))));
  EXPECT_THAT(of_four, testing::Contains(AllOf(HasSubstr("trial 2: "), HasSubstr("In mN?"))));
  EXPECT_THAT(of_four, testing::Not(testing::Contains(HasSubstr("trial 3: "))));
}

TEST(MeasurementDoubts, PositionsInAnotherUnitAreNamed) {
  using testing::ElementsAre;
  EXPECT_THAT(warned_of_one([](RecordedTrial& trial) { trial.position_W *= 1e3; }),
              ElementsAre(AllOf(HasSubstr("trial 3: its positions reach over "), HasSubstr("In mm?"))));
  EXPECT_THAT(
      warned_of_one([](RecordedTrial& trial) { trial.position_W *= 1e-3; }),
      ElementsAre(AllOf(HasSubstr("trial 3: its positions"), HasSubstr("Or are the others, in mm?"))));
  EXPECT_THAT(warned_of_one([](RecordedTrial& trial) { trial.position_W *= 0.05; }), testing::IsEmpty())
      << "pushed, not rubbed";
  EXPECT_THAT(warned_of_one([](RecordedTrial& trial) {
                const Points noise = trial.position_W.rightCols(trial.samples() - 1) -
                                     trial.position_W.leftCols(trial.samples() - 1);
                trial.position_W.setZero();
                trial.position_W.rightCols(trial.samples() - 1) = 0.02 * noise;
              }),
              testing::IsEmpty())
      << "held still";
}

TEST(MeasurementDoubts, TrialsOfTheOtherSignAreNamedThoughTheyAreAsMany) {
  const auto turn_two = [](std::size_t i, RecordedTrial& trial) {
    if (i < 2) trial.force_W *= -1;
  };
  const std::vector<std::string> of_four = warned_of_each({rubs[0], rubs[1], rubs[0], rubs[1]}, turn_two);
  EXPECT_THAT(of_four, testing::SizeIs(2));
  for (const char* name : {"trial 1: its normal force is -", "trial 2: its normal force is -"})
    EXPECT_THAT(of_four, testing::Contains(HasSubstr(name)));
  EXPECT_THAT(warned_of_each({rubs[0], rubs[0]},
                             [](std::size_t i, RecordedTrial& trial) {
                               if (i == 1) trial.force_W *= -1;
                             }),
              testing::ElementsAre(HasSubstr("trial 2: its normal force is -")));
}

TEST(MeasurementDoubts, OneTrialWithAMirroredAxisIsNamed) {
  using testing::ElementsAre;
  for (const auto mirror : {+[](RecordedTrial& trial) { trial.force_W.row(1) *= -1; },
                            +[](RecordedTrial& trial) { trial.position_W.row(1) *= -1; }}) {
    RecordedMeasurement recorded =
        test::known_measurement({rubs[1], rubs[1], rubs[1], rubs[1]}, {}, test::bad_sensors(), 1);
    EXPECT_THAT(doubts_of(recorded, {}), testing::IsEmpty());
    mirror(recorded.trials[2]);
    EXPECT_THAT(doubts_of(recorded, {}),
                ElementsAre(AllOf(HasSubstr("trial 3: along y alone its force drives the finger"),
                                  HasSubstr("--leave-out 'subject 1, trial 3'"))));
  }
}

TEST(MeasurementDoubts, AMirroredHeightIsToldByTheAir) {
  using testing::ElementsAre;
  const auto mirror = [](RecordedTrial& trial) { trial.position_W.row(2) *= -1; };
  EXPECT_THAT(warned(mirror, false),
              ElementsAre(AllOf(HasSubstr("known: its finger is "), HasSubstr("mm higher where it presses"),
                                HasSubstr("turn that column's sign"))));
  EXPECT_THAT(warned_of_one(mirror),
              ElementsAre(AllOf(HasSubstr("trial 3: its finger is "), HasSubstr("--leave-out"))));
}

TEST(MeasurementDoubts, OneTrialsHeightDoesNotSpeakForOthersThatHaveNoAir) {
  test::KnownSensors airless = test::bad_sensors();
  airless.air_s = 0;
  RecordedMeasurement recorded = test::known_measurement({rubs[1], rubs[1], rubs[1]}, {}, airless, 1);
  recorded.trials[1] = test::known_measurement({rubs[1]}, {}, test::bad_sensors(), 1).trials[0];
  recorded.trials[1].position_W.row(2) *= -1;
  const std::vector<std::string> doubts = doubts_of(recorded, {});
  EXPECT_THAT(doubts,
              testing::Contains(AllOf(HasSubstr("mm higher where it presses"), HasSubstr("--leave-out"))));
  EXPECT_THAT(doubts, testing::Not(testing::Contains(HasSubstr("turn that column's sign"))));
  EXPECT_THAT(doubts, testing::Not(testing::Contains(HasSubstr("other trials' is lower"))))
      << "of them nothing is known";
}

TEST(MeasurementDoubts, AUnitThatTheTableTellsIsNotToBeSaidOtherwise) {
  RecordedMeasurement recorded = test::known_measurement(rubs, {}, test::bad_sensors(), 1);
  for (RecordedTrial& trial : recorded.trials) trial.rate_hz /= 1000;
  recorded.told_units[recorded.trials[0].file][static_cast<std::size_t>(Quantity::time)] = 1e-3;
  EXPECT_THAT(
      doubts_of(recorded, {}),
      testing::ElementsAre(AllOf(HasSubstr("if they are in us, which makes 1000 a second, the unit that its "
                                           "table tells of them is to be us"),
                                 testing::Not(HasSubstr("--time-unit")))));
}

TEST(MeasurementDoubts, APlateThatIsNotLevelIsNotMirrored) {
  // It lands at the low end of the plate and is lifted there, 10 degrees off level.
  EXPECT_THAT(warned(
                  [](RecordedTrial& trial) {
                    trial.position_W.row(2).setZero();
                    const Eigen::Index n = trial.samples();
                    for (Eigen::Index i = 0; i < n; ++i) {
                      const bool is_pressed = i > n / 4 && i < 3 * n / 4;
                      trial.position_W.col(i) = is_pressed ? Vec3(0.03, 0, 0.0053) : Vec3::Zero();
                      trial.force_W.col(i) = is_pressed ? Vec3(0, 0, 1) : Vec3::Zero();
                    }
                  },
                  true),
              testing::Not(testing::Contains(HasSubstr("mirrored"))));
}

TEST(MeasurementDoubts, SwappedForcesAreRefusedAndNoTrialIsOddByThem) {
  const auto swap_y_and_z = [](RecordedTrial& trial) { trial.force_W.row(1).swap(trial.force_W.row(2)); };
  RecordedMeasurement recorded =
      test::known_measurement({rubs[1], rubs[1], rubs[1], rubs[1]}, {}, test::bad_sensors(), 1);
  for (RecordedTrial& trial : recorded.trials) swap_y_and_z(trial);
  EXPECT_THAT(doubts_of(recorded, {}), testing::IsEmpty());
  EXPECT_THAT(test::why_not([&] { refuse_doubtful(recorded, {}, 0); }),
              AllOf(HasSubstr("known: along the plate's normal"), HasSubstr("along y it presses")));
}

TEST(MeasurementDoubts, SwappedForcesOfSingleTrialsAreToldOfThese) {
  RecordedMeasurement recorded =
      test::known_measurement({rubs[1], rubs[1], rubs[1], rubs[1]}, {}, test::bad_sensors(), 1);
  Eigen::Matrix3Xd& forces_W = recorded.trials[2].force_W;
  forces_W.row(1).swap(forces_W.row(2));
  EXPECT_NO_THROW(refuse_doubtful(recorded, {}, 0));
  const auto told = doubts_of(recorded, {});
  EXPECT_THAT(told, testing::Contains(AllOf(HasSubstr("trial 3: along the plate's normal"),
                                            HasSubstr("so in 1 of the 4 trials"),
                                            HasSubstr("--leave-out 'subject 1, trial 3'"))));
  EXPECT_EQ(
      std::ranges::count_if(told, [](const std::string& line) { return line.find("swapped") != line.npos; }),
      1);
}

TEST(MeasurementDoubts, SwappedForcesAreRefusedWhicheverColumnsAreInEachTrial) {
  RecordedMeasurement recorded =
      test::known_measurement({rubs[1], rubs[1], rubs[1], rubs[1]}, {}, test::bad_sensors(), 1);
  for (std::size_t i = 0; i < recorded.trials.size(); ++i) {
    Eigen::Matrix3Xd& forces_W = recorded.trials[i].force_W;
    forces_W.row(i % 2 == 0 ? 0 : 1).swap(forces_W.row(2));
  }
  EXPECT_THAT(test::why_not([&] { refuse_doubtful(recorded, {}, 0); }), HasSubstr("presses: two columns"));
}

TEST(MeasurementDoubts, AForceAlongThePlateThatIsTheSameThroughoutIsToldOfItsTrial) {
  RecordedMeasurement recorded =
      test::known_measurement({rubs[1], rubs[1], rubs[1]}, {}, test::bad_sensors(), 1);
  recorded.trials[1].force_W.topRows(2).setZero();
  EXPECT_THAT(doubts_of(recorded, {}),
              testing::Contains(AllOf(HasSubstr("trial 2: its force along the plate is 0 N in every sample"),
                                      HasSubstr("--leave-out 'subject 1, trial 2'"))));
}

TEST(MeasurementDoubts, NothingIsWarnedOfWhatIsAsItShouldBe) {
  test::KnownSensors late = test::bad_sensors(), off = test::bad_sensors(), airless = test::bad_sensors();
  late.delay_s = 0.03;
  off.tare_n = 0.3;
  off.drift_n_per_s = 0.05;
  airless.air_s = 0;
  test::KnownFinger sticky;
  sticky.pad = assumed_profile(1.5, 700);
  sticky.mu_dynamic = 1.2;
  std::uint64_t seed = 1;
  for (const test::KnownSensors& sensors : {test::bad_sensors(), late, off, airless, test::KnownSensors()}) {
    for (const test::KnownFinger& finger : {test::KnownFinger(), sticky}) {
      const RecordedMeasurement recorded =
          test::known_measurement(test::every(3, test::known_trials()), finger, sensors, seed);
      EXPECT_THAT(doubts_of(recorded, {}), testing::IsEmpty()) << seed;
      ++seed;
    }
  }
}

TEST(MeasurementDoubts, TimesInAnotherUnitThanWasSaidAreTakenForThatWhichMakesThemAFingers) {
  RecordedMeasurement recorded = test::known_measurement(rubs, {}, test::bad_sensors(), 1);
  for (RecordedTrial& trial : recorded.trials) trial.rate_hz /= 1000;
  MeasurementFormat milliseconds;
  milliseconds.says_time_unit = true;
  milliseconds.seconds_per_unit = 1e-3;
  EXPECT_THAT(
      doubts_of(recorded, milliseconds),
      testing::ElementsAre(HasSubstr("if they are in us, which makes 1000 a second, say --time-unit us")));
}

/// A trial in the air shows noise of either sign.
TEST(MeasurementDoubts, OneTrialThatNeverPressesIsInNoOtherUnit) {
  EXPECT_THAT(warned_of_one([](RecordedTrial& trial) {
                for (Eigen::Index i = 0; i < trial.samples(); ++i)
                  trial.force_W.col(i).setConstant(5e-3 * (i % 3 == 0 ? -1 : i % 5 == 0 ? 0.3 : 1));
              }),
              testing::IsEmpty());
}

TEST(MeasurementDoubts, OneTrialOfTheOtherSignIsNamed) {
  using testing::ElementsAre;
  EXPECT_THAT(warned_of_one([](RecordedTrial& trial) { trial.force_W.topRows(2) *= -1; }),
              ElementsAre(AllOf(HasSubstr("trial 3: its force drives the finger along its way"),
                                HasSubstr("neither slip nor springs"))));
  EXPECT_THAT(warned_of_one([](RecordedTrial& trial) { trial.force_W *= -1; }),
              ElementsAre(AllOf(HasSubstr("trial 3: its normal force is -"), HasSubstr("turned round"))));
}

/// The sensor's offset is more than it presses with, and below 0.
TEST(MeasurementDoubts, ALightTrialOfASensorThatIsOffHasNoOtherSign) {
  EXPECT_THAT(warned_of_one([](RecordedTrial& trial) {
                trial.force_W *= 0.05;
                trial.force_W.row(2).array() -= 0.12;
              }),
              testing::IsEmpty());
}

TEST(MeasurementDoubts, ATrialOfTheOtherSignIsLeftOut) {
  RecordedMeasurement recorded =
      test::known_measurement({rubs[0], rubs[1], rubs[0], rubs[1]}, {}, test::bad_sensors(), 1);
  recorded.trials[2].force_W *= -1;
  const std::string name = trial_name(recorded.trials[2]);
  leave_out_turned_presses(recorded);
  ASSERT_EQ(recorded.trials.size(), 3U);
  for (const RecordedTrial& trial : recorded.trials) EXPECT_NE(trial_name(trial), name);
}

TEST(MeasurementDoubts, OneOddTrialOfManyIsLeftToTheOutliers) {
  bool is_first = true;
  RecordedMeasurement recorded =
      test::known_measurement({rubs[0], rubs[0], rubs[1]}, {}, test::bad_sensors(), 1);
  for (RecordedTrial& trial : recorded.trials) {
    if (is_first) trial.force_W *= -1;
    is_first = false;
  }
  EXPECT_NO_THROW(refuse_doubtful(recorded, {}, 0));
}

}  // namespace
}  // namespace fingerpad::measurement_doubts_test
