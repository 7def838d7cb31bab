#include <algorithm>

#include "study/pulled_block.hpp"
#include "study/stability_parts.hpp"

namespace fingerpad {
namespace {

constexpr double block_rate_hz = 40000, block_seconds = 12;

ChartCurve pull_series(const std::string& name, const CurveStyle& style, const std::vector<double>& pull_n) {
  ChartCurve series{name, style, {}, {}};
  for (std::size_t k = 0; k < pull_n.size(); k += 400) {
    series.x.push_back(static_cast<double>(k) / block_rate_hz);
    series.y.push_back(pull_n[k]);
  }
  return series;
}

}  // namespace

void study_undamped_block(StudyReport& report) {
  StudyTable table{"pulled_block",
                   {"damping_n_s_per_m", "stick_stiffness_per_m", "first_break_n", "second_break_n",
                    "rigid_break_n", "rigid_least_n", "rigid_period_s"},
                   {}};
  Chart chart{
      "pulled_block",
      "A block pulled by a spring: the paper's stick needs a damper",
      {"1 kg, 20 N/m, 0.05 m/s, F_s = 3 N, F_d = 2 N, v_min = 0.002 m/s, stick-slip at 40 kHz.",
       "Stick is a spring entered at F_d: undamped it rings about the pull and breaks at a pull of F_d."},
      1,
      {}};
  for (const double damping : {0.0, 2.0}) {
    PulledBlock block;
    block.speed_m_per_s = 0.05;
    block.damping_n_s_per_m = damping;
    const StickSlipCycle rigid = rigid_cycle(block);
    ChartPanel panel{damping > 0 ? "damper of 2 N s/m" : "no damper",
                     "time [s]",
                     "pull of the spring [N]",
                     false,
                     false,
                     {},
                     {}};
    int colour = 5;
    for (const double stiffness : {50.0, 200.0}) {
      LawSettings settings = block_settings("stick-slip");
      settings.numbers["stick_stiffness_per_m"] = stiffness;
      const std::vector<double> pull =
          pull_of_block(block, "stick-slip", settings, block_rate_hz, block_seconds);
      const auto after_first = pull.begin() + static_cast<long>(4.3 * block_rate_hz);
      const double first = *std::max_element(pull.begin(), after_first);
      const double second =
          *std::max_element(after_first, pull.begin() + static_cast<long>(7 * block_rate_hz));
      table.rows.push_back({damping, stiffness, first, second, rigid.peak_n, rigid.least_n, rigid.period_s});
      panel.curves.push_back(pull_series(stiffness < 100 ? "k_f = 50 1/m" : "k_f = 200 1/m",
                                         {colour, stiffness < 100 ? Dash::solid : Dash::dashed, Marker::none},
                                         pull));
      colour = 0;
    }
    const std::vector<double> ends{0, block_seconds};
    panel.curves.push_back(
        {"F_s", {6, Dash::dotted, Marker::none}, ends, {block.static_n(), block.static_n()}});
    panel.curves.push_back(
        {"F_d", {2, Dash::dotted, Marker::none}, ends, {block.dynamic_n(), block.dynamic_n()}});
    panel.curves.push_back(
        {"rigid stick falls to", {7, Dash::dash_dot, Marker::none}, ends, {rigid.least_n, rigid.least_n}});
    chart.panels.push_back(std::move(panel));
  }
  report.tables.push_back(std::move(table));
  report.charts.push_back(std::move(chart));
}

}  // namespace fingerpad
