// Figures of the stick region: 3, 4, 7.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "study/fit_figure_parts.hpp"
#include "study/stick_bearings.hpp"

namespace fingerpad {
namespace {

constexpr double gap = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t most_panels = 12;

/// How much of a trial's force goes round: the smaller spread of its components over the larger.
double roundness(const MeasuredTrial& trial) {
  Vec2 mean(0, 0);
  const auto count = static_cast<double>(trial.force_ratio.size());
  for (const Vec2& q : trial.force_ratio) mean += q / count;
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const Vec2& q : trial.force_ratio) spread += (q - mean) * (q - mean).transpose();
  const double half = spread.trace() / 2;
  const double apart =
      std::sqrt(std::max(0.0, half * half - spread(0, 0) * spread(1, 1) + spread(0, 1) * spread(1, 0)));
  return half + apart > 0 ? (half - apart) / (half + apart) : 0;
}

/// At most this many points of a curve, evenly chosen.
std::size_t thinning(std::size_t samples) {
  constexpr std::size_t most = 4000;
  return samples / most + 1;
}

ChartCurve ellipse_curve(std::string name, const CurveStyle& style, double a, double b) {
  constexpr int points = 120;
  ChartCurve curve{std::move(name), style, {}, {}};
  for (int i = 0; i <= points; ++i) {
    const double angle = 2 * std::numbers::pi * i / points;
    curve.x.push_back(a * std::cos(angle));
    curve.y.push_back(b * std::sin(angle));
  }
  return curve;
}

/// A subject's trials whose finger lay nearest to 45 degrees, to a few degrees.
double usual_angle_deg(const Measurement& measurement, int subject) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const MeasuredTrial& trial : measurement.trials)
    if (trial.subject == subject && std::abs(trial.inclination_deg - 45) < std::abs(nearest - 45))
      nearest = trial.inclination_deg;
  return nearest;
}

/// How far stick reaches by its bearing: points alone, as nothing is known of what lies between them.
ChartCurve averaged_reach(const std::vector<const StickPath*>& paths, std::string name,
                          const CurveStyle& style) {
  ChartCurve curve{std::move(name), style, {}, {}};
  for (const Vec2& reach_m : farthest_by_bearing_m(paths)) {
    curve.x.push_back(1e3 * reach_m.x());
    curve.y.push_back(1e3 * reach_m.y());
  }
  return curve;
}

/// Along which axes a subject's stick is pushed at the angle that is shown of it, and which it lacks.
std::vector<std::string> lacking_notes(const FitPictureSource& source, int subject, double angle_deg,
                                       const Vec2& axes_m) {
  constexpr const char* axis_names[] = {"lateral", "longitudinal"};
  std::vector<std::string> notes;
  for (const std::size_t axis : {0, 1}) {
    const std::vector<MeasuredTrial>& trials = source.measurement.trials;
    bool is_here = false, is_elsewhere = false;
    for (std::size_t k = 0; k < trials.size(); ++k) {
      if (trials[k].subject != subject || !is_pushed(source, k, axis)) continue;
      (std::abs(trials[k].inclination_deg - angle_deg) < alike_deg ? is_here : is_elsewhere) = true;
    }
    if (is_here) continue;
    if (is_elsewhere && axes_m.allFinite()) {
      notes.push_back(fmt::format(
          "subject {} is not pushed {} at {:.0f} deg: its ellipse's {} axis is that of other angles", subject,
          push_words[axis], angle_deg, axis_names[axis]));
    } else {
      notes.push_back(fmt::format("subject {} is not pushed {}{}: no ellipse", subject, push_words[axis],
                                  is_elsewhere ? fmt::format(" at {:.0f} deg", angle_deg) : ""));
    }
  }
  return notes;
}

/// Why no ellipse is drawn where both axes are told, but not by how far stick reaches.
std::string untold_ellipse_note(int subject, const PushedLines& lines) {
  return fmt::format(
      "subject {}: no ellipse, as pushes {} (0 deg: across the finger, 90 deg: along it) show how far it "
      "sticks there alone; which way their force points tells the profile's axes. Push across the finger and "
      "along it",
      subject, lines.words());
}

ChartCurve raw_paths(const std::vector<const StickPath*>& paths) {
  ChartCurve raw{"raw", {palette::sky_blue, Dash::solid, Marker::none, 0.6}, {}, {}};
  std::size_t samples = 0;
  for (const StickPath* path : paths) samples += path->displacement_m.size();
  const std::size_t every = thinning(samples);
  for (const StickPath* path : paths) {
    for (std::size_t i = 0; i < path->displacement_m.size(); i += every) {
      raw.x.push_back(1e3 * path->displacement_m[i].x());
      raw.y.push_back(1e3 * path->displacement_m[i].y());
    }
    raw.x.push_back(gap);
    raw.y.push_back(gap);
  }
  return raw;
}

}  // namespace

Chart force_loop_figure(const FitPictureSource& source) {
  const std::vector<MeasuredTrial>& trials = source.measurement.trials;
  if (trials.empty()) return refused_figure("Force of a fingertip", "no trial has contact");
  const auto slips = [&](const MeasuredTrial& one) {
    const auto& phase = source.stick.segments[static_cast<std::size_t>(&one - trials.data())].phase;
    constexpr double mostly = 0.25;
    return static_cast<double>(std::count(phase.begin(), phase.end(), PadPhase::slip)) >
           mostly * static_cast<double>(phase.size());
  };
  const bool any_slips = std::any_of(trials.begin(), trials.end(), slips);
  const auto score = [&](const MeasuredTrial& one) { return any_slips && !slips(one) ? -1 : roundness(one); };
  const auto trial = std::max_element(trials.begin(), trials.end(), [&](const auto& one, const auto& other) {
    return score(one) < score(other);
  });
  Chart chart{
      "", "The fingertip's way and the force on it (set-up of the paper's fig. 3)", {trial->name}, 2, {}};
  const CurveStyle style{palette::blue, Dash::solid, Marker::none, 0.8};
  ChartCurve way{"", style, {}, {}}, force{"", {palette::vermillion, Dash::solid, Marker::none, 0.8}, {}, {}};
  const std::size_t every = thinning(trial->position_m.size());
  for (std::size_t i = 0; i < trial->position_m.size(); i += every) {
    const Vec2 f = trial->normal_force_n[i] * trial->force_ratio[i];
    const bool parted = trial->starts_anew[i];
    way.x.push_back(parted ? gap : 1e3 * (trial->position_m[i].x() - trial->position_m[0].x()));
    way.y.push_back(parted ? gap : 1e3 * (trial->position_m[i].y() - trial->position_m[0].y()));
    force.x.push_back(parted ? gap : f.x());
    force.y.push_back(parted ? gap : f.y());
  }
  const std::string across = trial->has_direction ? "lateral" : "tangent axis 1",
                    along = trial->has_direction ? "longitudinal" : "tangent axis 2";
  ChartPanel place{"way", across + " [mm]", along + " [mm]", false, false, {std::move(way)}};
  ChartPanel pull{
      "tangential force on the finger", across + " [N]", along + " [N]", false, false, {std::move(force)}};
  place.equal_scales = pull.equal_scales = true;
  chart.panels = {std::move(place), std::move(pull)};
  return chart;
}

Chart stick_ellipse_figure(const FitPictureSource& source) {
  const std::string title = "Where the pad sticks (paper, fig. 4)";
  Chart chart{"", title, {}, 2, {}};
  std::vector<std::string> notes =
      refusal_notes(source.fit, {PadNumber::lateral_axis, PadNumber::longitudinal_axis, PadNumber::mu_static},
                    std::string::npos);
  const std::vector<int> subjects = subjects_in(source.measurement);
  for (const int subject : subjects) {
    const double angle_deg =
        shown_angle_deg(source, subject, {0, 1}).value_or(usual_angle_deg(source.measurement, subject));
    std::vector<const StickPath*> paths;
    for (const StickPath& path : source.stick.paths) {
      const MeasuredTrial& trial = source.measurement.trials[path.trial];
      if (trial.subject == subject && std::abs(trial.inclination_deg - angle_deg) < alike_deg)
        paths.push_back(&path);
    }
    if (paths.empty()) continue;
    if (chart.panels.size() == most_panels) {
      notes.push_back(fmt::format("the first {} of {} subjects", most_panels, subjects.size()));
      break;
    }
    const MeasuredTrial& first = source.measurement.trials[paths.front()->trial];
    ChartPanel panel{first.has_direction ? fmt::format("subject {}, finger at {:.0f} deg", subject, angle_deg)
                                         : fmt::format("subject {}", subject),
                     first.has_direction ? "lateral displacement from the stick centre [mm]"
                                         : "displacement from the stick centre, tangent axis 1 [mm]",
                     first.has_direction ? "longitudinal [mm]" : "tangent axis 2 [mm]",
                     false,
                     false,
                     {}};
    panel.equal_scales = true;
    panel.curves.push_back(raw_paths(paths));
    panel.curves.push_back(
        averaged_reach(paths, "farthest tenth, by bearing", {palette::blue, Dash::none, Marker::disc, 1}));
    const Vec2 axes_m = subject_axes_m(source.measurement, source.fit, source.stick.axes, subject, angle_deg);
    const std::vector<std::string> lacking = lacking_notes(source, subject, angle_deg, axes_m);
    const PushedLines lines = pushed_lines(paths);
    const bool tells = lines.tell_ellipse() || !lacking.empty();
    if (axes_m.allFinite() && !tells) notes.push_back(untold_ellipse_note(subject, lines));
    if (axes_m.allFinite() && tells)
      panel.curves.push_back(ellipse_curve("fitted to this subject",
                                           {palette::vermillion, Dash::dashed, Marker::none, 1.3},
                                           1e3 * axes_m.x(), 1e3 * axes_m.y()));
    notes.insert(notes.end(), lacking.begin(), lacking.end());
    chart.panels.push_back(std::move(panel));
  }
  if (chart.panels.empty()) return refused_figure(title, "no stick was found");
  chart.columns = chart.panels.size() == 1 ? 1 : 2;
  for (const std::string& note : notes)
    add_note(note, chart.columns == 1 ? note_of_one_column : note_of_two_columns, chart);
  return chart;
}

Chart normalised_ellipses_figure(const FitPictureSource& source) {
  const std::string title = "The normalised stick ellipse by the finger's angle (paper, fig. 7)";
  const Vec2 at45_m = fitted_axes_m(source.fit, 45);
  if (!at45_m.allFinite() || !std::isfinite(fitted_number(source.fit, PadNumber::lateral_slope)) ||
      !std::isfinite(fitted_number(source.fit, PadNumber::longitudinal_slope))) {
    const std::vector<std::string> why =
        refusal_notes(source.fit,
                      {PadNumber::lateral_axis, PadNumber::longitudinal_axis, PadNumber::lateral_slope,
                       PadNumber::longitudinal_slope},
                      std::string::npos);
    return refused_figure(title, fmt::format("{}", fmt::join(why, "; ")));
  }
  const MeasuredAngles measured = measured_angles(source.measurement);
  Chart chart{
      "",
      title,
      {fmt::format("over the lateral axis at 45 deg; measured from {:.0f} to {:.0f} deg, dashed beyond",
                   measured.least_deg, measured.most_deg)},
      1,
      {}};
  ChartPanel panel{"", "lateral [1]", "longitudinal [1]", false, false, {}};
  panel.equal_scales = true;
  int colour = 0;
  for (const double angle_deg : {15.0, 30.0, 45.0, 60.0, 75.0}) {
    const Vec2 axes = fitted_axes_m(source.fit, angle_deg) / at45_m.x();
    if (!(axes.minCoeff() > 0)) continue;
    panel.curves.push_back(
        ellipse_curve(fmt::format("{:.0f} deg", angle_deg),
                      {colour++, measured.hold(angle_deg) ? Dash::solid : Dash::dashed, Marker::none, 1.3},
                      axes.x(), axes.y()));
  }
  chart.panels.push_back(std::move(panel));
  return chart;
}

}  // namespace fingerpad
