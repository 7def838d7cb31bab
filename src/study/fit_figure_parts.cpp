#include "study/fit_figure_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace fingerpad {
namespace {

/// Parts words into lines of at most so many letters, at blanks.
void add_wrapped(std::string_view words, std::size_t most_letters, std::vector<std::string>& lines) {
  while (words.size() > most_letters) {
    const std::size_t blank = words.rfind(' ', most_letters);
    if (blank == std::string_view::npos) break;
    lines.emplace_back(words.substr(0, blank));
    words.remove_prefix(blank + 1);
  }
  lines.emplace_back(words);
}

}  // namespace

MeasuredAngles measured_angles(const Measurement& measurement) {
  MeasuredAngles angles;
  for (const MeasuredTrial& trial : measurement.trials) {
    if (!trial.has_direction) continue;
    angles.least_deg = std::min(angles.least_deg, trial.inclination_deg);
    angles.most_deg = std::max(angles.most_deg, trial.inclination_deg);
  }
  return angles;
}

bool is_pushed(const FitPictureSource& source, std::size_t trial, std::size_t axis) {
  return !source.measurement.trials[trial].has_direction ||
         std::isfinite(source.stick.axes[trial].axis_m[axis]);
}

std::optional<double> shown_angle_deg(const FitPictureSource& source, int subject,
                                      std::initializer_list<std::size_t> axes) {
  const std::vector<MeasuredTrial>& trials = source.measurement.trials;
  const auto pushes_at = [&](double angle_deg, std::size_t axis) {
    for (std::size_t k = 0; k < trials.size(); ++k)
      if (trials[k].subject == subject && std::abs(trials[k].inclination_deg - angle_deg) < alike_deg &&
          is_pushed(source, k, axis))
        return true;
    return false;
  };
  std::optional<double> nearest;
  for (const MeasuredTrial& trial : trials) {
    const double own_deg = trial.inclination_deg;
    if (trial.subject != subject || (nearest && !(std::abs(own_deg - 45) < std::abs(*nearest - 45))))
      continue;
    if (std::all_of(axes.begin(), axes.end(), [&](std::size_t axis) { return pushes_at(own_deg, axis); }))
      nearest = own_deg;
  }
  return nearest;
}

std::vector<int> subjects_in(const Measurement& measurement) {
  std::vector<int> subjects;
  for (const MeasuredTrial& trial : measurement.trials)
    if (std::find(subjects.begin(), subjects.end(), trial.subject) == subjects.end())
      subjects.push_back(trial.subject);
  return subjects;
}

std::size_t place_of(const FitPictureSource& source, int subject) {
  const std::vector<int> subjects = subjects_in(source.measurement);
  return static_cast<std::size_t>(std::find(subjects.begin(), subjects.end(), subject) - subjects.begin());
}

Vec2 main_way(const StickSegments& segments, const TrialSpan& span) {
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (std::size_t i = span.from; i < span.to; ++i)
    spread += segments.velocity_m_per_s[i] * segments.velocity_m_per_s[i].transpose();
  const double turn = 0.5 * std::atan2(2 * spread(0, 1), spread(0, 0) - spread(1, 1));
  return {std::cos(turn), std::sin(turn)};
}

std::vector<double> times_of(const MeasuredTrial& trial, const TrialSpan& span) {
  return {trial.t_s.begin() + static_cast<std::ptrdiff_t>(span.from),
          trial.t_s.begin() + static_cast<std::ptrdiff_t>(span.to)};
}

ChartPanel strip(const std::string& y_label, std::string short_label, int colour,
                 const std::vector<double>& t_s, std::vector<double> y) {
  ChartPanel panel{"", "time [s]", y_label, false, false, {}};
  panel.short_y_label = std::move(short_label);
  panel.curves.push_back(
      {y_label.substr(0, y_label.find(" [")), {colour, Dash::solid, Marker::none, 1.1}, t_s, std::move(y)});
  return panel;
}

Chart refused_figure(std::string title, std::string why) {
  return {"", std::move(title), {std::move(why)}, 1, {}};
}

void add_note(const std::string& words, std::size_t most_letters, Chart& chart) {
  add_wrapped(words, most_letters, chart.notes);
}

std::vector<std::string> refusal_notes(const ProfileFit& fit, std::initializer_list<PadNumber> numbers,
                                       std::size_t most_letters) {
  std::vector<std::pair<std::string, std::string>> reasons;  // which are refused for it
  for (const PadNumber number : numbers) {
    const std::string& why = value_of(fit.values, number).refusal;
    if (why.empty()) continue;
    const std::string key(pad_number_keys[static_cast<std::size_t>(number)]);
    bool is_told = false;
    for (auto& [reason, keys] : reasons) {
      if (reason != why) continue;
      keys += ", " + key;
      is_told = true;
    }
    if (!is_told) reasons.emplace_back(why, key);
  }
  std::vector<std::string> lines;
  for (const auto& [reason, keys] : reasons)
    add_wrapped(fmt::format("{} refused: {}", keys, reason), most_letters, lines);
  return lines;
}

}  // namespace fingerpad
