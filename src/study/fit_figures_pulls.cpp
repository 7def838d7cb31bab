// Figure 8: force against displacement.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "study/fit_figure_parts.hpp"
#include "study/stick_bearings.hpp"

namespace fingerpad {
namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

/// The angle that fig. 8 shows of each subject that was pushed along an axis: the one nearest to 45 degrees.
std::map<int, double> shown_angles(const FitPictureSource& source, std::size_t axis) {
  std::map<int, double> angles;
  for (const int subject : subjects_in(source.measurement))
    if (const auto angle = shown_angle_deg(source, subject, {axis})) angles[subject] = *angle;
  return angles;
}

/// Whether a trial is one of those that fig. 8 shows of an axis.
bool is_shown(const FitPictureSource& source, std::size_t trial, std::size_t axis,
              const std::map<int, double>& angles) {
  const MeasuredTrial& own = source.measurement.trials[trial];
  const auto angle = angles.find(own.subject);
  return angle != angles.end() && std::abs(own.inclination_deg - angle->second) <= alike_deg &&
         is_pushed(source, trial, axis);
}

void add_pulls(const FitPictureSource& source, std::size_t axis, ChartPanel& panel) {
  const std::map<int, double> angles = shown_angles(source, axis);
  std::map<int, ChartCurve> subjects;
  std::map<int, std::size_t> samples;
  for (const StickPath& path : source.stick.paths) {
    const MeasuredTrial& trial = source.measurement.trials[path.trial];
    constexpr std::size_t most_samples = 6000;
    if (!is_shown(source, path.trial, axis, angles)) continue;
    if ((samples[trial.subject] += path.force_n.size()) > most_samples) continue;
    const auto number = static_cast<int>(place_of(source, trial.subject));
    auto& curve = subjects
                      .try_emplace(trial.subject, ChartCurve{fmt::format("subject {}", trial.subject),
                                                             {number, Dash::solid, Marker::none, 0.7},
                                                             {},
                                                             {}})
                      .first->second;
    for (std::size_t i = 0; i < path.force_n.size(); ++i) {
      curve.x.push_back(1e3 * path.displacement_m[i][static_cast<Eigen::Index>(axis)]);
      curve.y.push_back(path.force_n[i][static_cast<Eigen::Index>(axis)]);
    }
    curve.x.push_back(no_value);
    curve.y.push_back(no_value);
  }
  for (auto& [subject, curve] : subjects) panel.curves.push_back(std::move(curve));
}

/// Along which lines that was pushed which fig. 8 shows of an axis.
PushedLines shown_lines(const FitPictureSource& source, std::size_t axis) {
  const std::map<int, double> angles = shown_angles(source, axis);
  std::vector<const StickPath*> shown;
  for (const StickPath& path : source.stick.paths)
    if (is_shown(source, path.trial, axis, angles)) shown.push_back(&path);
  return pushed_lines(shown);
}

/// The load, the reach and the angle of what fig. 8 shows along an axis.
struct ShownPulls {
  double load_n = 0, reach_m = 0, angle_deg = 0;
};

ShownPulls shown_pulls(const FitPictureSource& source, std::size_t axis, const ChartPanel& panel) {
  ShownPulls shown;
  const std::map<int, double> angles = shown_angles(source, axis);
  double count = 0;
  for (std::size_t k = 0; k < source.measurement.trials.size(); ++k) {
    const MeasuredTrial& trial = source.measurement.trials[k];
    if (!is_shown(source, k, axis, angles)) continue;
    for (const double n : trial.normal_force_n) shown.load_n += n;
    shown.angle_deg += angle_deg(trial) * static_cast<double>(trial.normal_force_n.size());
    count += static_cast<double>(trial.normal_force_n.size());
  }
  for (const ChartCurve& curve : panel.curves)
    for (const double x_mm : curve.x)
      if (std::isfinite(x_mm)) shown.reach_m = std::max(shown.reach_m, 1e-3 * std::abs(x_mm));
  shown.load_n /= count;
  shown.angle_deg /= count;
  return shown;
}

/// The fitted spring over what is shown, at its mean load and angle: of the third order, where its cubic
/// share is told. It ends where stick does.
void add_spring(const FitPictureSource& source, std::size_t axis, ChartPanel& panel) {
  const ShownPulls shown = shown_pulls(source, axis, panel);
  const bool has_direction = source.measurement.trials[source.stick.paths[0].trial].has_direction;
  const double stiffness = fitted_number(source.fit, PadNumber::stick_stiffness),
               mu_static = fitted_number(source.fit, PadNumber::mu_static),
               axis_m = fitted_axes_m(source.fit, shown.angle_deg)[static_cast<Eigen::Index>(axis)];
  const double cubic = fitted_number(
      source.fit, axis == 0 ? PadNumber::lateral_cubic_share : PadNumber::longitudinal_cubic_share);
  const bool has_end = std::isfinite(axis_m) && std::isfinite(mu_static);
  if (!has_end && (has_direction || !std::isfinite(stiffness))) return;
  constexpr int points = 40;
  const double share = has_end && std::isfinite(cubic) ? cubic : 0,
               end_m = has_end ? axis_m : mu_static / stiffness,
               reach_m = std::isfinite(end_m) ? std::min(shown.reach_m, end_m) : shown.reach_m;
  ChartCurve curve{
      fmt::format("fitted, at {}{:.2g} N",
                  has_direction ? fmt::format("{:.0f} deg and ", shown.angle_deg) : "", shown.load_n),
      {palette::ink, Dash::dashed, Marker::none, 1.3},
      {},
      {}};
  for (int k = -points; k <= points; ++k) {
    const double x_m = reach_m * k / points, rho = x_m / axis_m;
    const double ratio = has_end ? mu_static * rho * (1 - share + share * rho * rho) : stiffness * x_m;
    curve.x.push_back(1e3 * x_m);
    curve.y.push_back(-shown.load_n * ratio);
  }
  panel.curves.push_back(std::move(curve));
}

}  // namespace

Chart force_displacement_figure(const FitPictureSource& source) {
  const std::string title = "Force against displacement in stick (paper, fig. 8)";
  if (source.stick.paths.empty()) return refused_figure(title, "no stick was found");
  Chart chart{"", title, {}, 2, {}};
  const bool has_axes = source.measurement.trials[source.stick.paths[0].trial].has_direction;
  const std::vector<int> subjects = subjects_in(source.measurement);
  std::string bearings;
  if (has_axes)
    chart.notes.push_back(
        fmt::format("each subject's finger at the angle to the plate nearest to 45 deg of its pushes{}",
                    subjects.size() > 1 ? "; fitted: the profile's spring, of all subjects" : ""));
  for (std::string& note : refusal_notes(
           source.fit, {PadNumber::stick_stiffness, PadNumber::longitudinal_stiffness}, note_of_two_columns))
    if (has_axes || note.find("longitudinal") == std::string::npos) chart.notes.push_back(std::move(note));
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const char* names[2][2] = {{"tangent axis 1", "tangent axis 2"}, {"lateral", "longitudinal"}};
    ChartPanel panel{names[has_axes ? 1 : 0][axis],
                     "displacement from the stick centre [mm]",
                     "tangential force on the finger [N]",
                     false,
                     false,
                     {}};
    add_pulls(source, axis, panel);
    for (const int subject : subjects)
      if (!shown_angle_deg(source, subject, {axis}))
        add_note(fmt::format("subject {} is not pushed {}", subject, push_words[axis]), note_of_two_columns,
                 chart);
    if (panel.curves.empty()) continue;
    add_spring(source, axis, panel);
    if (has_axes)
      bearings += fmt::format("{} {} {}", bearings.empty() ? "" : ";", panel.title,
                              shown_lines(source, axis).words());
    chart.panels.push_back(std::move(panel));
  }
  if (chart.panels.empty()) return refused_figure(title, "no trial is pushed along an axis");
  if (has_axes)
    chart.notes.insert(chart.notes.begin() + 1,
                       fmt::format("pushes (0 deg: across the finger, 90 deg: along it):{}", bearings));
  chart.columns = static_cast<int>(chart.panels.size());
  return chart;
}

}  // namespace fingerpad
