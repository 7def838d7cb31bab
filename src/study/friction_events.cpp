#include "study/friction_events.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "study/battery.hpp"

namespace fingerpad {
namespace {

constexpr double mu_static = 0.3, mu_dynamic = 0.2, stiffness_per_m = 1000;  // at 1 N
constexpr std::array both_readings{Events::exact, Events::tick};

std::string name_of(Events events) {
  return events == Events::exact ? "between ticks" : "at ticks only";
}

/// Errors below this are rounding; so that a logarithmic axis can show them they are drawn here.
double drawn(double error) {
  return std::isfinite(error) ? std::max(error, 1e-9) : error;
}

struct Sawtooth {
  double period_m = std::numeric_limits<double>::quiet_NaN(), mean_mu = period_m;
};

/// The teeth of a drag along x at a steady speed, from the first rupture to the last. How far after its
/// rupture a tick is shows in the force, which rises from mu_d n by k_f n a metre.
Sawtooth sawtooth_of(const BatteryRun& run, double speed_m_per_s, double rate_hz) {
  double first_m = 0, last_m = 0, sum = 0, sum_at_last = 0;
  long first = -1, last = -1, teeth = 0;
  for (std::size_t k = 0; k < run.ruptures.size(); ++k) {
    const double mu = -run.friction_W_n(0, static_cast<Eigen::Index>(k));
    if (run.ruptures[k] > 0) {
      const double place_m =
          speed_m_per_s * static_cast<double>(k) / rate_hz - (mu - mu_dynamic) / stiffness_per_m;
      if (first < 0) {
        first = static_cast<long>(k);
        first_m = place_m;
        sum = 0;
      } else {
        teeth += run.ruptures[k];
      }
      last = static_cast<long>(k);
      last_m = place_m;
      sum_at_last = sum;
    }
    sum += mu;
  }
  if (teeth == 0) return {};
  return {(last_m - first_m) / static_cast<double>(teeth), sum_at_last / static_cast<double>(last - first)};
}

/// Slow drag by the paper's rule: mean (mu_s + mu_d)/2, spatial period (mu_s - mu_d)/k_f.
void study_sawtooth(StudyReport& report) {
  const std::vector<double> rates_hz{250, 500, 1000, 2000, 4000, 10000, 20000};
  constexpr double exact_period_m = (mu_static - mu_dynamic) / stiffness_per_m,
                   exact_mu = (mu_static + mu_dynamic) / 2, speed = 0.01;
  StudyTable table{
      "sawtooth", {"law", "events", "rate_hz", "period_m", "exact_period_m", "mean_mu", "exact_mean_mu"}, {}};
  Chart chart{
      "sawtooth",
      "Slow drag against the exact sawtooth: events between ticks, and at ticks only",
      {"0.01 m/s at 1 N, v_min = 0.1 m/s: teeth of (mu_s - mu_d)/k_f = 0.1 mm from mu_d to mu_s, "
       "mean 0.25; errors under 1e-9 are drawn there.",
       "At ticks only one tick of each tooth is slip, so the period is long by 1-2 V T. Means are over "
       "the ticks' samples."},
      2,
      {}};
  for (const Events events : both_readings) {
    ChartPanel period{
        "period of the teeth, " + name_of(events), "rate [Hz]", "error [share]", true, true, {}, {}};
    ChartPanel mean{"mean coefficient, " + name_of(events), "rate [Hz]", "error [share]", true, true, {}, {}};
    for (const std::string law : {"stick-slip", "finger-pad", "salisbury", "contact-area"}) {
      ChartCurve periods{law, law_style(law), rates_hz, {}};
      ChartCurve means = periods;
      for (const double hz : rates_hz) {
        const Sawtooth teeth = sawtooth_of(run_battery(battery()[0], law, hz, events), speed, hz);
        table.rows.push_back(
            {law, name_of(events), hz, teeth.period_m, exact_period_m, teeth.mean_mu, exact_mu});
        periods.y.push_back(drawn(std::abs(teeth.period_m / exact_period_m - 1)));
        means.y.push_back(drawn(std::abs(teeth.mean_mu / exact_mu - 1)));
      }
      period.curves.push_back(std::move(periods));
      mean.curves.push_back(std::move(means));
    }
    chart.panels.push_back(std::move(period));
    chart.panels.push_back(std::move(mean));
  }
  report.tables.push_back(std::move(table));
  report.charts.push_back(std::move(chart));
}

/// A rub whose speed passes v_min many times, with slow stretches full of teeth (SCIENCE 7).
constexpr BatteryCase rub{"rub", "two sines across each other", 4, [](double t) {
                            constexpr double turn = 2 * std::numbers::pi;
                            return Vec3(0.02 * std::sin(turn * 0.7 * t) + 0.003 * std::sin(turn * 2.3 * t),
                                        0.012 * std::cos(turn * 0.45 * t), -1e-3);
                          }};

void study_rub(StudyReport& report) {
  const std::vector<double> rates_hz{250, 500, 1000, 2000, 4000, 8000, 16000};
  constexpr double fine_hz = 128000;
  StudyTable table{"events", {"law", "events", "rate_hz", "rms_error_share", "ruptures"}, {}};
  ChartPanel error{"friction force", "rate [Hz]", "RMS error [share of mu_s n]", true, true, {}, {}};
  ChartPanel count{"ruptures", "rate [Hz]", "counted [share of those there are]", true, false, {}, {}};
  count.y_from_zero = true;
  for (const std::string law : {"stick-slip", "finger-pad", "contact-area", "salcudean-vlaar"}) {
    const BatteryRun fine = run_battery(rub, law, fine_hz, Events::exact);
    for (const Events events : both_readings) {
      CurveStyle style = law_style(law);
      style.dash = events == Events::exact ? Dash::solid : Dash::dotted;
      ChartCurve errors{law + ", " + name_of(events), style, rates_hz, {}};
      ChartCurve counts = errors;
      for (const double hz : rates_hz) {
        const BatteryRun run = run_battery(rub, law, hz, events);
        const double rms = battery_error(run, fine, std::lround(fine_hz / hz)).rms;
        table.rows.push_back({law, name_of(events), hz, rms, static_cast<double>(run.rupture_count())});
        errors.y.push_back(rms);
        counts.y.push_back(static_cast<double>(run.rupture_count()) /
                           static_cast<double>(fine.rupture_count()));
      }
      error.curves.push_back(std::move(errors));
      count.curves.push_back(std::move(counts));
    }
  }
  report.tables.push_back(std::move(table));
  report.charts.push_back(
      {"events",
       "What looking between ticks is worth",
       {"A rub of 4 s by two sines, fast and slow, at 1 N, against the same law at 128 kHz.",
        "Rupture and restick at their own places within a tick (solid) and at ticks only (dotted)."},
       2,
       {std::move(error), std::move(count)}});
}

}  // namespace

void study_events(StudyReport& report) {
  study_sawtooth(report);
  study_rub(report);
}

}  // namespace fingerpad
