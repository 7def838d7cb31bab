#include <functional>

#include "study/stability_parts.hpp"
#include "study/stable_stiffness.hpp"

namespace fingerpad {
namespace {

/// One sweep: the wall's number on the x axis, and a panel of what was found.
struct Sweep {
  std::string name;
  std::string x_label;
  std::vector<double> values;
  bool log_x = true;
  std::function<HeldWall(double)> wall;
};

constexpr CurveStyle touched{5, Dash::none, Marker::ring};
constexpr CurveStyle eigenvalues{6, Dash::solid, Marker::none, 4};
constexpr CurveStyle colgate{1, Dash::dashed, Marker::none};
constexpr CurveStyle abbott{3, Dash::dotted, Marker::none};
constexpr CurveStyle thumb{2, Dash::dash_dot, Marker::none, 0.8};

std::vector<Sweep> sweeps() {
  const std::vector<double> rates_hz{250, 500, 1000, 2000, 4000, 10000};
  std::vector<Sweep> all;
  for (const int delay : {0, 2}) {
    all.push_back({"rate, delay of " + std::to_string(delay) + " ticks", "rate [Hz]", rates_hz, true,
                   [delay](double hz) { return HeldWall{.tick_s = 1 / hz, .delay_ticks = delay}; }});
  }
  all.push_back({"delay", "delay [ticks]", {0, 1, 2, 3, 4, 6, 8}, false, [](double ticks) {
                   return HeldWall{.delay_ticks = static_cast<int>(ticks)};
                 }});
  all.push_back({"damping of hand and device", "b [N s/m]", {0.1, 0.2, 0.5, 1, 2, 5}, true, [](double b) {
                   return HeldWall{.damping_n_s_per_m = b};
                 }});
  all.push_back(
      {"damping of the wall", "B [N s/m]", {0.1, 0.2, 0.4, 1, 2, 5, 10, 20, 30}, true, [](double b) {
         return HeldWall{.wall_damping_n_s_per_m = b};
       }});
  all.push_back({"encoder of 0.03 mm, dry friction",
                 "dry friction of the device [N]",
                 {0.0015, 0.003, 0.006, 0.01, 0.015, 0.03},
                 true,
                 [](double n) { return HeldWall{.encoder_m = 3e-5, .coulomb_n = n}; }});
  return all;
}

}  // namespace

void study_walls(StudyReport& report) {
  StudyTable table{"wall_stiffness",
                   {"sweep", "rate_hz", "damping_n_s_per_m", "wall_damping_n_s_per_m", "delay_ticks",
                    "encoder_m", "coulomb_n", "measured_n_per_m", "exact_n_per_m", "colgate_schenkel_n_per_m",
                    "abbott_okamura_n_per_m", "thumb_n_per_m"},
                   {}};
  Chart chart{"wall_stiffness",
              "Largest stable stiffness of a touched wall",
              {"m = 0.072 kg, b = 0.5 N s/m, 1 kHz, B = 0, no delay, exact encoder where not said otherwise.",
               "Circles: touched in the closed loop and bisected. Exact: eigenvalues of the loop, without "
               "quantum and dry friction."},
              2,
              {}};
  for (const Sweep& sweep : sweeps()) {
    ChartPanel panel{sweep.name, sweep.x_label, "stiffness [N/m]", sweep.log_x, true, {}, {}};
    panel.curves = {{"exact", eigenvalues, sweep.values, {}},
                    {"Colgate & Schenkel", colgate, sweep.values, {}},
                    {"Abbott & Okamura", abbott, sweep.values, {}},
                    {"(b + B)/((d + 1/2) T)", thumb, sweep.values, {}},
                    {"touched", touched, sweep.values, {}}};
    for (const double value : sweep.values) {
      const HeldWall wall = sweep.wall(value);
      const double found[] = {stable_stiffness(wall), colgate_schenkel_stiffness(wall),
                              abbott_okamura_stiffness(wall), thumb_stiffness(wall),
                              measured_stable_stiffness(wall)};
      for (std::size_t i = 0; i < std::size(found); ++i) panel.curves[i].y.push_back(found[i]);
      table.rows.push_back({sweep.name.substr(0, sweep.name.find(',')), 1 / wall.tick_s,
                            wall.damping_n_s_per_m, wall.wall_damping_n_s_per_m,
                            static_cast<double>(wall.delay_ticks), wall.encoder_m, wall.coulomb_n, found[4],
                            found[0], found[1], found[2], found[3]});
    }
    chart.panels.push_back(std::move(panel));
  }
  report.tables.push_back(std::move(table));
  report.charts.push_back(std::move(chart));
}

}  // namespace fingerpad
