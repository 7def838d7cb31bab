#include <algorithm>
#include <numbers>

#include "study/stability_parts.hpp"
#include "study/stick_buzz.hpp"

namespace fingerpad {
namespace {

const std::vector<double> buzz_rates_hz{250, 500, 1000, 2000, 4000, 10000};
constexpr double hand_damping_n_s_per_m = 0.5, buzz_stiffness_per_m = 1000;

void laws_by_rate(StudyReport& report) {
  StudyTable table{"stick_buzz", {"law", "rate_hz", "quiet_up_to_n", "rule_2b_over_kf_t_n"}, {}};
  ChartPanel panel{"", "rate [Hz]", "normal force up to which stick is quiet [N]", true, true, {}, {}};
  ChartCurve rule{"2 b/(k_f T)", {5, Dash::dotted, Marker::none}, buzz_rates_hz, {}};
  for (const double hz : buzz_rates_hz)
    rule.y.push_back(2 * hand_damping_n_s_per_m * hz / buzz_stiffness_per_m);
  for (const LawEntry& law : law_table()) {
    const std::string name(law.name);
    ChartCurve series{name, law_style(name), buzz_rates_hz, {}};
    for (std::size_t i = 0; i < buzz_rates_hz.size(); ++i) {
      StuckFinger finger;
      finger.law = name;
      finger.rate_hz = buzz_rates_hz[i];
      series.y.push_back(quiet_load_n(finger));
      table.rows.push_back({name, buzz_rates_hz[i], series.y.back(), rule.y[i]});
    }
    panel.curves.push_back(std::move(series));
  }
  panel.curves.push_back(std::move(rule));
  report.tables.push_back(std::move(table));
  report.charts.push_back(
      {"stick_buzz",
       "Normal force above which the stick phase buzzes",
       {"Finger of 0.072 kg, hand of 0.5 N s/m; every law at its defaults, the pad at 45 deg, pushed across.",
        "Not shown: laws quiet at 100 N. A law of fixed 1000 N/m buzzes at every load below 1 kHz."},
       1,
       {std::move(panel)}});
}

void pad_by_angle(StudyReport& report) {
  StudyTable table{"stick_buzz_finger_pad",
                   {"inclination_deg", "push", "rate_hz", "quiet_up_to_n", "rule_2b_over_kt_n"},
                   {}};
  ChartPanel panel{
      "", "inclination of the finger [deg]", "normal force up to which stick is quiet [N]", false, true, {},
      {}};
  for (const bool along : {false, true}) {
    const double axis45_m = (along ? 0.8 : 1.0) * 0.3 / buzz_stiffness_per_m;
    ChartCurve found{along ? "finger-pad, along the finger" : "finger-pad, across it",
                     {along ? 5 : 0, Dash::none, along ? Marker::square : Marker::disc},
                     {},
                     {}};
    ChartCurve rule{along ? "2 b a(angle)/(mu_s T), along" : "2 b a(angle)/(mu_s T), across",
                    {along ? 5 : 0, Dash::dotted, Marker::none},
                    {},
                    {}};
    for (int deg = 0; deg <= 90; deg += 15) {
      StuckFinger finger;
      finger.law = "finger-pad";
      // Not quite upright: along the normal a finger names no direction in the plane.
      finger.inclination_rad = std::min<double>(deg, 89.9) * std::numbers::pi / 180;
      finger.push_along_finger = along;
      found.x.push_back(deg);
      found.y.push_back(quiet_load_n(finger));
      const double axis_m = axis45_m * (1 - 0.01 * (deg - 45));
      rule.x.push_back(deg);
      rule.y.push_back(2 * hand_damping_n_s_per_m * finger.rate_hz * axis_m / finger.mu_static);
      table.rows.push_back({static_cast<double>(deg), along ? "along" : "across", finger.rate_hz,
                            found.y.back(), rule.y.back()});
    }
    panel.curves.push_back(std::move(found));
    panel.curves.push_back(std::move(rule));
  }
  report.tables.push_back(std::move(table));
  report.charts.push_back(
      {"stick_buzz_finger_pad",
       "The raised finger's pad is stiffer and buzzes sooner",
       {"1 kHz, finger of 0.072 kg, hand of 0.5 N s/m, the built-in pad (k_f = 1000 1/m at 45 deg)."},
       1,
       {std::move(panel)}});
}

}  // namespace

void study_buzz(StudyReport& report) {
  laws_by_rate(report);
  pad_by_angle(report);
}

}  // namespace fingerpad
