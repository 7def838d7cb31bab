#include <cmath>
#include <numbers>

#include "friction/law_table.hpp"
#include "study/bench_scene.hpp"
#include "study/stability_parts.hpp"
#include "study/stick_energy.hpp"

namespace fingerpad {
namespace {

constexpr double spring_per_m = 1000, first_n = 1;
constexpr double stretch_m = 0.9 * 0.3 / spring_per_m;

void by_load(StudyReport& report, ChartPanel& panel) {
  const std::vector<double> loads_n{0.25, 0.5, 1, 1.5, 2, 3, 4, 5};
  StudyTable table{
      "energy_by_load", {"law", "load_stretched_n", "load_released_n", "energy_on_finger_j", "rule_j"}, {}};
  ChartCurve rule{"k_f (n2 - n1) d^2/2", {5, Dash::dotted, Marker::none}, loads_n, {}};
  for (const double n : loads_n) rule.y.push_back(spring_per_m * (n - first_n) * stretch_m * stretch_m / 2);
  for (const LawEntry& law : law_table()) {
    const std::string name(law.name);
    ChartCurve series{name, law_style(name), loads_n, {}};
    for (std::size_t i = 0; i < loads_n.size(); ++i) {
      series.y.push_back(energy_of_cycle(
          {.law = name, .stretch_m = stretch_m, .stretched_n = first_n, .released_n = loads_n[i]}));
      table.rows.push_back({name, first_n, loads_n[i], series.y.back(), rule.y[i]});
    }
    panel.curves.push_back(std::move(series));
  }
  panel.curves.push_back(std::move(rule));
  report.tables.push_back(std::move(table));
}

void by_angle(StudyReport& report, ChartPanel& panel) {
  StudyTable table{
      "energy_by_angle", {"law", "angle_stretched_deg", "angle_released_deg", "energy_on_finger_j"}, {}};
  for (const std::string name : {"stick-slip", "finger-pad"}) {
    ChartCurve series{name, law_style(name), {}, {}};
    for (int deg = 0; deg <= 80; deg += 10) {
      // The pad at 45 deg stretched less than its smallest ellipse allows, so that tilting does not rupture
      // it.
      series.x.push_back(deg);
      series.y.push_back(energy_of_cycle({.law = name,
                                          .stretch_m = 0.5 * stretch_m,
                                          .stretched_n = first_n,
                                          .released_n = first_n,
                                          .stretched_rad = std::numbers::pi / 4,
                                          .released_rad = deg * std::numbers::pi / 180}));
      table.rows.push_back({name, 45.0, static_cast<double>(deg), series.y.back()});
    }
    panel.curves.push_back(std::move(series));
  }
  report.tables.push_back(std::move(table));
}

}  // namespace

void study_energy(StudyReport& report) {
  ChartPanel load{"load raised or lowered while stretched by 0.27 mm",
                  "normal force at release [N]",
                  "energy on the finger [J]",
                  false,
                  false,
                  {},
                  {}};
  ChartPanel angle{"finger raised or lowered while stretched by 0.135 mm",
                   "inclination at release [deg]",
                   "energy on the finger [J]",
                   false,
                   false,
                   {},
                   {}};
  by_load(report, load);
  by_angle(report, angle);
  report.charts.push_back(
      {"energy",
       "Energy that friction gives over a closed path",
       {"Stretched at 1 N and 45 deg, then load or angle changed at rest, then brought back to the start.",
        "Above zero the spring makes energy: a stiffness that scales with the load or the angle does, a "
        "fixed one never on this path."},
       1,
       {std::move(load), std::move(angle)}});
}

}  // namespace fingerpad
