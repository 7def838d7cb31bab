#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/count_words.hpp"
#include "base/number_text.hpp"
#include "view/comparison.hpp"

namespace fingerpad {
namespace {

/// Of more runs each is named once, above the first panel: further down its colour and dashes tell it.
constexpr std::size_t most_named_everywhere = 3;

/// Told apart by colour, and by dashes where colours are not seen.
CurveStyle style_of(std::size_t run) {
  constexpr Dash dashes[] = {Dash::solid, Dash::dashed, Dash::dotted, Dash::dash_dot};
  return {static_cast<int>(run), dashes[run % 4], Marker::none, 1.12};
}

/// Lengths are drawn in millimetres.
struct Shown {
  double factor = 1;
  std::string unit;
};
Shown shown_in(const std::string& unit) {
  if (unit == "m") return {1e3, "mm"};
  if (unit == "m/s") return {1e3, "mm/s"};
  if (unit == "rad") return {180 / 3.14159265358979323846, "deg"};
  return {1, unit};
}

std::vector<double> scaled_by(const std::vector<double>& values, double factor) {
  std::vector<double> out(values);
  for (double& value : out) value *= factor;
  return out;
}

std::string words_for_column(const std::string& name, const FrictionSense& friction) {
  if (name != "friction") return name;
  return fmt::format("friction along {} ({})", friction.along, friction.sign);
}

/// " N"; nothing for a pure number.
std::string unit_words(const std::string& unit) {
  return unit == "1" ? "" : " " + unit;
}

/// What is left: "RMS 0.25 N", "0.25 N at one tick alone, no RMS". A mean over one tick is that tick.
std::string left_words(const Residual& residual, double factor, const std::string& unit, int digits) {
  if (residual.ticks == 0) return "no tick at which both have a number";
  if (residual.ticks > 1)
    return fmt::format("RMS {}{}", rounded_text(factor * residual.rms, digits), unit_words(unit));
  const double left =
      *std::ranges::find_if(residual.values, [](double value) { return std::isfinite(value); });
  return fmt::format("{}{} at one tick alone, no RMS", rounded_text(factor * left, digits), unit_words(unit));
}

ChartPanel panel_of(const std::string& y_label, const std::string& short_y_label, Over over) {
  ChartPanel panel{"", std::string(abscissa_label(over)), y_label, false, false, {}};
  panel.short_y_label = short_y_label;
  return panel;
}

/// Beside a panel that is too low for more.
std::string short_words_for_column(const std::string& name, const FrictionSense& friction) {
  return name == "friction" && friction.along != "sliding" ? "friction " + friction.along : name;
}

void add_column_panels(Chart& chart, const Comparison& comparison, const std::string& name, Over over) {
  const auto of_name = [&](const auto& column) { return column.name == name; };
  const auto& of_first = comparison.runs[0].columns;
  const Shown shown = shown_in(std::find_if(of_first.begin(), of_first.end(), of_name)->unit);
  ChartPanel values =
      panel_of(fmt::format("{} [{}]", words_for_column(name, comparison.friction), shown.unit),
               fmt::format("{} [{}]", short_words_for_column(name, comparison.friction), shown.unit), over);
  values.y_from_zero = name == "friction";  // its sign says which way it acts
  const bool names_once = comparison.runs.size() > most_named_everywhere;
  for (std::size_t i = 0; i < comparison.runs.size(); ++i) {
    const ComparedRun& run = comparison.runs[i];
    const auto column = std::find_if(run.columns.begin(), run.columns.end(), of_name);
    const bool is_named = !names_once || chart.panels.empty();
    values.curves.push_back(
        {is_named ? run.name : "", style_of(i), run.x, scaled_by(column->values, shown.factor)});
  }
  chart.panels.push_back(std::move(values));
  if (comparison.runs.size() < 2) return;
  // Of what is above it, whatever room there is for words.
  ChartPanel left = panel_of(fmt::format("residual [{}]", shown.unit), "", over);
  for (const Residual& residual : comparison.residuals) {
    if (residual.column != name) continue;
    const std::string name = names_once ? "" : comparison.runs[residual.run].name + ": ";
    const std::string legend = name + left_words(residual, shown.factor, shown.unit, 4);
    left.curves.push_back(
        {legend, style_of(residual.run), residual.x, scaled_by(residual.values, shown.factor)});
  }
  left.levels.push_back({"", 0});  // within the panel, where nothing is left at all too
  chart.panels.push_back(std::move(left));
}

/// What all runs have in common, or else what their scenes are called: "bracket, knob, housing and 3 more".
std::string title_of(const std::vector<ComparedRun>& runs) {
  const auto same = [&](const ComparedRun& run) { return run.title == runs[0].title; };
  if (std::ranges::all_of(runs, same)) return runs[0].title;
  std::vector<std::string> names;
  for (const ComparedRun& run : runs)
    if (std::ranges::find(names, run.scene) == names.end()) names.push_back(run.scene);
  constexpr std::size_t most = 4;
  const std::size_t more = names.size() > most ? names.size() - most + 1 : 0;
  if (more > 0) names.resize(most - 1);
  const std::string last = more > 0 ? fmt::format("{} more", more) : names.back();
  if (more == 0) names.pop_back();
  return names.empty() ? last : fmt::format("{} and {}", fmt::join(names, ", "), last);
}

}  // namespace

Chart comparison_chart(const Comparison& comparison, Over over) {
  Chart chart;
  chart.stacked = true;
  chart.legend_rows = 8;  // of eight runs with long names
  chart.title = title_of(comparison.runs);
  chart.notes = comparison.notes;
  for (const std::string& name : comparison.columns) add_column_panels(chart, comparison, name, over);
  return chart;
}

std::vector<std::string> residual_words(const Comparison& comparison) {
  std::vector<std::string> words;
  for (const Residual& residual : comparison.residuals) {
    words.push_back(
        fmt::format("{}: {}, '{}' less '{}'{}", residual.column, left_words(residual, 1, residual.unit, 6),
                    comparison.runs[residual.run].name, comparison.runs[0].name,
                    residual.ticks > 1 ? fmt::format(", {}", count_words(residual.ticks, "tick")) : ""));
  }
  return words;
}

}  // namespace fingerpad
