#include "study/fit_figures.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "study/fit_report.hpp"
#include "support/effort.hpp"
#include "support/pad_measurement.hpp"

namespace fingerpad::fit_figures_test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// A fit with what its pictures are made from.
struct Pictured {
  Measurement measurement;
  ProfileFit fit;
  StickPicture stick;
  FitPictureSource source{measurement, fit, stick};

  explicit Pictured(const std::vector<test::KnownTrial>& trials, const test::KnownSensors& sensors = {},
                    const test::KnownFinger& finger = {}, const CleaningSettings& settings = {})
      : measurement(clean(test::known_measurement(trials, finger, sensors, 1), settings)),
        fit(fit_profile(measurement, {})),
        stick(stick_picture(measurement, fit)) {}
};

const ChartCurve* curve_of(const ChartPanel& panel, const std::string& name) {
  const auto found = std::find_if(panel.curves.begin(), panel.curves.end(),
                                  [&](const ChartCurve& curve) { return curve.name == name; });
  return found == panel.curves.end() ? nullptr : &*found;
}

std::vector<test::KnownTrial> rubs_of_two() {
  std::vector<test::KnownTrial> trials;
  for (const int subject : {1, 2})
    for (const double bearing_deg : {0.0, 90.0, 0.0}) trials.push_back({subject, 45, bearing_deg});
  return trials;
}

/// Of rubs_of_two(), which several tests look at.
const Pictured& pictured_rubs() {
  static const Pictured of(rubs_of_two());
  return of;
}

/// Windows are as long in time at either rate.
TEST(FitFigures, RingsStandWhereSlipEndsAtVMin) {
  for (const double rate_hz : test::cases({1000.0, 500.0})) {
    test::KnownSensors sensors;
    sensors.rate_hz = rate_hz;
    const Pictured of(rubs_of_two(), sensors);
    const double v_min = fitted_number(of.fit, PadNumber::v_min);
    ASSERT_NEAR(v_min, 0.1, 0.005) << rate_hz;
    const Chart chart = phase_change_figure(of.source);
    ASSERT_EQ(chart.panels.size(), 4U);
    const ChartCurve* rings = curve_of(chart.panels[0], "end of slip");
    ASSERT_NE(rings, nullptr);
    EXPECT_GE(rings->x.size(), 2U);
    // From sample to sample the finger slows by a hundredth of v_min, or two; noise moves it by as much.
    for (const double v : rings->y) EXPECT_NEAR(std::abs(v), v_min, 0.04 * v_min) << rate_hz;
    for (const ChartPanel& panel : chart.panels) {
      const ChartCurve* others = curve_of(panel, "end of slip");
      ASSERT_NE(others, nullptr) << panel.y_label;
      EXPECT_EQ(others->x, rings->x) << panel.y_label;
    }
    // The ratio begins to rise there: it is slip's, which vibrates by a hundredth.
    double mean_mu = 0;
    for (const double mu : curve_of(chart.panels[3], "end of slip")->y)
      mean_mu += std::abs(mu) / static_cast<double>(rings->y.size());
    EXPECT_NEAR(mean_mu, 0.2, 0.015) << rate_hz;
  }
}

TEST(FitFigures, LevelsStandEitherWayOfTheMotionAndHaveNames) {
  const Pictured& of = pictured_rubs();
  const Chart chart = phase_change_figure(of.source);
  const auto names = [](const ChartPanel& panel) {
    std::vector<std::string> found;
    for (const ChartLevel& level : panel.levels)
      if (!level.name.empty()) found.push_back(level.name.substr(0, level.name.find(' ')));
    return found;
  };
  EXPECT_THAT(names(chart.panels[0]), testing::ElementsAre("v_min"));
  EXPECT_THAT(names(chart.panels[3]), testing::ElementsAre("mu_s", "mu_d"));
  for (const ChartPanel& panel : {chart.panels[0], chart.panels[3]}) {
    double sum = 0;
    for (const ChartLevel& level : panel.levels) sum += level.y;
    EXPECT_EQ(sum, 0) << panel.y_label;
  }
}

TEST(FitFigures, ARefusedVMinIsNotDrawn) {
  const Pictured two({{1, 45, 0}, {1, 45, 90}});
  const std::string why = value_of(two.fit.values, PadNumber::v_min).refusal;
  ASSERT_THAT(why, HasSubstr("2 trials only"));
  const FitReport report = fit_report(two.measurement, two.fit, {});
  EXPECT_THAT(report.without_picture,
              Contains("Slip gives way to stick (paper, fig. 9): v_min_m_per_s refused: " + why));
  for (const Chart& chart : report.study.charts) EXPECT_NE(chart.name, "figure9");
  // Where the phases begin is shown all the same, without a word of v_min.
  const Chart phases = phase_boundaries_figure(two.source);
  ASSERT_EQ(phases.panels.size(), 3U);
  for (const ChartPanel& panel : phases.panels) EXPECT_EQ(curve_of(panel, "end of slip"), nullptr);
}

TEST(FitFigures, APictureSaysWhichOfItsNumbersAreRefused) {
  const Pictured two({{1, 45, 0}, {1, 45, 90}});
  const auto notes = [&two](Chart (*figure)(const FitPictureSource&)) {
    const Chart chart = figure(two.source);
    EXPECT_FALSE(chart.panels.empty()) << chart.name;
    std::string all;
    for (const std::string& note : chart.notes) all += note + " ";
    return all;
  };
  EXPECT_THAT(notes(normalised_axes_figure), HasSubstr("lateral_slope_per_deg"));
  EXPECT_THAT(notes(slip_spectrum_figure),
              HasSubstr("vibration_hz, vibration_bandwidth_hz refused: 2 trials"));
  const Chart spectrum = slip_spectrum_figure(two.source);
  EXPECT_EQ(spectrum.panels[0].curves.size(), 2U);  // no line where a vibration would be
  const Pictured& whole = pictured_rubs();
  EXPECT_THAT(slip_spectrum_figure(whole.source).panels[0].curves[2].name, HasSubstr("vibration, 8"));
  EXPECT_THAT(slip_spectrum_figure(whole.source).notes, testing::IsEmpty());
}

std::string all_notes(const Chart& chart) {
  std::string all;
  for (const std::string& note : chart.notes) all += note + " ";
  return all;
}

TEST(FitFigures, WhatTheLevelsOverOneTrialAreOfIsSaid) {
  const Pictured& two = pictured_rubs();
  const Pictured one({{2, 45, 0}, {2, 45, 90}, {2, 45, 45}});
  EXPECT_THAT(
      all_notes(phase_change_figure(two.source)),
      testing::ContainsRegex("v_min, mu_s, mu_d: the profile's \\(at 1.03 N\\), of all 2 subjects; the "
                             "strips: subject [12]'s alone"));
  EXPECT_THAT(all_notes(phase_change_figure(one.source)),
              HasSubstr("v_min, mu_s, mu_d: the profile's (at 1.03 N), of all trials"));
}

/// Rubs of one subject, at each angle across the finger, along it or both.
TEST(FitFigures, AnAngleIsDrawnAtWhichTheFingerWasPushedAlongTheAxis) {
  const Pictured far({{2, 45, 90}, {2, 45, 90}, {2, 53, 0}, {2, 53, 90}, {2, 53, 0}, {2, 45, 90}});
  const Chart ellipse = stick_ellipse_figure(far.source);
  ASSERT_EQ(ellipse.panels.size(), 1U);
  EXPECT_EQ(ellipse.panels[0].title, "subject 2, finger at 53 deg");
  EXPECT_EQ(ellipse.panels[0].curves.size(), 3U);
  const Chart pulls = force_displacement_figure(far.source);
  ASSERT_EQ(pulls.panels.size(), 2U);
  EXPECT_THAT(pulls.panels[0].curves.back().name, HasSubstr("fitted, at 53 deg"));
  EXPECT_THAT(pulls.panels[1].curves.back().name, HasSubstr("fitted, at 45 deg"));
  EXPECT_THAT(all_notes(ellipse) + all_notes(pulls), Not(HasSubstr("is not pushed")));
}

TEST(FitFigures, AnAxisThatNoTrialWasPushedAlongIsSaidToBeSo) {
  const Pictured parted({{2, 45, 90}, {2, 45, 90}, {2, 53, 0}, {2, 53, 0}, {2, 45, 90}, {2, 53, 0}});
  EXPECT_THAT(
      all_notes(stick_ellipse_figure(parted.source)),
      HasSubstr("subject 2 is not pushed across the finger at 45 deg: its ellipse's lateral axis is that "
                "of other angles"));
  const Pictured along({{1, 45, 90}, {1, 45, 90}, {1, 45, 90}, {2, 45, 0}, {2, 45, 90}, {2, 45, 0}});
  EXPECT_THAT(all_notes(stick_ellipse_figure(along.source)),
              HasSubstr("subject 1 is not pushed across the finger: no ellipse"));
  const Chart pulls = force_displacement_figure(along.source);
  EXPECT_THAT(all_notes(pulls), HasSubstr("subject 1 is not pushed across the finger"));
  EXPECT_EQ(curve_of(pulls.panels[0], "subject 1"), nullptr);
  EXPECT_NE(curve_of(pulls.panels[1], "subject 1"), nullptr);
  const Chart axes = normalised_axes_figure(along.source);
  for (const Chart* chart : {&pulls, &axes}) {
    const ChartCurve *lateral = curve_of(chart->panels[0], "subject 2"),
                     *longitudinal = curve_of(chart->panels[1], "subject 2");
    ASSERT_TRUE(lateral != nullptr && longitudinal != nullptr) << chart->name;
    EXPECT_EQ(lateral->style.colour, longitudinal->style.colour) << chart->name;
  }
  const Pictured none({{2, 45, 90}, {2, 45, 90}, {2, 45, 90}});
  ASSERT_EQ(force_displacement_figure(none.source).panels.size(), 1U);
  EXPECT_EQ(force_displacement_figure(none.source).panels[0].title, "longitudinal");
}

TEST(FitFigures, PointsThatStandOnTheLineByConstructionAreSaidToDoSo) {
  const auto notes_of = [](const std::vector<test::KnownTrial>& trials) {
    const Pictured of(trials);
    return all_notes(normalised_axes_figure(of.source));
  };
  EXPECT_THAT(notes_of({{2, 45, 0}, {2, 45, 90}, {2, 45, 45}}),
              HasSubstr("subject 2 was pushed at one angle alone: by construction the mean of its points "));
  EXPECT_THAT(notes_of({{1, 45, 45}, {1, 45, 45}, {2, 45, 45}, {3, 45, 45}, {3, 60, 45}, {3, 30, 45}}),
              HasSubstr("subjects 1, 2 were pushed at one angle alone"));
  EXPECT_THAT(notes_of({{2, 45, 0}, {2, 60, 0}, {2, 30, 0}, {2, 45, 90}, {2, 45, 90}}),
              HasSubstr("subject 2 was pushed along the finger at one angle alone"));
  EXPECT_THAT(notes_of({{2, 45, 45}, {2, 60, 45}, {2, 30, 45}}), Not(HasSubstr("by construction")));
}

TEST(FitFigures, NothingIsSaidOfPointsOfAnAxisThatHasNoPanel) {
  Pictured of({{2, 45, 0}, {2, 60, 0}, {2, 30, 0}, {2, 45, 90}, {2, 45, 90}});
  of.fit.values[static_cast<std::size_t>(PadNumber::longitudinal_axis)].refuse(RefusalReason::vague, "vague");
  const Chart chart = normalised_axes_figure(of.source);
  ASSERT_EQ(chart.panels.size(), 1U);
  EXPECT_THAT(all_notes(chart), Not(HasSubstr("by construction")));
}

/// By the law's forces both axes are told of one line, but how far stick reaches is seen along it alone.
TEST(FitFigures, AnEllipseIsDrawnOnlyThroughBearingsThatTellItsAxes) {
  const auto ellipse = [](double bearing_deg, double other_deg) {
    const Pictured of({{2, 45, bearing_deg}, {2, 45, bearing_deg}, {2, 45, other_deg}});
    EXPECT_TRUE(std::isfinite(fitted_number(of.fit, PadNumber::longitudinal_axis)));
    Chart chart = stick_ellipse_figure(of.source);
    const bool is_drawn = curve_of(chart.panels.at(0), "fitted to this subject") != nullptr;
    EXPECT_EQ(is_drawn, all_notes(chart).empty()) << all_notes(chart);
    return std::pair(is_drawn, std::move(chart));
  };
  const auto [one_is_drawn, one] = ellipse(45, 45);
  EXPECT_FALSE(one_is_drawn);
  EXPECT_THAT(all_notes(one), HasSubstr("subject 2: no ellipse, as pushes at 45 deg (0 deg: across the"));
  const ChartCurve* reach = curve_of(one.panels[0], "farthest tenth, by bearing");
  ASSERT_NE(reach, nullptr);
  EXPECT_EQ(reach->style.dash, Dash::none);
  EXPECT_EQ(reach->x.size(), 2U);  // there and back
  const auto [either_side_is_drawn, either_side] = ellipse(45, 135);
  EXPECT_FALSE(either_side_is_drawn);
  EXPECT_THAT(all_notes(either_side), HasSubstr("as pushes at 45 and 135 deg"));
  EXPECT_TRUE(ellipse(0, 90).first);
  EXPECT_TRUE(ellipse(15, 60).first);
}

TEST(FitFigures, TheBearingsOfThePushesOverTheirForceAreTold) {
  const Pictured slanted({{2, 45, 45}, {2, 45, 45}, {2, 45, 45}});
  EXPECT_THAT(all_notes(force_displacement_figure(slanted.source)),
              HasSubstr("pushes (0 deg: across the finger, 90 deg: along it): lateral at 45 deg; "
                        "longitudinal at 45 deg"));
  const Pictured both({{2, 45, 0}, {2, 45, 90}, {2, 45, 30}});
  EXPECT_THAT(all_notes(force_displacement_figure(both.source)),
              HasSubstr("lateral at 0 and 30 deg; longitudinal at 30 and 90 deg"));
}

/// Its stick centre rests on the axis that is told, not on one of all subjects.
TEST(FitFigures, StickOfAFingerThatIsPushedAlongOneAxisLiesAboutItsOwnCentre) {
  const Pictured of({{2, 45, 30}, {2, 45, 30}, {2, 45, 30}, {1, 45, 0}, {1, 45, 0}, {1, 45, 0}, {3, 45, 90}});
  const Chart chart = stick_ellipse_figure(of.source);
  ASSERT_EQ(chart.panels[1].title, "subject 1, finger at 45 deg");
  const ChartCurve* reach = curve_of(chart.panels[1], "farthest tenth, by bearing");
  ASSERT_NE(reach, nullptr);
  ASSERT_EQ(reach->x.size(), 2U) << "noise near the centre is no reach";
  for (const double x_mm : reach->x) EXPECT_NEAR(std::abs(x_mm), 1.6, 0.08);  // about two subjects': 1.9
}

/// What hides stick makes v_min a speed at which friction steps: no end of slip is marked there.
TEST(FitFigures, AVMinThatAStepTellsIsMarkedWhereItIsPassed) {
  test::KnownFinger slippery;
  slippery.pad = assumed_profile(0.15, 300);
  slippery.mu_dynamic = 0.12;
  std::vector<test::KnownTrial> trials;
  for (const int subject : {1, 2, 3}) {
    for (const double bearing_deg : {0.0, 90.0}) {
      for (const double frequency_hz : {0.5, 0.6})
        trials.push_back({subject, 45, bearing_deg, 0.06, frequency_hz, 5, 2});
    }
  }
  test::KnownSensors sensors;
  sensors.force_noise_n = 0.003;
  const Pictured of(trials, sensors, slippery);
  if (!of.fit.v_min_by_step) GTEST_SKIP() << value_of(of.fit.values, PadNumber::v_min).refusal;
  const Chart chart = phase_change_figure(of.source);
  const ChartCurve* rings = curve_of(chart.panels[0], "slows below v_min");
  ASSERT_NE(rings, nullptr);
  const double v_min = fitted_number(of.fit, PadNumber::v_min);
  for (const double v : rings->y) EXPECT_NEAR(std::abs(v), v_min, 0.03 * v_min);
  std::size_t falls = 0;
  bool was_faster = false;
  for (const double v : chart.panels[0].curves[0].y) {
    falls += was_faster && std::abs(v) < v_min ? 1 : 0;
    was_faster = std::abs(v) > 1.1 * v_min || (was_faster && std::abs(v) >= v_min);
  }
  EXPECT_GE(falls, 2U);
  EXPECT_EQ(rings->x.size(), falls);
}

TEST(FitFigures, EachBoundaryOfEveryTrialIsTabledWithItsReason) {
  const Pictured& of = pictured_rubs();
  const StudyTable table = boundaries_table(of.source);
  std::size_t boundaries = 0;
  for (std::size_t k = 0; k < of.measurement.trials.size(); ++k) {
    const StickSegments& segments = of.stick.segments[k];
    for (std::size_t i = 1; i < segments.phase.size(); ++i)
      boundaries += segments.phase[i] != segments.phase[i - 1] || segments.is_rupture[i] ||
                            of.measurement.trials[k].starts_anew[i]
                        ? 1
                        : 0;
    ++boundaries;  // where contact begins
  }
  EXPECT_EQ(table.rows.size(), boundaries);
  for (const auto& row : table.rows) EXPECT_NE(std::get<std::string>(row[4]), "");
}

/// What told the phases lies on its side of the border.
TEST(FitFigures, TheLocalStiffnessThatIsDrawnIsTheOneThatToldThePhases) {
  const Pictured& of = pictured_rubs();
  const MeasuredTrial& trial = of.measurement.trials.front();
  const StickSegments& segments = of.stick.segments.front();
  const std::vector<double> per_m = local_stiffness_per_m(trial, segments);
  long wrong = 0, told = 0, soft = 0;
  for (std::size_t i = 0; i < per_m.size(); ++i) {
    if (segments.phase[i] == PadPhase::unknown) continue;
    ++told;
    const bool is_stiff = per_m[i] > segments.border_per_m;
    wrong += segments.phase[i] == PadPhase::slip && (is_stiff || std::isnan(per_m[i])) ? 1 : 0;
    soft += segments.phase[i] == PadPhase::stick && !is_stiff ? 1 : 0;
  }
  EXPECT_GT(told, 1000);
  EXPECT_EQ(wrong, 0);
  EXPECT_LT(soft, told / 100);  // slip with little friction is taken for stick
}

TEST(FitFigures, TheFittedSpringIsBentAsItsCubicShareSays) {
  test::KnownFinger bent;
  bent.cubic_share = 0.5;
  const Pictured of(rubs_of_two(), {}, bent);
  const Chart chart = force_displacement_figure(of.source);
  const ChartCurve& spring = chart.panels[0].curves.back();
  ASSERT_THAT(spring.name, HasSubstr("fitted, at 45 deg and"));
  const std::size_t end = spring.x.size() - 1, half = end - end / 4;
  ASSERT_NEAR(spring.x[half] / spring.x[end], 0.5, 1e-9);
  const double share = fitted_number(of.fit, PadNumber::lateral_cubic_share);
  ASSERT_NEAR(share, 0.5, 0.1);
  EXPECT_LT(spring.y[half] / spring.y[end], 0.42);  // 0.5 of a straight one
}

}  // namespace
}  // namespace fingerpad::fit_figures_test
