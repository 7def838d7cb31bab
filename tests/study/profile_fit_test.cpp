#include "study/profile_fit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "friction/pad_profile_file.hpp"
#include "study/measurement_reader.hpp"
#include "support/pad_measurement.hpp"
#include "support/paths.hpp"
#include "support/refusal.hpp"
#include "support/shell.hpp"

namespace fingerpad::profile_fit_test {
namespace {

using testing::HasSubstr;

/// What known_trials were made with, in the order of PadNumber.
constexpr std::array<std::pair<PadNumber, double>, 9> truth{{{PadNumber::lateral_axis, 2e-3},
                                                             {PadNumber::longitudinal_axis, 1.6e-3},
                                                             {PadNumber::lateral_slope, 0.01},
                                                             {PadNumber::longitudinal_slope, 0.01},
                                                             {PadNumber::mu_static, 0.3},
                                                             {PadNumber::mu_dynamic, 0.2},
                                                             {PadNumber::stick_stiffness, 150},
                                                             {PadNumber::v_min, 0.1},
                                                             {PadNumber::vibration, 89}}};

std::string written(const std::string& name, const std::string& text) {
  const std::string path = (test::scratch_dir() / name).string();
  std::ofstream(path) << text;
  return path;
}

ProfileFit fitted(const std::vector<test::KnownTrial>& trials, std::uint64_t seed, double scatter = 0) {
  const std::string path = written("rubs.csv", test::measured_table(trials, seed, scatter));
  return fit_profile(clean(read_measurements({path}, {}), {}), {});
}

const PadValue& of(const ProfileFit& fit, PadNumber number) {
  return fit.values[static_cast<std::size_t>(number)];
}

/// The refusal of a number; empty where it is given.
std::string why(const ProfileFit& fit, PadNumber number) {
  return of(fit, number).refusal;
}

/// A table without the columns from a name on, up to another.
std::string without_columns(const std::string& table, const std::vector<std::string>& names) {
  std::string renamed = table;
  for (const std::string& name : names) {
    const auto at = renamed.find("," + name + ",");
    renamed.replace(at + 1, name.size(), "other_" + name);
  }
  return renamed;
}

TEST(ProfileFit, FindsTheKnownPadOfThreeSubjectsOfUnequalLength) {
  // Pads of one size a subject and 3:2:2 trials: did trials weigh alike, the axes would be 3 % short.
  const ProfileFit fit = fitted(test::known_trials(), 1);
  // As shares; the vibration is a random signal of 20 Hz width, seen for two minutes.
  constexpr std::array<double, truth.size()> near{0.003, 0.003, 0.01, 0.01, 0.003, 0.003, 0.003, 0.02, 0.02};
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const auto k = static_cast<std::size_t>(truth[i].first);
    ASSERT_EQ(fit.values[k].refusal, "") << pad_number_keys[k];
    EXPECT_NEAR(fit.values[k].value / truth[i].second, 1, near[i]) << pad_number_keys[k];
    ASSERT_TRUE(fit.interval[k]) << pad_number_keys[k];
    EXPECT_LT(fit.interval[k]->first, fit.values[k].value);
    EXPECT_GT(fit.interval[k]->second, fit.values[k].value);
    EXPECT_GT(fit.values[k].samples, 50);
  }
}

/// FINGERPAD_WRITE_MEASUREMENT=FILE writes it.
TEST(ProfileFit, TheShippedMeasurementIsOfTheKnownPad) {
  if (const char* path = std::getenv("FINGERPAD_WRITE_MEASUREMENT"))
    std::ofstream(path) << test::shipped_table();
  const std::string path = (test::source_dir() / "scenes/measurements/synthetic_finger.csv").string();
  EXPECT_TRUE(test::bytes_of(path) == test::shipped_table());
  const ProfileFit fit = fit_profile(clean(read_measurements({path}, {}), {}), {});
  for (const auto& [number, known] : truth) {
    const auto k = static_cast<std::size_t>(number);
    ASSERT_EQ(fit.values[k].refusal, "") << pad_number_keys[k];
    EXPECT_NEAR(fit.values[k].value / known, 1, 0.05) << pad_number_keys[k];  // nine seconds of rubbing
    EXPECT_TRUE(fit.interval[k]) << pad_number_keys[k];
  }
}

TEST(ProfileFit, WritesAProfileThatReadsBack) {
  const ProfileFit fit = fitted({{1, 45, 45}, {1, 45, 45}, {1, 25, 45}, {1, 65, 45}, {1, 65, 0}}, 2);
  const std::string text = profile_text(fit, "a \"test\"");
  const PadProfile pad = read_profile(written("fitted.toml", text));
  EXPECT_EQ(pad.lateral_axis_m, of(fit, PadNumber::lateral_axis).value);
  EXPECT_EQ(pad.longitudinal_slope_per_deg, of(fit, PadNumber::longitudinal_slope).value);
  EXPECT_EQ(pad.mu_static, of(fit, PadNumber::mu_static).value);
  EXPECT_EQ(pad.v_min_m_per_s, of(fit, PadNumber::v_min).value);
  EXPECT_EQ(pad.vibration_hz, of(fit, PadNumber::vibration).value);
  EXPECT_EQ(pad.source, "a \"test\"");
  EXPECT_EQ(text, profile_text(fitted({{1, 45, 45}, {1, 45, 45}, {1, 25, 45}, {1, 65, 45}, {1, 65, 0}}, 2),
                               "a \"test\""));
}

TEST(ProfileFit, WithoutDirectionsGivesWhatNeedsNoAxes) {
  const std::string table = test::measured_table({{1, 45, 0}, {1, 45, 90}}, 1);
  const ProfileFit fit = fit_profile(
      clean(read_measurements({written("no_direction.csv", without_columns(table, {"dx"}))}, {}), {}), {});
  EXPECT_THAT(why(fit, PadNumber::lateral_axis), HasSubstr("dx, dy, dz missing"));
  EXPECT_THAT(why(fit, PadNumber::longitudinal_slope), HasSubstr("dx, dy, dz missing"));
  EXPECT_NEAR(of(fit, PadNumber::mu_static).value, 0.3, 0.003);
  EXPECT_NEAR(of(fit, PadNumber::mu_dynamic).value, 0.2, 0.002);
  EXPECT_GT(of(fit, PadNumber::stick_stiffness).value, 150);  // between those of the two axes of 0.8 of 2 mm
  EXPECT_LT(of(fit, PadNumber::stick_stiffness).value, 300);
  EXPECT_FALSE(fit.interval[0]);
  EXPECT_THAT(test::why_not([&] { read_profile(written("no_axes.toml", profile_text(fit, "x"))); }),
              HasSubstr("lateral_axis_m is missing: its fit says 'columns dx, dy, dz missing"));
}

TEST(ProfileFit, OneAngleGivesNoSlopes) {
  const ProfileFit fit = fitted({{1, 45, 45}, {1, 45, 45}}, 1);
  EXPECT_THAT(why(fit, PadNumber::lateral_slope), HasSubstr("one finger angle only"));
  EXPECT_NEAR(of(fit, PadNumber::lateral_axis).value, 0.8 * 2e-3, 2e-5);
  const ProfileFit steep = fitted({{1, 70, 45}, {1, 70, 45}}, 1);
  EXPECT_THAT(why(steep, PadNumber::lateral_axis), HasSubstr("more than 10 degrees from 45"));
}

TEST(ProfileFit, PushesThatNeverSlipGiveStiffnessAlone) {
  const ProfileFit fit = fitted({{1, 45, 45, 1e-3, 1.0}, {1, 25, 45, 1e-3, 1.0}}, 1);
  EXPECT_THAT(why(fit, PadNumber::mu_static), HasSubstr("no rupture"));
  EXPECT_THAT(why(fit, PadNumber::mu_dynamic), HasSubstr("no slip"));
  EXPECT_THAT(why(fit, PadNumber::v_min), HasSubstr("no slip that ends"));
  EXPECT_THAT(why(fit, PadNumber::vibration), HasSubstr("no slip lasts"));
  EXPECT_NEAR(of(fit, PadNumber::stick_stiffness).value, 150 / 0.8, 3);
}

TEST(ProfileFit, NormalForceAloneIsRefusedByTheMissingColumn) {
  const std::string table = without_columns(test::measured_table({{1, 45, 0}}, 1), {"fx_n", "fy_n"});
  const ProfileFit fit =
      fit_profile(clean(read_measurements({written("normal_only.csv", table)}, {}), {}), {});
  for (const PadValue& value : fit.values) EXPECT_THAT(value.refusal, HasSubstr("column fx_n missing"));
}

}  // namespace
}  // namespace fingerpad::profile_fit_test
