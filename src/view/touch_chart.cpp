#include "view/touch_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/spectrum.hpp"
#include "friction/law_parameters.hpp"
#include "view/colours.hpp"

namespace fingerpad {
namespace {

constexpr double line_weight = 1.12;

// What the axes span at the least. A fingertip feels some 0.02 N and tells places 0.1 mm apart only just;
// what is less is rounding, an encoder's step or a filter's tail, and would fill a panel as if it were
// something.
constexpr double least_force_n = 0.05, least_way_mm = 0.1, least_speed_mm_per_s = 1, least_mu = 0.05;

ChartCurve line(const TouchSeries& series, std::string name, int colour, std::vector<double> y,
                Dash dash = Dash::solid) {
  return {std::move(name), {colour, dash, Marker::none, line_weight}, series.t_s, std::move(y)};
}

std::vector<double> scaled(const std::vector<double>& values, double factor) {
  std::vector<double> out(values);
  for (double& value : out) value *= factor;
  return out;
}

/// Values of the ticks in one phase. A tick next to such a run is kept too, so that the pieces join.
std::vector<double> where_phase(const std::vector<double>& values, const std::vector<Phase>& phase,
                                bool stick) {
  std::vector<double> out(values.size(), TickRecord::nan);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool mine = (phase[i] == Phase::stick) == stick;
    const bool joins = i > 0 && (phase[i - 1] == Phase::stick) == stick && phase[i] != phase[i - 1];
    if (mine || joins) out[i] = values[i];
  }
  return out;
}

ChartBand phase_band(const TouchSeries& series) {
  ChartBand band{"phase", {}, series.t_s, {}};
  for (const Phase one : {Phase::free, Phase::stick, Phase::slip}) {
    band.keys.push_back({std::string(phase_name(one)), phase_colour(one)});
  }
  for (const Phase one : series.phase) band.key_at.push_back(static_cast<std::size_t>(one));
  return band;
}

/// More rings than this would crowd.
constexpr int most_slip_ends = 60;

CurveStyle ring_style() {
  return {palette::vermillion, Dash::none, Marker::ring, 1.2};
}

bool are_too_many(const std::vector<bool>& slip_ends) {
  return std::count(slip_ends.begin(), slip_ends.end(), true) > most_slip_ends;
}

/// Rings on the panel's first curve where slip has just given way to stick. None where they would crowd.
void add_slip_ends(ChartPanel& panel, const TouchSeries& series) {
  if (are_too_many(series.slip_ends)) return;
  const std::vector<double>& values = panel.curves.front().y;
  std::vector<double> ends(values.size(), TickRecord::nan);
  bool any = false;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!series.slip_ends[i]) continue;
    ends[i] = values[i];
    any |= std::isfinite(values[i]);
  }
  if (any) panel.curves.push_back({"end of slip", ring_style(), series.t_s, std::move(ends)});
}

/// In a panel's legend, where no panel has rings since they would crowd.
void tell_slip_ends(ChartPanel& panel, const TouchSeries& series) {
  if (!are_too_many(series.slip_ends)) return;
  panel.curves.push_back({fmt::format("ends of slip: over {}, not marked", most_slip_ends), ring_style(),
                          series.t_s, std::vector<double>(series.t_s.size(), TickRecord::nan)});
}

ChartPanel panel_over_time(std::string y_label, std::string short_y_label, std::vector<ChartCurve> curves,
                           bool from_zero) {
  ChartPanel panel{"", "time [s]", std::move(y_label), false, false, std::move(curves)};
  panel.short_y_label = std::move(short_y_label);
  panel.y_from_zero = from_zero;
  return panel;
}

ChartPanel speed_panel(const TouchSeries& series, const TouchLevels& levels) {
  const std::string name =
      levels.speed_span_s > 0 ? fmt::format("speed over {:.0f} ms", 1e3 * levels.speed_span_s) : "speed";
  ChartPanel speed =
      panel_over_time("tangential speed [mm/s]", "speed [mm/s]",
                      {line(series, name, palette::blue, scaled(series.speed_m_per_s, 1e3))}, true);
  const auto fastest = std::max_element(
      series.speed_m_per_s.begin(), series.speed_m_per_s.end(),
      [](double a, double b) { return (std::isnan(a) ? -1 : a) < (std::isnan(b) ? -1 : b); });
  // v_min far above all speeds would flatten the curve.
  if (fastest != series.speed_m_per_s.end() && *fastest > 0.4 * levels.v_min_m_per_s &&
      levels.v_min_m_per_s > 0) {
    speed.levels.push_back({"v_min", levels.v_min_m_per_s * 1e3, palette::reddish_purple});
  }
  speed.least_y_span = least_speed_mm_per_s;
  add_slip_ends(speed, series);
  tell_slip_ends(speed, series);
  return speed;
}

/// A level of the coefficient, or a line with steps where it was not the same all the time; 0: none.
void add_mu_level(ChartPanel& panel, const TouchSeries& series, const std::string& name, int colour,
                  std::vector<double> mu) {
  const auto is_known = [](double value) { return value > 0; };
  if (std::none_of(mu.begin(), mu.end(), is_known)) return;
  const auto is_first = [&](double value) { return value == mu.front(); };
  if (std::all_of(mu.begin(), mu.end(), is_first)) {
    panel.levels.push_back({name, mu.front(), colour});
    return;
  }
  constexpr double level_weight = 0.72;  // as thin as a level is drawn
  for (double& value : mu) {
    if (!is_known(value)) value = TickRecord::nan;
  }
  panel.curves.push_back(
      {name, {colour, Dash::dashed, Marker::none, level_weight}, series.t_s, std::move(mu)});
}

/// The panels below the position.
void add_panels(Chart& chart, std::span<const TickRecord> rows, const TouchSeries& series,
                const TouchLevels& levels) {
  chart.panels.push_back(speed_panel(series, levels));
  chart.panels.push_back(
      panel_over_time("force on the finger [N]", "force [N]",
                      {line(series, "normal", palette::blue, series.normal_force_n),
                       line(series, series.friction_name + " (" + series.friction_sign + ")",
                            palette::vermillion, series.friction_n)},
                      true));
  chart.panels.back().least_y_span = least_force_n;
  ChartPanel mu = panel_over_time("coefficient of friction [1]", "mu [1]",
                                  {line(series, "mu", palette::ink, series.mu)}, true);
  mu.least_y_span = least_mu;
  add_slip_ends(mu, series);
  std::vector<double> mu_s, mu_d;
  for (const MuPair& at : mu_at_rows(rows, levels.mu)) {
    mu_s.push_back(at.mu_static);
    mu_d.push_back(at.mu_dynamic);
  }
  add_mu_level(mu, series, "mu_s", palette::bluish_green, std::move(mu_s));
  add_mu_level(mu, series, "mu_d", palette::orange, std::move(mu_d));
  chart.panels.push_back(std::move(mu));
}

/// How many rows from the first on are as far from each other as these are: all, or all but the last.
std::size_t evenly_spaced(const std::vector<double>& t_s) {
  const std::size_t count = t_s.size();
  if (count < 3) return count;
  const double step_s = (t_s[count - 2] - t_s.front()) / static_cast<double>(count - 2);
  constexpr double rounding = 1e-3;
  return t_s[count - 1] - t_s[count - 2] < (1 - rounding) * step_s ? count - 1 : count;
}

Chart stacked_chart(const TouchSeries& series) {
  Chart chart;
  chart.stacked = true;
  chart.band = phase_band(series);
  return chart;
}

}  // namespace

TouchLevels touch_levels(const ViewInput& input) {
  TouchLevels levels;
  levels.mu = mu_history(input);
  levels.thinned = input.every > 1;
  const bool has_encoder = input.scene && input.scene->hand && input.scene->hand->encoder_m > 0;
  if (has_encoder) levels.speed_span_s = net_speed_span_s;
  if (input.scene) levels.v_min_m_per_s = v_min_m_per_s(input.scene->friction.settings);
  return levels;
}

Chart touch_chart(std::span<const TickRecord> rows, const Vec3& direction_W, const TouchLevels& levels) {
  TouchSeries series = touch_series(rows, direction_W);
  if (levels.speed_span_s > 0) series.speed_m_per_s = net_speed(rows, levels.speed_span_s);
  if (levels.thinned) series.slip_ends.assign(series.slip_ends.size(), false);
  const std::vector<double> position_mm = scaled(series.position_m, 1e3);
  Chart chart = stacked_chart(series);
  chart.panels.push_back(panel_over_time(
      "position " + series.direction_name + " [mm]", series.direction_name + " [mm]",
      {line(series, "slip, free", palette::blue, where_phase(position_mm, series.phase, false)),
       line(series, "stick", palette::blue, where_phase(position_mm, series.phase, true), Dash::dotted),
       line(series, "stick centre", palette::vermillion, scaled(series.centre_m, 1e3), Dash::dashed)},
      false));
  chart.panels.back().least_y_span = least_way_mm;
  add_panels(chart, rows, series, levels);
  return chart;
}

Chart live_chart(std::span<const TickRecord> rows, const TouchLevels& levels) {
  TouchSeries series = touch_series(rows, Vec3::UnitX());
  series.speed_m_per_s = net_speed(rows, net_speed_span_s);
  Chart chart = stacked_chart(series);
  ChartPanel position =
      panel_over_time("finger [mm]", "",
                      {line(series, "x", palette::blue, {}), line(series, "y", palette::vermillion, {}),
                       line(series, "z", palette::bluish_green, {})},
                      false);
  for (int axis = 0; axis < 3; ++axis) {
    for (const TickRecord& row : rows) {
      position.curves[static_cast<std::size_t>(axis)].y.push_back(row.p_WQ[axis] * 1e3);
    }
  }
  position.least_y_span = least_way_mm;
  chart.panels.push_back(std::move(position));
  add_panels(chart, rows, series, levels);
  chart.panels[1].curves[0].name = fmt::format("in touch, over {:.0f} ms", 1e3 * net_speed_span_s);
  // The direction of a hand that goes anywhere wanders from frame to frame: magnitudes stay put.
  ChartCurve& friction = chart.panels[2].curves[1];
  friction.name = "friction";
  for (std::size_t i = 0; i < rows.size(); ++i) friction.y[i] = rows[i].friction_W_n.norm();
  return chart;
}

Chart spectrum_chart(const TouchSeries& series) {
  Chart chart;
  chart.stacked = true;
  const std::size_t count = evenly_spaced(series.t_s);
  if (count < 32 || !(series.t_s[count - 1] > series.t_s.front())) return chart;
  const double rate_hz = static_cast<double>(count - 1) / (series.t_s[count - 1] - series.t_s.front());
  const auto curve = [rate_hz, count](std::string name, int colour, const std::vector<double>& force_n) {
    const Spectrum spectrum = welch_spectrum(std::span(force_n).first(count), rate_hz);
    // Without its zero: windows have no mean.
    return ChartCurve{std::move(name),
                      {colour, Dash::solid, Marker::none, line_weight},
                      {spectrum.frequency_hz.begin() + 1, spectrum.frequency_hz.end()},
                      {spectrum.density.begin() + 1, spectrum.density.end()}};
  };
  ChartPanel panel{"",
                   "frequency [Hz]",
                   "power density [N\xC2\xB2/Hz]",
                   false,
                   true,
                   {curve(series.friction_name, palette::vermillion, series.friction_n),
                    curve("normal force", palette::blue, series.normal_force_n)}};
  panel.short_y_label = "N\xC2\xB2/Hz";
  // A force that is held constant has no spectrum but that of rounding.
  const auto greatest = [](const ChartCurve& one) { return *std::max_element(one.y.begin(), one.y.end()); };
  const double top = std::max(greatest(panel.curves[0]), greatest(panel.curves[1]));
  std::erase_if(panel.curves, [&](const ChartCurve& one) { return !(greatest(one) > 1e-8 * top); });
  chart.panels.push_back(std::move(panel));
  return chart;
}

}  // namespace fingerpad
