// Figures 5 and 6, axes against the finger's angle, and 8, force against displacement.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "study/fit_figures.hpp"

namespace fingerpad {
namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();
constexpr Marker subject_markers[] = {Marker::disc,    Marker::square, Marker::triangle,
                                      Marker::diamond, Marker::ring,   Marker::cross};

/// a/a45 = 1 - s (alpha - 45) over the measured angles, and a little beyond.
ChartCurve slope_line(std::string name, const CurveStyle& style, double slope_per_deg, double from_deg,
                      double to_deg) {
  return {std::move(name),
          style,
          {from_deg, to_deg},
          {1 - slope_per_deg * (from_deg - 45), 1 - slope_per_deg * (to_deg - 45)}};
}

/// Points of each subject with a mark of its own.
void add_axis_points(const FitPictureSource& source, std::size_t axis, ChartPanel& panel) {
  std::map<int, ChartCurve> subjects;
  for (const TrialAxes& axes : source.stick.axes) {
    const MeasuredTrial& trial = source.measurement.trials[axes.trial];
    if (!std::isfinite(axes.axis_m[axis])) continue;
    const auto number = subjects.size();
    auto& curve = subjects
                      .try_emplace(trial.subject,
                                   ChartCurve{fmt::format("subject {}", trial.subject),
                                              {static_cast<int>(number), Dash::none,
                                               subject_markers[number % std::size(subject_markers)], 1.2},
                                              {},
                                              {}})
                      .first->second;
    curve.x.push_back(trial.inclination_deg);
    curve.y.push_back(axes.axis_m[axis] / subject_axes_m(source.measurement, source.fit, source.stick.axes,
                                                         trial.subject, 45)[static_cast<Eigen::Index>(axis)]);
  }
  for (auto& [subject, curve] : subjects) panel.curves.push_back(std::move(curve));
}

ChartPanel axis_panel(const FitPictureSource& source, std::size_t axis, double from_deg, double to_deg) {
  const PadNumber slope = axis == 0 ? PadNumber::lateral_slope : PadNumber::longitudinal_slope;
  const double slope_per_deg = fitted_number(source.fit, slope);
  ChartPanel panel{axis == 0 ? "lateral axis a" : "longitudinal axis b",
                   "finger against the plate [deg]",
                   "axis over its own at 45 deg [1]",
                   false,
                   false,
                   {}};
  panel.y_from_zero = true;
  add_axis_points(source, axis, panel);
  if (!std::isfinite(slope_per_deg)) return panel;
  panel.curves.push_back(
      slope_line(fmt::format("{} = 1 - {:.4g} (angle - 45)", axis == 0 ? "a" : "b", slope_per_deg),
                 {palette::ink, Dash::solid, Marker::none, 1.3}, slope_per_deg, from_deg, to_deg));
  if (const auto& both = source.fit.interval[static_cast<std::size_t>(slope)]) {
    for (const double limit : {both->first, both->second})
      panel.curves.push_back(slope_line(limit == both->first ? "95 % of the slope" : "",
                                        {palette::grey, Dash::dashed, Marker::none, 1}, limit, from_deg,
                                        to_deg));
  }
  return panel;
}

/// The trials that fig. 8 shows: a subject's at the angle nearest to 45 degrees.
std::map<int, double> shown_angles(const Measurement& measurement) {
  std::map<int, double> angles;
  for (const MeasuredTrial& trial : measurement.trials) {
    double& angle = angles.try_emplace(trial.subject, trial.inclination_deg).first->second;
    if (std::abs(trial.inclination_deg - 45) < std::abs(angle - 45)) angle = trial.inclination_deg;
  }
  return angles;
}

void add_pulls(const FitPictureSource& source, Eigen::Index axis, ChartPanel& panel) {
  const std::map<int, double> angles = shown_angles(source.measurement);
  std::map<int, ChartCurve> subjects;
  std::map<int, std::size_t> samples;
  for (const StickPath& path : source.stick.paths) {
    const MeasuredTrial& trial = source.measurement.trials[path.trial];
    constexpr double alike_deg = 4;
    constexpr std::size_t most_samples = 6000;
    if (std::abs(trial.inclination_deg - angles.at(trial.subject)) > alike_deg) continue;
    if ((samples[trial.subject] += path.force_n.size()) > most_samples) continue;
    const auto number = static_cast<int>(subjects.size());
    auto& curve = subjects
                      .try_emplace(trial.subject, ChartCurve{fmt::format("subject {}", trial.subject),
                                                             {number, Dash::solid, Marker::none, 0.7},
                                                             {},
                                                             {}})
                      .first->second;
    for (std::size_t i = 0; i < path.force_n.size(); ++i) {
      curve.x.push_back(1e3 * path.displacement_m[i][axis]);
      curve.y.push_back(path.force_n[i][axis]);
    }
    curve.x.push_back(no_value);
    curve.y.push_back(no_value);
  }
  for (auto& [subject, curve] : subjects) panel.curves.push_back(std::move(curve));
}

/// The fitted spring at the mean load of what is shown, over what is shown.
void add_spring(const FitPictureSource& source, Eigen::Index axis, ChartPanel& panel) {
  double load_n = 0, count = 0, reach_mm = 0;
  for (const MeasuredTrial& trial : source.measurement.trials) {
    for (const double n : trial.normal_force_n) load_n += n;
    count += static_cast<double>(trial.normal_force_n.size());
  }
  for (const ChartCurve& curve : panel.curves)
    for (const double x : curve.x)
      if (std::isfinite(x)) reach_mm = std::max(reach_mm, std::abs(x));
  const double mu_static = fitted_number(source.fit, PadNumber::mu_static);
  const double axis_m = fitted_axes_m(source.fit, 45)[axis];
  const double slope =
      std::isfinite(axis_m) ? mu_static / axis_m : fitted_number(source.fit, PadNumber::stick_stiffness);
  if (!std::isfinite(slope) || !(count > 0)) return;
  const double force_n = slope * load_n / count * 1e-3 * reach_mm;
  panel.curves.push_back({fmt::format("fitted at 45 deg and {:.2g} N", load_n / count),
                          {palette::ink, Dash::dashed, Marker::none, 1.3},
                          {-reach_mm, reach_mm},
                          {force_n, -force_n}});
}

}  // namespace

Chart normalised_axes_figure(const FitPictureSource& source) {
  const std::string title = "Axes of the stick ellipse against the finger's angle (paper, figs. 5 and 6)";
  double least_deg = 90, most_deg = 0;
  for (const MeasuredTrial& trial : source.measurement.trials) {
    if (!trial.has_direction) continue;
    least_deg = std::min(least_deg, trial.inclination_deg);
    most_deg = std::max(most_deg, trial.inclination_deg);
  }
  if (least_deg > most_deg)
    return {"figure5_6", title, {"no finger direction: the finger's angle and axes are not known"}, 1, {}};
  constexpr double beyond_deg = 5;
  Chart chart{"figure5_6", title, {"each subject weighs the same in the lines, whatever its samples"}, 2, {}};
  for (const std::size_t axis : {0, 1})
    chart.panels.push_back(axis_panel(source, axis, least_deg - beyond_deg, most_deg + beyond_deg));
  return chart;
}

Chart force_displacement_figure(const FitPictureSource& source) {
  const std::string title = "Force against displacement in stick (paper, fig. 8)";
  if (source.stick.paths.empty()) return {"figure8", title, {"no stick was found"}, 1, {}};
  Chart chart{"figure8", title, {"finger at the angle nearest to 45 deg"}, 2, {}};
  const bool has_axes = source.measurement.trials[source.stick.paths[0].trial].has_direction;
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    const char* names[2][2] = {{"x", "y"}, {"lateral", "longitudinal"}};
    ChartPanel panel{names[has_axes ? 1 : 0][axis],
                     "displacement from the stick centre [mm]",
                     "tangential force on the finger [N]",
                     false,
                     false,
                     {}};
    add_pulls(source, axis, panel);
    add_spring(source, axis, panel);
    chart.panels.push_back(std::move(panel));
  }
  return chart;
}

}  // namespace fingerpad
