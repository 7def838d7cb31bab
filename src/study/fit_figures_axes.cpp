// Figures 5 and 6: axes against the finger's angle.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "study/fit_figure_parts.hpp"

namespace fingerpad {
namespace {

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
    const std::size_t number = place_of(source, trial.subject);
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

/// Subjects whose stick along an axis was seen at one angle of the finger alone.
std::vector<int> subjects_of_one_angle(const FitPictureSource& source, std::size_t axis) {
  std::map<int, MeasuredAngles> angles;
  for (const TrialAxes& axes : source.stick.axes) {
    const MeasuredTrial& trial = source.measurement.trials[axes.trial];
    if (!std::isfinite(axes.axis_m[axis])) continue;
    MeasuredAngles& of = angles[trial.subject];
    of.least_deg = std::min(of.least_deg, trial.inclination_deg);
    of.most_deg = std::max(of.most_deg, trial.inclination_deg);
  }
  std::vector<int> subjects;
  for (const auto& [subject, of] : angles)
    if (of.most_deg - of.least_deg <= alike_deg) subjects.push_back(subject);
  return subjects;
}

/// Says whose points stand where they do because an axis is divided by itself.
/// @param drawn  the axes that have a panel
void tell_one_angle(const FitPictureSource& source, const std::vector<std::size_t>& drawn,
                    std::size_t most_letters, Chart& chart) {
  const std::vector<int> subjects[] = {subjects_of_one_angle(source, 0), subjects_of_one_angle(source, 1)};
  const bool are_alike = subjects[0] == subjects[1];
  for (const std::size_t axis : drawn) {
    if (subjects[axis].empty() || (are_alike && axis != drawn.front())) continue;
    const bool is_one = subjects[axis].size() == 1;
    add_note(fmt::format(
                 "subject{} {} {} pushed{} at one angle alone: by construction the mean of {} points stands "
                 "on the line (at 1 where none is drawn), and tells nothing of how the axis changes",
                 is_one ? "" : "s", fmt::join(subjects[axis], ", "), is_one ? "was" : "were",
                 are_alike ? "" : std::string(" ") + push_words[axis], is_one ? "its" : "each one's"),
             most_letters, chart);
  }
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
  panel.curves.push_back(slope_line(fmt::format("{} = 1 {} {:.4g} (angle - 45)", axis == 0 ? "a" : "b",
                                                slope_per_deg < 0 ? '+' : '-', std::abs(slope_per_deg)),
                                    {palette::ink, Dash::solid, Marker::none, 1.3}, slope_per_deg, from_deg,
                                    to_deg));
  if (const auto& both = source.fit.interval[static_cast<std::size_t>(slope)]) {
    for (const double limit : {both->first, both->second})
      panel.curves.push_back(slope_line(limit == both->first ? "95 % of the slope" : "",
                                        {palette::grey, Dash::dashed, Marker::none, 1}, limit, from_deg,
                                        to_deg));
  }
  return panel;
}

}  // namespace

Chart normalised_axes_figure(const FitPictureSource& source) {
  const std::string title = "Axes of the stick ellipse against the finger's angle (paper, figs. 5 and 6)";
  const MeasuredAngles measured = measured_angles(source.measurement);
  if (!measured.are_known())
    return refused_figure(title, "no finger direction: the finger's angle and axes are not known");
  constexpr double beyond_deg = 5;
  Chart chart{"", title, {"each subject weighs the same in the lines, whatever its samples"}, 2, {}};
  const auto refused = [&](std::size_t most_letters) {
    return refusal_notes(source.fit,
                         {PadNumber::lateral_axis, PadNumber::longitudinal_axis, PadNumber::lateral_slope,
                          PadNumber::longitudinal_slope},
                         most_letters);
  };
  std::vector<std::size_t> drawn;
  for (const std::size_t axis : {0, 1}) {
    const Vec2 axes_m = fitted_axes_m(source.fit, 45);
    if (!std::isfinite(axes_m[static_cast<Eigen::Index>(axis)])) continue;
    drawn.push_back(axis);
    chart.panels.push_back(
        axis_panel(source, axis, measured.least_deg - beyond_deg, measured.most_deg + beyond_deg));
  }
  if (chart.panels.empty())
    return refused_figure(title, fmt::format("{}", fmt::join(refused(std::string::npos), "; ")));
  chart.columns = static_cast<int>(chart.panels.size());
  tell_one_angle(source, drawn, chart.columns == 1 ? note_of_one_column : note_of_two_columns, chart);
  for (std::string& note : refused(chart.columns == 1 ? note_of_one_column : note_of_two_columns))
    chart.notes.push_back(std::move(note));
  return chart;
}

}  // namespace fingerpad
