#include <cmath>
#include <functional>
#include <numbers>

#include "friction/law_settings.hpp"
#include "study/bench_scene.hpp"
#include "study/stability_parts.hpp"

namespace fingerpad {
namespace {

constexpr double rate_hz = 10000, seconds = 1, restick_load_n = 1;

struct SlowingRub {
  std::string name;
  std::function<double(double)> x_m;
  double shown_s;
};

std::vector<SlowingRub> rubs() {
  const auto drag = [](double v) { return [v](double t_s) { return v * t_s; }; };
  return {
      {"drag at 0.01 m/s", drag(0.01), 0.1},
      {"drag at 0.09 m/s, just under v_min", drag(0.09), 0.02},
      {"drag at 0.2 m/s", drag(0.2), 0.02},
      {"sine of 10 mm at 3 Hz", [](double t_s) { return 0.01 * std::sin(6 * std::numbers::pi * t_s); }, 0.5}};
}

struct RubRun {
  std::vector<double> t_s, force_n;
  double stick_share = 0, mean_mu = 0, work_j = 0;
  double ruptures = 0;
};

RubRun rub_with(const SlowingRub& rub, Restick restick) {
  BenchScene bench(rate_hz, "stick-slip");
  bench.scene().friction.settings.restick = restick;
  const double z_m = -restick_load_n / bench.surface().stiffness_n_per_m;
  ClosedLoop loop = bench.loop(seconds, [&](double t_s) { return Vec3(rub.x_m(t_s), 0, z_m); });
  RubRun run;
  double last_x = 0;
  const auto ticks = static_cast<double>(loop.tick_count());
  for (long k = 0; k < loop.tick_count(); ++k) {
    const TickRecord record = loop.next();
    const double force_n = -record.friction_W_n.x();
    if (record.t_s <= rub.shown_s) {
      run.t_s.push_back(record.t_s);
      run.force_n.push_back(force_n);
    }
    run.stick_share += (record.phase == Phase::stick ? 1 : 0) / ticks;
    run.mean_mu += record.mu / ticks;
    run.ruptures += record.ruptures;
    run.work_j += force_n * (record.p_WQ.x() - last_x);
    last_x = record.p_WQ.x();
  }
  return run;
}

}  // namespace

void study_restick(StudyReport& report) {
  StudyTable table{
      "restick", {"motion", "restick", "stick_share", "ruptures", "mean_mu", "work_taken_j"}, {}};
  Chart chart{"restick",
              "Two readings of the paper's return to stick",
              {"Stick-slip at 1 N, mu 0.3 and 0.2, k_f = 1000 1/m, v_min = 0.1 m/s, 10 kHz.",
               "level: stick whenever |v| <= v_min. crossing: only when |v| falls through it."},
              2,
              {}};
  for (const SlowingRub& rub : rubs()) {
    ChartPanel panel{rub.name, "time [s]", "friction [N]", false, false, {}, {}};
    for (const Restick restick : {Restick::level, Restick::crossing}) {
      const bool level = restick == Restick::level;
      RubRun run = rub_with(rub, restick);
      table.rows.push_back({rub.name.substr(0, rub.name.find(',')), level ? "level" : "crossing",
                            run.stick_share, run.ruptures, run.mean_mu, run.work_j});
      panel.curves.push_back({level ? "level" : "crossing",
                              {level ? 5 : 0, level ? Dash::solid : Dash::dashed, Marker::none},
                              std::move(run.t_s),
                              std::move(run.force_n)});
    }
    chart.panels.push_back(std::move(panel));
  }
  report.tables.push_back(std::move(table));
  report.charts.push_back(std::move(chart));
}

}  // namespace fingerpad
