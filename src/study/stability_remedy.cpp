#include <cmath>
#include <numbers>

#include "study/bench_scene.hpp"
#include "study/stability_parts.hpp"
#include "study/stick_buzz.hpp"

namespace fingerpad {
namespace {

struct NamedRemedy {
  std::string name;
  Remedy remedy;
  CurveStyle style;
};

const NamedRemedy remedies[] = {
    {"none", Remedy::none, {5, Dash::solid, Marker::disc}},
    {"damping", Remedy::damping, {0, Dash::dashed, Marker::square}},
    {"implicit", Remedy::implicit, {1, Dash::dash_dot, Marker::triangle}},
    {"cap", Remedy::cap, {2, Dash::dotted, Marker::diamond}},
};

constexpr double remedy_rate_hz = 1000, remedy_mu_static = 0.3;

/// Friction along x under a load on a motion that is followed exactly; the remedy knows b = 0.5 N s/m.
std::vector<double> friction_of(Remedy remedy, double load_n, double (*x_m)(double)) {
  BenchScene bench(remedy_rate_hz, "stick-slip");
  bench.scene().friction.settings.remedy = remedy;
  const double z_m = -load_n / bench.surface().stiffness_n_per_m;
  ClosedLoop loop = bench.loop(1, [&](double t_s) { return Vec3(x_m(t_s), 0, z_m); });
  std::vector<double> force(static_cast<std::size_t>(loop.tick_count()));
  for (double& f : force) f = -loop.next().friction_W_n.x();
  return force;
}

/// RMS of what a remedy changes, as a share of mu_s n.
double rms_change(Remedy remedy, double load_n, double (*x_m)(double)) {
  const std::vector<double> plain = friction_of(Remedy::none, load_n, x_m);
  const std::vector<double> remedied = friction_of(remedy, load_n, x_m);
  double square = 0;
  for (std::size_t k = 0; k < plain.size(); ++k) square += std::pow(remedied[k] - plain[k], 2);
  return std::sqrt(square / static_cast<double>(plain.size())) / (remedy_mu_static * load_n);
}

double presliding_m(double t_s) {
  return 1.5e-4 * std::sin(10 * std::numbers::pi * t_s);
}

double rub_m(double t_s) {
  return 0.01 * std::sin(6 * std::numbers::pi * t_s);
}

ChartPanel quiet_panel(StudyTable& table) {
  const std::vector<double> rates_hz{250, 500, 1000, 2000, 4000};
  ChartPanel panel{"up to which load stick is quiet", "rate [Hz]", "normal force [N]", true, true, {}, {}};
  for (const NamedRemedy& remedy : remedies) {
    ChartCurve series{remedy.name, remedy.style, rates_hz, {}};
    for (const double hz : rates_hz) {
      StuckFinger finger;
      finger.rate_hz = hz;
      finger.settings.remedy = remedy.remedy;
      series.y.push_back(quiet_load_n(finger));
      table.rows.push_back({remedy.name, hz, series.y.back()});
    }
    panel.curves.push_back(std::move(series));
  }
  return panel;
}

}  // namespace

void study_remedies(StudyReport& report) {
  StudyTable quiet{"remedy_quiet", {"remedy", "rate_hz", "quiet_up_to_n"}, {}};
  StudyTable cost{"remedy_cost",
                  {"remedy", "load_n", "presliding_rms_change_share", "rub_rms_change_share", "breakaway_m"},
                  {}};
  const std::vector<double> loads_n{0.5, 1, 1.5, 2, 3, 5, 10};
  ChartPanel presliding{"cost in stick: 0.15 mm at 5 Hz",
                        "normal force [N]",
                        "RMS change of friction [share of mu_s n]",
                        true,
                        false,
                        {},
                        {}};
  ChartPanel rub{"cost in a rub: 10 mm at 3 Hz",
                 "normal force [N]",
                 "RMS change of friction [share of mu_s n]",
                 true,
                 false,
                 {},
                 {}};
  ChartPanel breakaway{
      "how far the pad stretches before it slips", "normal force [N]", "stretch [mm]", true, false, {}, {}};
  for (const NamedRemedy& remedy : remedies) {
    ChartCurve in_stick{remedy.name, remedy.style, loads_n, {}};
    ChartCurve in_rub = in_stick, stretch = in_stick;
    for (const double load_n : loads_n) {
      in_stick.y.push_back(rms_change(remedy.remedy, load_n, presliding_m));
      in_rub.y.push_back(rms_change(remedy.remedy, load_n, rub_m));
      // Rupture is where the spring alone has reached mu_s n.
      const double stable_n_per_m =
          stick_remedy_reserve * 2 * StickRemedy{}.device_damping_n_s_per_m * remedy_rate_hz;
      const double stiffness = 1000 * load_n;
      const double held = remedy.remedy == Remedy::cap ? std::min(stiffness, stable_n_per_m) : stiffness;
      stretch.y.push_back(1e3 * remedy_mu_static * load_n / held);
      cost.rows.push_back({remedy.name, load_n, in_stick.y.back(), in_rub.y.back(), 1e-3 * stretch.y.back()});
    }
    presliding.curves.push_back(std::move(in_stick));
    rub.curves.push_back(std::move(in_rub));
    breakaway.curves.push_back(std::move(stretch));
  }
  ChartPanel quiet_loads = quiet_panel(quiet);
  report.tables.push_back(std::move(quiet));
  report.tables.push_back(std::move(cost));
  report.charts.push_back(
      {"remedies",
       "Remedies for a stick spring too stiff for the loop, and what they cost",
       {"Stick-slip, k_f = 1000 1/m, finger of 0.072 kg, b = 0.5 N s/m; costs at 1 kHz, where the spring is "
        "held up to 1 N.",
        "cap softens the spring: quiet at any load, but the pad stretches further. damping and implicit keep "
        "the stretch."},
       2,
       {std::move(quiet_loads), std::move(breakaway), std::move(presliding), std::move(rub)}});
}

}  // namespace fingerpad
