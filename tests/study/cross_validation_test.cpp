#include "study/cross_validation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "study/fit_figures.hpp"
#include "study/fit_report.hpp"
#include "study/measurement_reader.hpp"
#include "study/pad_run.hpp"
#include "support/pad_measurement.hpp"
#include "support/paths.hpp"
#include "support/round_measurement.hpp"
#include "support/shell.hpp"

namespace fingerpad::cross_validation_test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Two subjects at three angles, one round of a second each.
std::vector<test::KnownTrial> few_trials() {
  std::vector<test::KnownTrial> trials;
  for (const int subject : {1, 3})
    for (const double angle : {25.0, 45.0, 65.0}) trials.push_back({subject, angle, 45, 0.04, 0.7, 1.5, 1});
  return trials;
}

Measurement measured(const std::vector<test::KnownTrial>& trials) {
  const std::string path = (test::scratch_dir() / "rubs.csv").string();
  std::ofstream(path) << test::measured_table(trials, 3);
  return clean(read_measurements({path}, {}), {});
}

TEST(CrossValidation, AFittedPadLeavesLessOfTrialsItHasNotSeen) {
  const CrossValidation checked = cross_validate(measured(few_trials()), {});
  ASSERT_EQ(checked.refusal, "");
  ASSERT_EQ(checked.trials.size(), 6u);  // each once
  // The known pad's spring is 150 to 190 1/m, the built-in one's 1000; friction is the same, so that all of
  // the gain is the pad's. What is left is the noise of sensors, the slip's vibration and the subjects' own
  // sizes.
  EXPECT_LT(checked.fitted_rms_n, 0.6 * checked.built_in_rms_n);
  EXPECT_LT(checked.fitted_rms_n, 0.25 * checked.measured_rms_n);
  EXPECT_NEAR(checked.own_friction_rms_n / checked.built_in_rms_n, 1, 0.1);
  for (const HeldOutTrial& trial : checked.trials)
    EXPECT_LT(trial.fitted_rms_n, trial.built_in_rms_n) << trial.name;
  EXPECT_THAT(cross_validation_words(checked), HasSubstr("trials that a fit has not seen (6 of them)"));
  EXPECT_EQ(cross_validation_table(checked).rows.size(), 6u);
}

TEST(CrossValidation, ATrialUnlikeTheOthersIsForetoldBadly) {
  std::string table = "t_s,x_m,y_m,z_m,fx_n,fy_n,fz_n,dx,dy,dz,subject,trial\n";
  RandomStream random(5);
  for (const int number : {1, 2, 3, 4})
    table += test::round_rows({1, number, number == 4 ? 2.4 : 0.8, 45, true, 1.2}, random);
  const std::string path = (test::scratch_dir() / "cycloids.csv").string();
  std::ofstream(path) << table;
  const Measurement measurement = clean(read_measurements({path}, {}), {});
  const CrossValidation checked = cross_validate(measurement, {});
  ASSERT_EQ(checked.trials.size(), 4u);
  const auto odd = std::find_if(checked.trials.begin(), checked.trials.end(),
                                [](const HeldOutTrial& trial) { return trial.name.ends_with("trial 4"); });
  ASSERT_NE(odd, checked.trials.end());
  Measurement alone;
  alone.trials = {measurement.trials.back()};
  const MeasuredTrial& trial = alone.trials.front();
  const std::vector<Vec2> own_n =
      pad_force_n(trial, stick_segments(trial), fitted_pad(fit_profile(alone, {})));
  double squares = 0;
  for (std::size_t i = 0; i < own_n.size(); ++i)
    squares += (own_n[i] - trial.normal_force_n[i] * trial.force_ratio[i]).squaredNorm();
  // Its own pad, three times as large as that of the others, would tell it well.
  EXPECT_GT(odd->fitted_rms_n, 1.5 * std::sqrt(squares / static_cast<double>(own_n.size())));
}

TEST(CrossValidation, OneTrialForetellsNothing) {
  const Measurement one = measured({few_trials().front()});
  const CrossValidation checked = cross_validate(one, {});
  EXPECT_THAT(checked.refusal, HasSubstr("two trials"));
  EXPECT_TRUE(checked.trials.empty());
  EXPECT_THAT(cross_validation_words(checked), HasSubstr("no cross-validation"));
}

TEST(CrossValidation, TheFittedPadRunsWithTheNumbersOfTheFit) {
  const ProfileFit fit = fit_profile(measured(few_trials()), {});
  ASSERT_TRUE(is_runnable(fit));
  const PadOnPlate pad = fitted_pad(fit);
  EXPECT_EQ(pad.mu_static, fit.values[static_cast<std::size_t>(PadNumber::mu_static)].value);
  EXPECT_EQ(pad.profile.lateral_axis_m, fit.values[static_cast<std::size_t>(PadNumber::lateral_axis)].value);
  ProfileFit no_slip = fit;
  no_slip.values[static_cast<std::size_t>(PadNumber::mu_dynamic)].refusal = "no slip";
  EXPECT_FALSE(is_runnable(no_slip));
}

TEST(CrossValidation, ATrialWithoutDirectionIsRunAtFortyFiveDegrees) {
  MeasuredTrial trial = measured({few_trials()[1]}).trials.front();
  const StickSegments segments = stick_segments(trial);
  trial.inclination_deg = 45;
  const std::vector<Vec2> told_n = pad_force_n(trial, segments, built_in_pad());
  trial.has_direction = false;
  trial.inclination_deg = 0;
  EXPECT_EQ(pad_force_n(trial, segments, built_in_pad()), told_n);
}

TEST(CrossValidation, AKnownDelayIsKnownToEachFold) {
  Measurement measurement = measured(few_trials());
  const double looked_for_n = cross_validate(measurement, {}).fitted_rms_n;
  measurement.knows_delay = true;
  EXPECT_NE(cross_validate(measurement, {}).fitted_rms_n, looked_for_n);
}

TEST(CrossValidation, TellsHowManyTrialsCouldNotBeForetold) {
  CrossValidation checked;
  checked.trials.resize(3);
  EXPECT_THAT(cross_validation_words(checked), Not(HasSubstr("left out")));
  checked.not_foretold = 2;
  EXPECT_THAT(cross_validation_words(checked), HasSubstr("2 of 5 trials are left out"));
}

TEST(FitReport, HasAPictureOfEachOfThePapersFigures) {
  const Measurement measurement = measured(few_trials());
  const ProfileFit fit = fit_profile(measurement, {});
  const FitReport report = fit_report(measurement, fit, {});
  std::vector<std::string> names;
  for (const Chart& chart : report.study.charts) {
    names.push_back(chart.name);
    for (const ChartPanel& panel : chart.panels) {
      EXPECT_FALSE(panel.x_label.empty() || panel.y_label.empty()) << chart.name;
      std::size_t points = 0;
      for (const ChartCurve& curve : panel.curves) {
        ASSERT_EQ(curve.x.size(), curve.y.size()) << chart.name << " " << curve.name;
        points += curve.x.size();
      }
      EXPECT_GT(points, 0u) << chart.name;
    }
  }
  std::vector<std::string> row_names;
  for (const FitFigure& row : fit_figure_rows) row_names.emplace_back(row.name);
  EXPECT_EQ(names, row_names);
  EXPECT_THAT(report.without_picture, testing::IsEmpty());
  const std::string page = fit_page(report, fit, {}, "fitted to <rubs>");
  EXPECT_THAT(page, HasSubstr("fitted to &lt;rubs&gt;"));
  EXPECT_THAT(page, HasSubstr("<img src=\"figure9.svg\""));
  EXPECT_THAT(page, HasSubstr("lateral_axis_m"));
}

TEST(FitReport, NormalisedAxesFallAlongTheFittedLines) {
  const Measurement measurement = measured(few_trials());
  const ProfileFit fit = fit_profile(measurement, {});
  const StickPicture stick = stick_picture(measurement, fit);
  const Chart chart = normalised_axes_figure({measurement, fit, stick});
  for (const ChartPanel& panel : chart.panels) {
    int points = 0;
    for (const ChartCurve& curve : panel.curves) {
      if (curve.style.dash != Dash::none) continue;
      for (std::size_t i = 0; i < curve.x.size(); ++i, ++points)
        EXPECT_NEAR(curve.y[i], 1 - 0.01 * (curve.x[i] - 45), 0.05)
            << panel.title;  // one trial of 1.5 s each
    }
    EXPECT_EQ(points, 6) << panel.title;
  }
}

/// FINGERPAD_WRITE_ROUNDS=FILE writes it.
TEST(FitReport, TheShippedRoundsAreOfTheKnownPad) {
  if (const char* path = std::getenv("FINGERPAD_WRITE_ROUNDS")) std::ofstream(path) << test::shipped_rounds();
  const std::string path = (test::source_dir() / "scenes/measurements/synthetic_rounds.csv").string();
  EXPECT_TRUE(test::bytes_of(path) == test::shipped_rounds());
  const ProfileFit fit = fit_profile(clean(read_measurements({path}, {}), {}), {});
  EXPECT_NEAR(fitted_axes_m(fit, 45).x() / 2e-3, 1, 0.05);
  EXPECT_NEAR(fitted_axes_m(fit, 45).y() / 1.6e-3, 1, 0.05);
}

TEST(FitReport, WhatTheDataCannotSupportHasAReasonAndNoPicture) {
  const Measurement nothing;
  const FitReport report = fit_report(nothing, fit_profile(nothing, {}), {});
  EXPECT_TRUE(report.study.charts.empty());
  EXPECT_EQ(report.without_picture.size(), 9u);
  EXPECT_THAT(report.without_picture[1], HasSubstr("no stick was found"));
}

}  // namespace
}  // namespace fingerpad::cross_validation_test
