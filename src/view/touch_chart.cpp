#include "view/touch_chart.hpp"

#include <algorithm>
#include <cmath>

#include "friction/law_parameters.hpp"
#include "view/spectrum.hpp"

namespace fingerpad {
namespace {

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

Band phase_band(const std::vector<Phase>& phase) {
  Band band;
  for (const Phase one : {Phase::free, Phase::stick, Phase::slip}) {
    band.keys.push_back({std::string(phase_name(one)), phase_colour(one)});
  }
  for (const Phase one : phase) band.key_at.push_back(static_cast<std::uint8_t>(one));
  return band;
}

/// Values where slip has just given way to stick (the paper's points a, fig. 9). None where they would crowd.
std::vector<double> where_slip_ends(const std::vector<double>& values, const std::vector<Phase>& phase) {
  constexpr int most = 60;
  int count = 0;
  std::vector<double> out(values.size(), TickRecord::nan);
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (phase[i - 1] != Phase::slip || phase[i] != Phase::stick) continue;
    out[i] = values[i];
    ++count;
  }
  if (count > most) out.clear();
  return out;
}

void add_slip_ends(Panel& panel, const std::vector<Phase>& phase) {
  std::vector<double> ends = where_slip_ends(panel.curves.front().y, phase);
  const bool any = std::any_of(ends.begin(), ends.end(), [](double y) { return std::isfinite(y); });
  if (any) panel.curves.push_back({"end of slip", colours::vermillion, CurveStyle::rings, std::move(ends)});
}

/// The panels below the position.
void add_panels(Chart& chart, const TouchSeries& series, const TouchLevels& levels) {
  Panel speed{"tangential speed [mm/s]",
              "speed [mm/s]",
              {{"speed", colours::blue, {}, scaled(series.speed_m_per_s, 1e3)}},
              {}};
  speed.from_zero = true;
  const auto fastest = std::max_element(
      series.speed_m_per_s.begin(), series.speed_m_per_s.end(),
      [](double a, double b) { return (std::isnan(a) ? -1 : a) < (std::isnan(b) ? -1 : b); });
  // v_min far above all speeds would flatten the curve.
  if (fastest != series.speed_m_per_s.end() && *fastest > 0.4 * levels.v_min_m_per_s &&
      levels.v_min_m_per_s > 0) {
    speed.levels.push_back({"v_min", levels.v_min_m_per_s * 1e3, colours::reddish_purple});
  }
  add_slip_ends(speed, series.phase);
  Panel force{"force on the finger [N]",
              "force [N]",
              {{"normal", colours::blue, {}, series.normal_force_n},
               {"friction along " + series.direction_name, colours::vermillion, {}, series.friction_n}},
              {}};
  force.from_zero = true;
  Panel mu{"coefficient of friction [1]", "mu [1]", {{"mu", colours::ink, {}, series.mu}}, {}};
  mu.from_zero = true;
  add_slip_ends(mu, series.phase);
  if (levels.mu_static > 0) mu.levels.push_back({"mu_s", levels.mu_static, colours::bluish_green});
  if (levels.mu_dynamic > 0) mu.levels.push_back({"mu_d", levels.mu_dynamic, colours::orange});
  chart.panels.push_back(std::move(speed));
  chart.panels.push_back(std::move(force));
  chart.panels.push_back(std::move(mu));
}

}  // namespace

TouchLevels touch_levels(const ViewInput& input) {
  TouchLevels levels;
  const auto touched = std::find_if(input.rows.begin(), input.rows.end(),
                                    [](const TickRecord& row) { return row.surface >= 0; });
  const std::size_t surface = touched != input.rows.end() ? static_cast<std::size_t>(touched->surface) : 0;
  if (input.world && surface < input.world->surfaces.size()) {
    levels.mu_static = input.world->surfaces[surface].properties.mu_static;
    levels.mu_dynamic = input.world->surfaces[surface].properties.mu_dynamic;
  }
  if (input.scene) levels.v_min_m_per_s = v_min_m_per_s(input.scene->friction.settings);
  return levels;
}

Chart touch_chart(std::span<const TickRecord> rows, const Vec3& direction_W, const TouchLevels& levels) {
  const TouchSeries series = touch_series(rows, direction_W);
  const std::vector<double> position_mm = scaled(series.position_m, 1e3);
  Chart chart{"time [s]", series.t_s, false, {}, phase_band(series.phase)};
  chart.panels.push_back(
      {"position " + series.direction_name + " [mm]",
       series.direction_name + " [mm]",
       {{"slip, free", colours::blue, CurveStyle::solid, where_phase(position_mm, series.phase, false)},
        {"stick", colours::blue, CurveStyle::dotted, where_phase(position_mm, series.phase, true)},
        {"stick centre", colours::vermillion, CurveStyle::dashed, scaled(series.centre_m, 1e3)}},
       {}});
  add_panels(chart, series, levels);
  return chart;
}

Chart live_chart(std::span<const TickRecord> rows, const TouchLevels& levels) {
  const TouchSeries series = touch_series(rows, Vec3::UnitX());
  Chart chart{"time [s]", series.t_s, false, {}, phase_band(series.phase)};
  Panel position{"finger [mm]",
                 "",
                 {{"x", colours::blue, CurveStyle::solid, {}},
                  {"y", colours::vermillion, CurveStyle::solid, {}},
                  {"z", colours::bluish_green, CurveStyle::solid, {}}},
                 {}};
  for (int axis = 0; axis < 3; ++axis) {
    for (const TickRecord& row : rows) {
      position.curves[static_cast<std::size_t>(axis)].y.push_back(row.p_WQ[axis] * 1e3);
    }
  }
  chart.panels.push_back(std::move(position));
  add_panels(chart, series, levels);
  // The direction of a hand that goes anywhere wanders from frame to frame: magnitudes stay put.
  Curve& friction = chart.panels[2].curves[1];
  friction.label = "friction";
  for (std::size_t i = 0; i < rows.size(); ++i) friction.y[i] = rows[i].friction_W_n.norm();
  return chart;
}

Chart spectrum_chart(const TouchSeries& series) {
  Chart chart{"frequency [Hz]", {}, false, {}, std::nullopt};
  const std::size_t count = series.t_s.size();
  if (count < 32 || !(series.t_s.back() > series.t_s.front())) return chart;
  const double rate_hz = static_cast<double>(count - 1) / (series.t_s.back() - series.t_s.front());
  const Spectrum friction = welch_spectrum(series.friction_n, rate_hz);
  const Spectrum normal = welch_spectrum(series.normal_force_n, rate_hz);
  // Without its zero: windows have no mean.
  chart.x.assign(friction.frequency_hz.begin() + 1, friction.frequency_hz.end());
  Panel panel{"power density [N\xC2\xB2/Hz]",
              "N\xC2\xB2/Hz",
              {{"friction along " + series.direction_name,
                colours::vermillion,
                CurveStyle::solid,
                {friction.density.begin() + 1, friction.density.end()}},
               {"normal force",
                colours::blue,
                CurveStyle::solid,
                {normal.density.begin() + 1, normal.density.end()}}},
              {}};
  panel.logarithmic = true;
  // A force that is held constant has no spectrum but that of rounding.
  const auto greatest = [](const Curve& curve) { return *std::max_element(curve.y.begin(), curve.y.end()); };
  const double top = std::max(greatest(panel.curves[0]), greatest(panel.curves[1]));
  std::erase_if(panel.curves, [&](const Curve& curve) { return !(greatest(curve) > 1e-8 * top); });
  chart.panels.push_back(std::move(panel));
  return chart;
}

}  // namespace fingerpad
