// Figures of slip over time and frequency: 10 and 11.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/spectrum.hpp"
#include "study/fit_figure_parts.hpp"
#include "study/phase_stretch.hpp"
#include "study/position_parabola.hpp"

namespace fingerpad {
namespace {

/// The longest runs of slip, without gaps, longest first.
std::vector<TrialSpan> slip_spans(const FitPictureSource& source) {
  std::vector<TrialSpan> spans;
  for (std::size_t k = 0; k < source.stick.segments.size(); ++k) {
    const StickSegments& segments = source.stick.segments[k];
    const auto half = static_cast<std::size_t>(segments.half_window);
    for (const PhaseStretch& s : phase_stretches(segments, PadPhase::slip))
      if (s.to - s.from > 2 * half + 32) spans.push_back({k, s.from + half, s.to - half});
  }
  std::stable_sort(spans.begin(), spans.end(),
                   [](const TrialSpan& one, const TrialSpan& other) { return one.size() > other.size(); });
  return spans;
}

/// Mean density of spans long enough for a window of a quarter of a second.
struct MeanDensity {
  std::vector<double> frequency_hz, tangential, normal;
  double windows = 0;
};

MeanDensity slip_density(const FitPictureSource& source) {
  MeanDensity mean;
  double rate_hz = 0;
  for (const TrialSpan& span : slip_spans(source)) {
    const MeasuredTrial& trial = source.measurement.trials[span.trial];
    const std::size_t window = vibration_window(trial.rate_hz);
    if (span.size() < window || (rate_hz > 0 && trial.rate_hz != rate_hz)) continue;
    rate_hz = trial.rate_hz;
    std::vector<double> tangential, normal;
    for (std::size_t i = span.from; i < span.to; ++i) {
      const Vec2 way = source.stick.segments[span.trial].velocity_m_per_s[i].normalized();
      tangential.push_back(-trial.normal_force_n[i] * trial.force_ratio[i].dot(way));
      normal.push_back(trial.normal_force_n[i]);
    }
    const Spectrum one = welch_spectrum(tangential, rate_hz, window),
                   other = welch_spectrum(normal, rate_hz, window);
    mean.frequency_hz.assign(one.frequency_hz.begin() + 1, one.frequency_hz.end());
    mean.tangential.resize(mean.frequency_hz.size(), 0);
    mean.normal.resize(mean.frequency_hz.size(), 0);
    const auto weight = static_cast<double>(span.size());
    for (std::size_t k = 0; k < mean.frequency_hz.size(); ++k) {
      mean.tangential[k] += weight * one.density[k + 1];
      mean.normal[k] += weight * other.density[k + 1];
    }
    mean.windows += weight;
  }
  for (std::size_t k = 0; k < mean.frequency_hz.size(); ++k) {
    mean.tangential[k] /= mean.windows;
    mean.normal[k] /= mean.windows;
  }
  return mean;
}

/// The place of a sample beside the parabola through the 50 ms around it: what trembles about a stroke.
double less_stroke_m(const MeasuredTrial& trial, std::size_t i, const Vec2& way) {
  constexpr double half_window_s = 0.025;
  const auto half = static_cast<std::size_t>(std::max(3L, std::lround(half_window_s * trial.rate_hz)));
  const auto stroke = position_parabola(trial, i, half, way);
  return stroke ? trial.position_m[i].dot(way) - stroke->at(0) : std::numeric_limits<double>::quiet_NaN();
}

/// Upright lines where the vibration was found, and where it is half as strong.
void add_vibration(const ProfileFit& fit, ChartPanel& panel) {
  const double peak_hz = fitted_number(fit, PadNumber::vibration),
               width_hz = fitted_number(fit, PadNumber::vibration_bandwidth);
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const ChartCurve& curve : panel.curves) {
    for (const double density : curve.y) {
      if (!(density > 0)) continue;
      least = std::min(least, density);
      most = std::max(most, density);
    }
  }
  if (!std::isfinite(peak_hz) || !(most > 0)) return;
  panel.curves.push_back({fmt::format("vibration, {:.1f} Hz", peak_hz),
                          {palette::ink, Dash::dashed, Marker::none, 1},
                          {peak_hz, peak_hz},
                          {least, most}});
  if (!std::isfinite(width_hz)) return;
  ChartCurve edges{fmt::format("its bandwidth, {:.1f} Hz", width_hz),
                   {palette::grey, Dash::dotted, Marker::none, 1},
                   {},
                   {}};
  for (const double hz : {peak_hz - width_hz / 2, peak_hz + width_hz / 2}) {
    edges.x.insert(edges.x.end(), {hz, hz, hz});
    edges.y.insert(edges.y.end(), {least, most, std::numeric_limits<double>::quiet_NaN()});
  }
  panel.curves.push_back(std::move(edges));
}

}  // namespace

Chart slip_oscillation_figure(const FitPictureSource& source) {
  const std::string title = "A slipping fingertip (paper, fig. 10)";
  const std::vector<TrialSpan> spans = slip_spans(source);
  if (spans.empty()) return refused_figure(title, "no slip was found");
  TrialSpan span = spans.front();
  const MeasuredTrial& trial = source.measurement.trials[span.trial];
  const StickSegments& segments = source.stick.segments[span.trial];
  constexpr double longest_s = 0.3;
  span.to = std::min(span.to, span.from + static_cast<std::size_t>(longest_s * trial.rate_hz));
  const Vec2 way = main_way(segments, span);
  const std::vector<double> t_s = times_of(trial, span);
  Chart chart{"", title, {trial.name + "; positions less the stroke, a parabola over 50 ms"}, 1, {}};
  chart.stacked = true;
  chart.panels.push_back(
      strip("position along the motion, less the stroke [mm]", "position [mm]", palette::blue, t_s,
            over_span(trial, span, [&](std::size_t i) { return 1e3 * less_stroke_m(trial, i, way); })));
  chart.panels.push_back(
      strip("height [mm]", "", palette::sky_blue, t_s, over_span(trial, span, [&](std::size_t i) {
              return 1e3 * (trial.height_m[i] - trial.height_m[span.from]);
            })));
  chart.panels.push_back(strip("tangential force along the motion [N]", "tangential [N]", palette::orange,
                               t_s, over_span(trial, span, [&](std::size_t i) {
                                 return trial.normal_force_n[i] * trial.force_ratio[i].dot(way);
                               })));
  chart.panels.push_back(
      strip("normal force [N]", "normal [N]", palette::bluish_green, t_s,
            over_span(trial, span, [&](std::size_t i) { return trial.normal_force_n[i]; })));
  return chart;
}

Chart slip_spectrum_figure(const FitPictureSource& source) {
  const std::string title = "Power spectral density of the forces in slip (paper, fig. 11)";
  const MeanDensity mean = slip_density(source);
  if (!(mean.windows > 0)) return refused_figure(title, "no slip lasts a quarter of a second");
  Chart chart{
      "",
      title,
      refusal_notes(source.fit, {PadNumber::vibration, PadNumber::vibration_bandwidth}, note_of_one_column),
      1,
      {}};
  ChartPanel panel{"", "frequency [Hz]", "density [N\xC2\xB2/Hz]", false, true, {}};
  panel.curves.push_back({"tangential force",
                          {palette::vermillion, Dash::solid, Marker::none, 1.1},
                          mean.frequency_hz,
                          mean.tangential});
  panel.curves.push_back(
      {"normal force", {palette::blue, Dash::dashed, Marker::none, 1.1}, mean.frequency_hz, mean.normal});
  add_vibration(source.fit, panel);
  chart.panels.push_back(std::move(panel));
  return chart;
}

std::vector<Chart> fit_figures(const FitPictureSource& source) {
  std::vector<Chart> charts;
  for (const FitFigure& row : fit_figure_rows) {
    charts.push_back(row.draw(source));
    charts.back().name = row.name;
  }
  return charts;
}

}  // namespace fingerpad
