#include "study/friction_vibration.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "study/bench_scene.hpp"

namespace fingerpad {
namespace {

constexpr double drag_mu = 0.2, load_n = 1, stroke_m = 0.01;
constexpr double half_band_hz = 30, turn_rad = 2 * std::numbers::pi;

/// So many frequencies are summed at once, which the processor does side by side.
constexpr int at_once = 8;
using Lanes = Eigen::Array<double, at_once, 1>;

/// The power that a signal holds at each frequency of these, in cycles over its whole length; none of them is
/// 0 or half the rate.
Lanes power_at(std::span<const double> signal, double mean, const Lanes& cycles) {
  const auto count = static_cast<double>(signal.size());
  const Lanes turn = turn_rad / count * cycles, step_re = turn.cos(), step_im = turn.sin();
  Lanes re = Lanes::Ones(), im = Lanes::Zero(), sum_re = Lanes::Zero(), sum_im = Lanes::Zero();
  for (const double value : signal) {
    sum_re += (value - mean) * re;
    sum_im += (value - mean) * im;
    const Lanes next_re = re * step_re - im * step_im;
    im = re * step_im + im * step_re;
    re = next_re;
  }
  return 2 * (sum_re.square() + sum_im.square()) / (count * count);
}

/// The RMS of what a signal holds within a band: the sum over its own frequencies there (Parseval).
double band_rms(std::span<const double> signal, double rate_hz, double low_hz, double high_hz) {
  const auto count = static_cast<double>(signal.size());
  double mean = 0, square = 0;
  for (const double value : signal) mean += value / count;
  const double last = high_hz * count / rate_hz;
  for (double first = std::ceil(low_hz * count / rate_hz); first <= last; first += at_once) {
    const Lanes cycles = Lanes::LinSpaced(first, first + at_once - 1);
    square += (cycles <= last).select(power_at(signal, mean, cycles), 0).sum();
  }
  return std::sqrt(square);
}

/// What is counted: four seconds of a drag, within which the RMS of 20 Hz scatters by 5 % from seed to seed;
/// whole strokes.
struct Times {
  double begin_s, end_s;
};
Times counted_times(const VibratingDrag& drag) {
  if (!drag.strokes) return {0.5, 4.5};  // from 0.003 m/s on it has slipped by then
  const double period_s = turn_rad * stroke_m / drag.speed_m_per_s;
  return {period_s, period_s * (1 + std::max(1.0, std::round(2 / period_s)))};
}

}  // namespace

VibrationFelt vibration_felt(const VibratingDrag& drag) {
  BenchScene bench(drag.rate_hz, "finger-pad");
  bench.scene().friction.settings.restick = drag.restick;
  if (drag.vibrates) bench.scene().friction.vibration.emplace();
  const double z_m = -load_n / bench.surface().stiffness_n_per_m;
  const Times times = counted_times(drag);
  ClosedLoop loop = bench.loop(times.end_s, [&](double t_s) {
    const double way_m = drag.speed_m_per_s * t_s;
    return Vec3(drag.strokes ? stroke_m * std::sin(way_m / stroke_m) : way_m, 0, z_m);
  });
  VibrationFelt felt;
  for (long k = 0; k < loop.tick_count(); ++k) {
    const TickRecord record = loop.next();
    if (static_cast<double>(k) < times.begin_s * drag.rate_hz) continue;
    felt.slip_share += record.phase == Phase::slip ? 1 : 0;
    felt.force_n.push_back(-record.friction_W_n.x());
  }
  felt.slip_share /= static_cast<double>(felt.force_n.size());
  const double peak_hz = VibrationSettings{}.frequency_hz;
  felt.band_share = band_rms(felt.force_n, drag.rate_hz, peak_hz - half_band_hz, peak_hz + half_band_hz) /
                    (drag_mu * load_n);
  return felt;
}

double asked_band_share() {
  // A narrow peak of width B holds 2/pi atan(2 h/B) of its power within h of its top.
  const VibrationSettings vibration;
  return vibration.amplitude *
         std::sqrt(2 / std::numbers::pi * std::atan(2 * half_band_hz / vibration.bandwidth_hz));
}

namespace {

struct Reading {
  std::string name;
  VibratingDrag drag;
  CurveStyle style;
};

std::vector<Reading> readings() {
  const auto style = [](int colour, Dash dash, Marker marker) { return CurveStyle{colour, dash, marker}; };
  const Restick level = Restick::level, crossing = Restick::crossing;
  return {
      {"level, 1 kHz", {.restick = level}, style(palette::ink, Dash::solid, Marker::disc)},
      {"level, 10 kHz",
       {.rate_hz = 10000, .restick = level},
       style(palette::blue, Dash::dashed, Marker::ring)},
      {"crossing, 1 kHz", {.restick = crossing}, style(palette::vermillion, Dash::solid, Marker::triangle)},
      {"crossing, 10 kHz",
       {.rate_hz = 10000, .restick = crossing},
       style(palette::orange, Dash::dashed, Marker::diamond)},
      {"level, no vibration, 10 kHz",
       {.rate_hz = 10000, .restick = level, .vibrates = false},
       style(palette::grey, Dash::dotted, Marker::none)},
  };
}

ChartPanel panel(const std::string& title, const std::string& x_label, const std::string& y_label) {
  ChartPanel made{title, x_label, y_label, true, false, {}, {}};
  made.y_from_zero = true;
  return made;
}

/// 30 drags from 0.003 to 1 m/s.
std::vector<double> drag_speeds() {
  std::vector<double> speeds;
  speeds.reserve(30);
  for (int i = 0; i < 30; ++i) speeds.push_back(0.003 * std::pow(1 / 0.003, i / 29.0));
  return speeds;
}

constexpr std::array stroke_speeds{0.02, 0.05, 0.09, 0.1, 0.105, 0.11, 0.12, 0.14, 0.17, 0.2, 0.3, 0.5};

void add_drags(StudyTable& table, ChartPanel& slip, ChartPanel& band) {
  for (const Reading& reading : readings()) {
    ChartCurve slips{reading.name, reading.style, drag_speeds(), {}};
    ChartCurve bands = slips;
    for (const double speed : slips.x) {
      VibratingDrag drag = reading.drag;
      drag.speed_m_per_s = speed;
      const VibrationFelt felt = vibration_felt(drag);
      slips.y.push_back(felt.slip_share);
      bands.y.push_back(felt.band_share);
      table.rows.push_back(
          {"drag", reading.name, speed, felt.slip_share, felt.band_share, asked_band_share()});
    }
    if (reading.drag.vibrates) slip.curves.push_back(std::move(slips));
    band.curves.push_back(std::move(bands));
  }
  band.curves.push_back({"asked for, within the band",
                         {palette::bluish_green, Dash::dash_dot, Marker::none},
                         {band.curves.front().x.front(), band.curves.front().x.back()},
                         {asked_band_share(), asked_band_share()}});
}

void add_strokes(StudyTable& table, ChartPanel& panel) {
  for (const Reading& reading : readings()) {
    if (!reading.drag.vibrates) continue;
    ChartCurve slips{reading.name, reading.style, {stroke_speeds.begin(), stroke_speeds.end()}, {}};
    for (const double speed : slips.x) {
      VibratingDrag drag = reading.drag;
      drag.speed_m_per_s = speed;
      drag.strokes = true;
      slips.y.push_back(vibration_felt(drag).slip_share);
      // Reversals fill the band by themselves: there it says nothing of the vibration.
      table.rows.push_back({"strokes", reading.name, speed, slips.y.back(), std::nan(""), std::nan("")});
    }
    panel.curves.push_back(std::move(slips));
  }
}

/// A tenth of a second of a slow drag.
void add_forces(ChartPanel& panel) {
  for (const Reading& reading : readings()) {
    if (reading.drag.rate_hz < 10000 || !reading.drag.vibrates) continue;
    VibratingDrag drag = reading.drag;
    drag.speed_m_per_s = 0.03;
    ChartCurve curve{reading.name, reading.style, {}, {}};
    curve.style.marker = Marker::none;
    curve.style.dash = Dash::solid;
    const VibrationFelt felt = vibration_felt(drag);
    for (std::size_t k = 0; k <= 1000; ++k) {
      curve.x.push_back(static_cast<double>(k) / drag.rate_hz);
      curve.y.push_back(felt.force_n[k]);
    }
    panel.curves.push_back(std::move(curve));
  }
}

}  // namespace

void study_vibration(StudyReport& report) {
  StudyTable table{
      "vibration",
      {"motion", "restick_and_rate", "speed_m_per_s", "slip_share", "rms_59_to_119_hz_share", "asked_share"},
      {}};
  ChartPanel slip = panel("drag at constant speed: time in slip", "speed [m/s]", "share of the time");
  ChartPanel band =
      panel("the same drags: friction within 30 Hz of 89 Hz", "speed [m/s]", "RMS [share of mu_d n]");
  ChartPanel strokes =
      panel("strokes of 10 mm to and fro: time in slip", "greatest speed [m/s]", "share of the time");
  ChartPanel forces = panel("friction in a drag at 0.03 m/s", "time [s]", "friction [N]");
  forces.log_x = forces.y_from_zero = false;
  add_drags(table, slip, band);
  add_strokes(table, strokes);
  add_forces(forces);
  report.tables.push_back(std::move(table));
  report.charts.push_back(
      {"vibration",
       "Slip vibration below v_min: restick = level and crossing",
       {"Finger pad at 1 N and 45 deg, mu 0.3 and 0.2, v_min = 0.1 m/s; vibration of 89 Hz, 20 Hz broad, "
        "0.05 of mu_d n, in slip only.",
        "With level the teeth take the place of slip below v_min. They beat V k_f/(mu_s - mu_d) times a "
        "second "
        "(dotted: without vibration):",
        "near 0.01 m/s that is 89 Hz, at slower drags a harmonic is; at 1 kHz the 900 Hz of 0.09 m/s is seen "
        "as 100 Hz."},
       2,
       {std::move(slip), std::move(band), std::move(strokes), std::move(forces)}});
}

}  // namespace fingerpad
