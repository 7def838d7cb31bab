#include "study/normal_law.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>

#include "study/cross_validation.hpp"
#include "study/fit_report.hpp"
#include "study/measurement_doubts.hpp"
#include "study/measurement_reader.hpp"
#include "study/profile_text.hpp"
#include "study/trial_rows.hpp"
#include "support/pad_measurement.hpp"
#include "support/paths.hpp"
#include "trace/hdf5_file.hpp"

namespace fingerpad::normal_law_test {
namespace {

using testing::AllOf;
using testing::AnyOf;
using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr double true_exponent = 2, true_stiffness_n_per_m = 2 / 1.5e-3;  // n = (depth/1.5 mm)^2, at 1 N

/// Two subjects, whose loads and ways differ, watched in the air too.
std::vector<test::KnownTrial> some_trials() {
  std::vector<test::KnownTrial> trials;
  for (const int subject : {1, 2}) {
    for (const double load_n : {0.8, 1.0, 1.5}) {
      for (const double bearing : {0.0, 90.0}) {
        test::KnownTrial trial{subject, 45, bearing, 0.06, 0.6, 3, load_n};
        trial.ramp_s = 0.5;
        trials.push_back(trial);
      }
    }
  }
  return trials;
}

test::KnownSensors watching_the_air() {
  test::KnownSensors sensors;
  sensors.air_s = 0.4;
  sensors.tare_n = 0.1;
  return sensors;
}

std::string some_table(std::uint64_t seed) {
  return test::measured_table(some_trials(), seed, {}, watching_the_air());
}

/// Calls the columns of a table otherwise.
std::string without_columns(std::string table, const std::vector<std::string>& names) {
  for (const std::string& name : names)
    table.replace(table.find("," + name + ",") + 1, name.size(), "other_" + name);
  return table;
}

class NormalLaw : public testing::Test {
 protected:
  std::string written(const std::string& name, const std::string& text) const {
    const std::string path = (folder / name).string();
    std::ofstream(path) << text;
    return path;
  }
  Measurement cleaned(const std::vector<std::string>& paths, const CleaningSettings& settings = {}) const {
    RecordedMeasurement recorded = read_measurements(paths, {});
    refuse_doubtful(recorded, {}, 0);
    return clean(std::move(recorded), settings);
  }
  const std::filesystem::path folder = test::scratch_dir();
};

const PadValue& of(const ProfileFit& fit, PadNumber number) {
  return value_of(fit.values, number);
}

bool is_normal(std::size_t k) {
  return k == static_cast<std::size_t>(PadNumber::normal_stiffness) ||
         k == static_cast<std::size_t>(PadNumber::normal_exponent);
}

void expect_normal_law_alone(const ProfileFit& fit, std::size_t trials) {
  for (std::size_t k = 0; k < fit.values.size(); ++k) {
    if (is_normal(k)) {
      EXPECT_EQ(fit.values[k].refusal, "");
      EXPECT_EQ(fit.values[k].trials, static_cast<long>(trials));
      EXPECT_TRUE(fit.interval[k]);
    } else {
      EXPECT_THAT(fit.values[k].refusal, HasSubstr("column fx_n missing")) << pad_number_keys[k];
      EXPECT_FALSE(fit.interval[k]) << pad_number_keys[k];
    }
  }
  EXPECT_NEAR(of(fit, PadNumber::normal_exponent).value, true_exponent, 0.03);
  EXPECT_NEAR(of(fit, PadNumber::normal_stiffness).value, true_stiffness_n_per_m, 30);
}

/// One trial has no interval that could allow for a wrong zero, and no friction that would speak of it.
TEST_F(NormalLaw, OfOneTrialWhoseZeroIsNotToldIsRefused) {
  test::KnownTrial press{2, 45, 0, 0.06, 0.6, 3, 1};
  press.ramp_s = 0.5;
  test::KnownSensors sensors;
  sensors.air_s = 0.4;
  RandomStream random(4);
  RecordedMeasurement recorded;
  TrialRows rows("press", 1, 1, true);
  for (const test::KnownRow& row : test::measured_rows({}, sensors, press, random)) {
    if (row.t_s < 0.55 || row.t_s > 3.25) continue;  // in the air, or nearly
    rows.add({row.t_s, row.position_W, row.force_W + Vec3(0, 0, 0.3), Vec3::UnitZ(), row.direction_W});
  }
  rows.finish(recorded);
  const auto fit_of = [&recorded](const CleaningSettings& settings) {
    return fit_profile(clean(test::of_normal_force_alone(recorded), settings), {});
  };
  CleaningSettings given;
  given.delay_s = 0;
  const ProfileFit one = fit_of(given);
  for (const PadNumber number : {PadNumber::normal_stiffness, PadNumber::normal_exponent})
    EXPECT_THAT(of(one, number).refusal,
                HasSubstr("no moment in the air tells the force's zero in 1 of 1 trials, and"));
  given.takes_tare = false;  // the user says that the sensor was zeroed
  EXPECT_EQ(of(fit_of(given), PadNumber::normal_exponent).refusal, "");
}

/// Presses so quick that 45 ms part pressing from lifting: with 25 ms more the height hardly follows the
/// force.
TEST_F(NormalLaw, OfADelayThatHidesItIsRefused) {
  std::vector<test::KnownTrial> trials = some_trials();
  for (test::KnownTrial& trial : trials) trial.ramp_s = 0.15;
  test::KnownSensors sensors = watching_the_air();
  sensors.delay_s = 0.045;
  const RecordedMeasurement recorded =
      test::of_normal_force_alone(test::known_measurement(trials, {}, sensors, 1));
  const ProfileFit fit = fit_profile(clean(recorded, {}), {});
  CleaningSettings given;
  given.delay_s = sensors.delay_s;
  const ProfileFit known = fit_profile(clean(recorded, given), {});
  for (const PadNumber number : {PadNumber::normal_stiffness, PadNumber::normal_exponent}) {
    EXPECT_EQ(of(fit, number).reason, RefusalReason::unknown_delay);
    EXPECT_THAT(of(fit, number).refusal, HasSubstr("give --delay 7ms"));
    EXPECT_FALSE(fit.interval[static_cast<std::size_t>(number)]);
    EXPECT_EQ(of(known, number).refusal, "");
  }
}

TEST_F(NormalLaw, IsToldByTheNormalForceAlone) {
  for (const std::vector<std::string>& missing :
       {std::vector<std::string>{"fx_n", "fy_n"}, std::vector<std::string>{"fx_n"}}) {
    const Measurement measurement = cleaned({written("normal.csv", without_columns(some_table(1), missing))});
    EXPECT_TRUE(measurement.trials.empty());
    EXPECT_TRUE(measurement.without_force.empty());
    ASSERT_EQ(measurement.pressed.size(), 12u);
    for (const MeasuredTrial& trial : measurement.pressed) {
      ASSERT_FALSE(trial.force_ratio.empty());
      EXPECT_THAT(trial.force_ratio, Each(Vec2(0, 0))) << "one of the two tells no friction";
    }
    const ProfileFit fit = fit_profile(measurement, {});
    expect_normal_law_alone(fit, 12);
    EXPECT_EQ(fit.subjects, 2u);
    EXPECT_EQ(fit.trials, 12u);
  }
}

TEST_F(NormalLaw, NothingOfFrictionIsSaidWhereNoneWasMeasured) {
  const Measurement measurement =
      cleaned({written("normal.csv", without_columns(some_table(2), {"fx_n", "fy_n"}))});
  const ProfileFit fit = fit_profile(measurement, {});
  EXPECT_EQ(fit.residual.misfit, "");
  EXPECT_EQ(fit.residual.untold, "");
  EXPECT_TRUE(fit.outliers.empty());
  EXPECT_EQ(fit.offset.told, 0u);
  for (const TrialCleaning& trial : measurement.cleanings) {
    EXPECT_GT(trial.free_samples, 0) << trial.name;
    EXPECT_EQ(trial.tare_begin_n.head<2>(), Vec2(0, 0)) << trial.name;
  }
  EXPECT_THAT(measurement.steps,
              AllOf(Contains(HasSubstr("normal force alone: in 12 trials, of which the delay is left in")),
                    Contains("mains hum: none stands out"), Each(Not(HasSubstr("stick")))));
  const std::string profile = profile_text(fit, "here");
  EXPECT_THAT(profile, AllOf(HasSubstr("normal_exponent = "), Not(HasSubstr("mu_load_n")),
                             Not(HasSubstr("law")), HasSubstr("measure the force along the plate too")));
  EXPECT_THAT(cross_validation_words(cross_validate(measurement, {})),
              HasSubstr("no trial has a force along the plate to foretell"));
  const FitReport report = fit_report(measurement, fit, {});
  EXPECT_TRUE(report.study.charts.empty());
  EXPECT_THAT(report.without_picture, Each(HasSubstr("column fx_n missing")));
}

TEST_F(NormalLaw, HumIsTakenOutOfTheNormalForceAlone) {
  // What hum of a hundredth of the load leaves in a pad's height outdoes the interval.
  test::KnownFinger finger;
  finger.rises_with_less_load = true;
  finger.scatter = 0.03;
  const test::KnownSensors sensors = test::bad_sensors();
  const double truth = test::known_numbers(finger, 1)[static_cast<std::size_t>(PadNumber::normal_stiffness)];
  CleaningSettings settings;
  settings.delay_s = sensors.delay_s;
  constexpr int sets = 10;
  int held = 0;
  for (std::uint64_t seed = 1; seed <= sets; ++seed) {
    const Measurement measurement = clean(
        test::of_normal_force_alone(test::known_measurement(some_trials(), finger, sensors, seed)), settings);
    for (const TrialCleaning& trial : measurement.cleanings)
      EXPECT_NEAR(trial.hum_hz, sensors.hum_hz, 0.2) << trial.name;
    const auto interval =
        fit_profile(measurement, {}).interval[static_cast<std::size_t>(PadNumber::normal_stiffness)];
    ASSERT_TRUE(interval);
    held += interval->first <= truth && truth <= interval->second ? 1 : 0;
  }
  EXPECT_GE(held, 9);
}

TEST_F(NormalLaw, IsToldByAllOfAMixedSetAndFrictionByThoseThatHaveIt) {
  const std::string whole = written("whole.csv", some_table(3)),
                    alone = written("normal.csv", without_columns(some_table(4), {"fx_n", "fy_n"}));
  const ProfileFit of_whole = fit_profile(cleaned({whole}), {});
  for (const std::vector<std::string>& paths : {std::vector{whole, alone}, std::vector{alone, whole}}) {
    const ProfileFit fit = fit_profile(cleaned(paths), {});
    EXPECT_EQ(fit.trials, 24u);
    EXPECT_EQ(of(fit, PadNumber::normal_exponent).trials, 24);
    EXPECT_NEAR(of(fit, PadNumber::normal_exponent).value, true_exponent, 0.03);
    EXPECT_EQ(fit.mu_load_n, of_whole.mu_load_n);
    for (std::size_t k = 0; k < fit.values.size(); ++k) {
      if (is_normal(k)) continue;
      EXPECT_EQ(fit.values[k].refusal, of_whole.values[k].refusal) << pad_number_keys[k];
      EXPECT_EQ(fit.values[k].trials, of_whole.values[k].trials) << pad_number_keys[k];
      if (fit.values[k].refusal.empty()) {
        EXPECT_EQ(fit.values[k].value, of_whole.values[k].value) << pad_number_keys[k];
      }
      EXPECT_EQ(fit.interval[k], of_whole.interval[k]) << pad_number_keys[k];
    }
  }
}

/// Of one trial's press the pad seems a third stiffer, as of a finger that is bent or a plate that gives way.
TEST_F(NormalLaw, ATrialWhosePadIsStifferIsListedAndCounted) {
  test::KnownFinger stiffer;
  stiffer.depth_at_1_n_m /= 1.3;
  RecordedMeasurement recorded = test::known_measurement(some_trials(), {}, watching_the_air(), 7);
  const RecordedMeasurement other = test::known_measurement(some_trials(), stiffer, watching_the_air(), 8);
  const auto told = [](const ProfileFit& fit) {
    std::vector<std::string> names;
    for (const OutlierTrial& one : fit.outliers) {
      EXPECT_EQ(one.number, PadNumber::normal_stiffness) << one.name;
      EXPECT_NEAR(one.usual, true_stiffness_n_per_m, 0.02 * true_stiffness_n_per_m);
      EXPECT_NEAR(one.value, 1.3 * true_stiffness_n_per_m, 0.03 * true_stiffness_n_per_m);
      names.push_back(one.name);
    }
    return names;
  };
  EXPECT_THAT(told(fit_profile(clean(recorded, {}), {})), testing::IsEmpty());
  recorded.trials[2] = other.trials[2];
  const ProfileFit fit = fit_profile(clean(recorded, {}), {});
  EXPECT_THAT(told(fit), ElementsAre(HasSubstr("trial 3")));
  EXPECT_EQ(of(fit, PadNumber::normal_stiffness).trials, 12);
  EXPECT_THAT(fit_notes(fit), Contains(HasSubstr("trial 3: its normal_stiffness_n_per_m is 17")));
  const ProfileFit alone = fit_profile(clean(test::of_normal_force_alone(recorded), {}), {});
  EXPECT_THAT(told(alone), ElementsAre(HasSubstr("trial 3")));
  RecordedMeasurement mixed = recorded;  // one trial has the normal force alone
  mixed.trials[5].force_W.topRows(2).setZero();
  mixed.trials[5].lacks = "column fx_n missing";
  EXPECT_THAT(told(fit_profile(clean(mixed, {}), {})), ElementsAre(HasSubstr("trial 3")));
}

TEST_F(NormalLaw, IsToldOfHdf5Too) {
  const RecordedMeasurement read = read_measurements({written("whole.csv", some_table(5))}, {});
  const std::string path = (folder / "normal.h5").string();
  std::map<std::string, std::vector<double>> columns;
  for (const RecordedTrial& trial : read.trials) {
    for (Eigen::Index i = 0; i < trial.samples(); ++i) {
      columns["t_s"].push_back(static_cast<double>(i) / trial.rate_hz);
      columns["x_m"].push_back(trial.position_W(0, i));
      columns["y_m"].push_back(trial.position_W(1, i));
      columns["z_m"].push_back(trial.position_W(2, i));
      columns["fz_n"].push_back(trial.force_W(2, i));
      columns["subject"].push_back(trial.subject);
      columns["trial"].push_back(trial.number);
    }
  }
  hdf5::Handle file = hdf5::create_file(path);
  for (const auto& [name, values] : columns)
    hdf5::append(hdf5::create_column(file, name.c_str(), hdf5::NumberType::float64, "1"), 0, values);
  hdf5::close_file(std::move(file));
  expect_normal_law_alone(fit_profile(cleaned({path}), {}), 12);
}

TEST_F(NormalLaw, TakesAPlateWhoseNormalIsAlongTheForce) {
  const auto tilted = [&](double nx) {
    std::string table = "t_s,x_m,y_m,z_m,fz_n,nx,ny,nz\n";
    for (int i = 0; i < 2000; ++i) {
      const double t = 1e-3 * i, load_n = 1 + 0.6 * std::sin(9 * t);
      table += fmt::format("{},{},0,{},{},{},0,1\n", t, 0.01 * t, -1.5e-3 * std::sqrt(load_n), load_n, nx);
    }
    return read_measurements({written("tilted.csv", table)}, {});
  };
  EXPECT_EQ(tilted(0.005).trials.size(), 1u);
  const RecordedMeasurement left_out = tilted(0.05);
  EXPECT_TRUE(left_out.trials.empty());
  EXPECT_THAT(left_out.without_force,
              ElementsAre(HasSubstr("column fx_n missing, and the plate's normal is not along fz")));
}

TEST_F(NormalLaw, TakesNoTareWhereFrictionMightTellThatTheFingerRubsOn) {
  // On a rail, whose height tells nothing.
  std::string table = "t_s,x_m,y_m,z_m,fx_n,fy_n,fz_n\n";
  for (int i = 0; i < 4000; ++i) {
    const double t = 1e-3 * i, load_n = i % 2000 < 1000 ? 0.3 : 1.5;
    table += fmt::format("{},{},0,0,0,0,{}\n", t, 0.01 * t, load_n + 1e-3 * ((i * 37) % 7 - 3));
  }
  const auto tared = [&](const std::string& text) {
    return cleaned({written("rail.csv", text)}).cleanings.front().free_samples;
  };
  EXPECT_GT(tared(table), 0);
  EXPECT_EQ(tared(without_columns(table, {"fx_n", "fy_n"})), 0);
}

}  // namespace
}  // namespace fingerpad::normal_law_test
