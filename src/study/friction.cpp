#include <algorithm>
#include <cmath>
#include <map>

#include "study/battery.hpp"
#include "study/friction_events.hpp"
#include "study/friction_vibration.hpp"
#include "study/pulled_block.hpp"
#include "study/studies.hpp"

namespace fingerpad {
namespace {

const std::vector<double> rates_hz{250, 500, 1000, 2000, 4000, 10000, 20000};
constexpr double fine_hz = 640000;
/// Errors below this are rounding; so that a logarithmic axis can show them they are drawn here.
constexpr double floor_of_errors = 1e-6;

/// Error by law, then by rate.
using ErrorsByLaw = std::map<std::string, std::vector<double>, std::less<>>;

std::vector<std::string> law_names() {
  std::vector<std::string> names;
  for (const LawEntry& law : law_table()) {
    if (law.rubs) names.emplace_back(law.name);
  }
  return names;
}

ChartCurve law_series(const std::string& law, std::vector<double> x, std::vector<double> y) {
  for (double& value : y) value = std::isfinite(value) ? std::max(value, floor_of_errors) : value;
  return {law, law_style(law), std::move(x), std::move(y)};
}

/// The root mean square over the battery.
void gather(ErrorsByLaw& squares, const std::string& law, std::size_t rate, double error) {
  std::vector<double>& of_law = squares.try_emplace(law, rates_hz.size(), 0.0).first->second;
  of_law[rate] = std::hypot(of_law[rate], error / std::sqrt(static_cast<double>(battery().size())));
}

ErrorsByLaw study_own_limits(StudyReport& report, const StudyProgress& progress) {
  ErrorsByLaw overall;
  StudyTable table{"error_against_own_limit",
                   {"case", "law", "rate_hz", "rms_error_share", "worst_error_share", "work_error_share"},
                   {}};
  Chart chart{
      "error_against_own_limit",
      "Error of the friction force against the same law at 640 kHz",
      {"RMS over the ticks, as a share of mu_s times the mean load. Errors under 1e-6 are drawn there.",
       "Sawtooth laws: once a tooth has slipped by its own length, the error is that of its phase."},
      2,
      {}};
  for (const BatteryCase& c : battery()) {
    progress(std::string(c.name));
    ChartPanel panel{std::string(c.name) + ": " + std::string(c.motion),
                     "rate [Hz]",
                     "RMS error [share of mu_s n]",
                     true,
                     true,
                     {},
                     {}};
    for (const std::string& law : law_names()) {
      const BatteryRun fine = run_battery(c, law, fine_hz, Events::exact);
      std::vector<double> errors;
      for (std::size_t i = 0; i < rates_hz.size(); ++i) {
        const BatteryError error = battery_error(run_battery(c, law, rates_hz[i], Events::exact), fine,
                                                 std::lround(fine_hz / rates_hz[i]));
        errors.push_back(error.rms);
        gather(overall, law, i, error.rms);
        table.rows.push_back({std::string(c.name), law, rates_hz[i], error.rms, error.worst, error.work});
      }
      panel.curves.push_back(law_series(law, rates_hz, errors));
    }
    chart.panels.push_back(std::move(panel));
  }
  report.tables.push_back(std::move(table));
  report.charts.push_back(std::move(chart));
  return overall;
}

ErrorsByLaw study_pulled_block(StudyReport& report, const StudyProgress& progress) {
  progress("pulled block");
  ErrorsByLaw errors;
  StudyTable table{"stick_slip_period",
                   {"law", "rate_hz", "period_s", "exact_period_s", "error_share", "break_n", "least_n"},
                   {}};
  ChartPanel panel{"", "rate [Hz]", "error of the period [share]", true, true, {}, {}};
  for (const std::string& law : law_names()) {
    if (!has_static_limit(law)) continue;
    const StickSlipCycle exact = reference_cycle({}, law);
    std::vector<double>& of_law = errors[law];
    for (const double hz : rates_hz) {
      const PulledBlock block = block_for({}, law);
      const StickSlipCycle cycle = cycle_of(pull_of_block(block, law, block_settings(law), hz, 40), hz, 1);
      of_law.push_back(std::abs(cycle.period_s / exact.period_s - 1));
      table.rows.push_back(
          {law, hz, cycle.period_s, exact.period_s, of_law.back(), cycle.peak_n, cycle.least_n});
    }
    panel.curves.push_back(law_series(law, rates_hz, of_law));
  }
  report.tables.push_back(std::move(table));
  report.charts.push_back(
      {"stick_slip_period",
       "A block pulled by a spring: period of stick-slip against the exact one",
       {"1 kg, 20 N/m, 2 N s/m, 0.02 m/s, F_s = 3 N, F_d = 2 N; stick of 5000 N/m, v_min = 0.002 m/s; the "
        "hand closes the loop.",
        "Not shown: no stick-slip at all (salisbury drags at its mean, karnopp creeps in its band;",
        "at low rates the stick spring itself buzzes: 5000 N/m against 2 b/T = 4000 N/m at 1 kHz)."},
       1,
       {std::move(panel)}});
  return errors;
}

/// Error against computing time per second of touch, with the front of what no other beats.
ChartPanel cost_panel(const std::string& title, const ErrorsByLaw& errors,
                      const std::map<std::string, double>& law_ns) {
  ChartPanel panel{
      title, "computing time of the law for a second of touch [us]", "error [share]", true, true, {}, {}};
  std::vector<std::pair<double, double>> all;
  for (const std::string& law : law_names()) {
    const auto found = errors.find(law);
    if (found == errors.end()) continue;
    std::vector<double> cost_us;
    cost_us.reserve(rates_hz.size());
    for (const double hz : rates_hz) cost_us.push_back(law_ns.at(law) * hz * 1e-3);
    panel.curves.push_back(law_series(law, cost_us, found->second));
    for (std::size_t i = 0; i < cost_us.size(); ++i) all.emplace_back(cost_us[i], panel.curves.back().y[i]);
  }
  panel.pareto_front = pareto_front(all);
  return panel;
}

void study_costs(StudyReport& report, const StudyProgress& progress, const ErrorsByLaw& own,
                 const ErrorsByLaw& exact) {
  progress("cost");
  StudyTable table{"cost_measured", {"case", "law", "law_ns_per_tick", "whole_tick_on_a_plane_ns"}, {}};
  std::map<std::string, double> law_ns;
  for (const BatteryCase& c : battery()) {
    for (const std::string& law : law_names()) {
      const TickCost cost = tick_cost(c, law);
      law_ns[law] += cost.law_ns / static_cast<double>(battery().size());
      table.rows.push_back({std::string(c.name), law, cost.law_ns, cost.whole_ns});
    }
  }
  report.tables.push_back(std::move(table));
  report.charts.push_back(
      {"speed_against_accuracy_measured",
       "Speed against accuracy",
       {"Each curve is one law at 250 Hz (left) to 20 kHz (right). Times were measured on the machine that "
        "drew this.",
        "Left: a law's own limit says how fast it converges, not whether it is right. Right: the exact "
        "stick-slip says that."},
       2,
       {cost_panel("against the law's own limit, RMS over the battery", own, law_ns),
        cost_panel("against the exact stick-slip period of a pulled block", exact, law_ns)}});
}

}  // namespace

StudyReport study_friction(const StudyProgress& progress) {
  StudyReport report;
  const ErrorsByLaw own = study_own_limits(report, progress);
  progress("events between ticks");
  study_events(report);
  progress("vibration");
  study_vibration(report);
  const ErrorsByLaw exact = study_pulled_block(report, progress);
  study_costs(report, progress, own, exact);
  return report;
}

}  // namespace fingerpad
