// Figures over time and frequency: 9, 10, 11.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/spectrum.hpp"
#include "study/fit_figures.hpp"
#include "study/phase_boundaries.hpp"
#include "study/phase_stretch.hpp"

namespace fingerpad {
namespace {

constexpr double no_sample = std::numeric_limits<double>::quiet_NaN();

/// Samples of one trial.
struct TrialSpan {
  std::size_t trial = 0, from = 0, to = 0;
  std::size_t size() const { return to - from; }
};

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

/// Where slip gives way to stick, though only for what was noise.
std::vector<std::size_t> seeming_ends(const StickSegments& segments) {
  std::vector<std::size_t> ends;
  for (std::size_t i = 1; i < segments.phase.size(); ++i) {
    if (segments.phase[i - 1] == PadPhase::slip && segments.phase[i] == PadPhase::stick &&
        !segments.begins_run[i])
      ends.push_back(i);
  }
  return ends;
}

/// The trial with the most ends of slip that count, and two seconds of it around them; where none counts, of
/// those that seem to be ends.
std::optional<TrialSpan> phase_change_span(const FitPictureSource& source) {
  TrialSpan span;
  std::size_t most = 0;
  const bool any_counts = std::any_of(source.fit.evidence.begin(), source.fit.evidence.end(),
                                      [](const TrialEvidence& trial) { return trial.stops > 0; });
  for (std::size_t k = 0; k < source.stick.segments.size(); ++k) {
    const auto ends =
        any_counts ? source.fit.evidence[k].stop_samples : seeming_ends(source.stick.segments[k]);
    if (ends.size() <= most) continue;
    most = ends.size();
    constexpr double shown_s = 2;
    const auto width = static_cast<std::size_t>(shown_s * source.measurement.trials[k].rate_hz);
    const std::size_t samples = source.measurement.trials[k].t_s.size();
    const std::size_t from = ends.front() > width / 5 ? ends.front() - width / 5 : 0;
    span = {k, from, std::min(samples, from + width)};
  }
  return most > 0 ? std::optional(span) : std::nullopt;
}

/// The direction of most motion in a span, unit.
Vec2 main_way(const StickSegments& segments, const TrialSpan& span) {
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (std::size_t i = span.from; i < span.to; ++i)
    spread += segments.velocity_m_per_s[i] * segments.velocity_m_per_s[i].transpose();
  const double turn = 0.5 * std::atan2(2 * spread(0, 1), spread(0, 0) - spread(1, 1));
  return {std::cos(turn), std::sin(turn)};
}

ChartPanel strip(std::string y_label, std::string short_label, std::string name, int colour,
                 const std::vector<double>& t_s, std::vector<double> y) {
  ChartPanel panel{"", "time [s]", std::move(y_label), false, false, {}};
  panel.short_y_label = std::move(short_label);
  panel.curves.push_back({std::move(name), {colour, Dash::solid, Marker::none, 1.1}, t_s, std::move(y)});
  return panel;
}

/// Values at samples of a span; where a contact begins anew there is a gap.
template <typename Value>
std::vector<double> over_span(const MeasuredTrial& trial, const TrialSpan& span, const Value& value) {
  std::vector<double> values;
  for (std::size_t i = span.from; i < span.to; ++i)
    values.push_back(trial.starts_anew[i] ? no_sample : value(i));
  return values;
}

/// A series less its mean over a window about each sample, which ends cut short on both sides: what trembles
/// about a stroke.
std::vector<double> less_moving_mean(const std::vector<double>& values, std::size_t half) {
  std::vector<double> left;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t reach = std::min({half, i, values.size() - 1 - i});
    double sum = 0;
    for (std::size_t j = i - reach; j <= i + reach; ++j) sum += values[j];
    left.push_back(values[i] - sum / static_cast<double>(2 * reach + 1));
  }
  return left;
}

void add_marks(const TrialEvidence& evidence, const TrialSpan& span, ChartPanel& panel) {
  const ChartCurve& curve = panel.curves.front();
  ChartCurve rings{"end of slip", {palette::vermillion, Dash::none, Marker::ring, 1.2}, {}, {}};
  for (const std::size_t end : evidence.stop_samples) {
    if (end < span.from || end >= span.to) continue;
    rings.x.push_back(curve.x[end - span.from]);
    rings.y.push_back(curve.y[end - span.from]);
  }
  if (!rings.x.empty()) panel.curves.push_back(std::move(rings));
}

/// Where the other phases of a span begin, a mark for each reason.
void add_reasons(const MeasuredTrial& trial, const StickSegments& segments, const TrialSpan& span,
                 ChartPanel& panel) {
  struct ReasonMark {
    BoundaryReason reason;
    Marker marker;
    int colour;
  };
  constexpr ReasonMark marks[] = {{BoundaryReason::touchdown, Marker::square, palette::sky_blue},
                                  {BoundaryReason::rupture, Marker::cross, palette::blue},
                                  {BoundaryReason::spring_gives, Marker::triangle, palette::orange},
                                  {BoundaryReason::hardly_moves, Marker::diamond, palette::reddish_purple},
                                  {BoundaryReason::moves_again, Marker::disc, palette::bluish_green}};
  const ChartCurve& curve = panel.curves.front();
  std::vector<ChartCurve> found;
  for (const ReasonMark& mark : marks) {
    ChartCurve here{std::string(reason_text(mark.reason)), {mark.colour, Dash::none, mark.marker, 1}, {}, {}};
    for (const PhaseBoundary& boundary : phase_boundaries(trial, segments)) {
      if (boundary.reason != mark.reason || boundary.sample < span.from || boundary.sample >= span.to)
        continue;
      here.x.push_back(curve.x[boundary.sample - span.from]);
      here.y.push_back(trial.starts_anew[boundary.sample] ? 0 : curve.y[boundary.sample - span.from]);
    }
    if (!here.x.empty()) found.push_back(std::move(here));
  }
  for (ChartCurve& marked : found) panel.curves.push_back(std::move(marked));
}

/// Rows below one another, over time.
Chart strips(std::string name, std::string title, std::vector<std::string> notes,
             std::vector<ChartPanel> panels) {
  Chart chart{std::move(name), std::move(title), std::move(notes), 1, std::move(panels)};
  return chart;
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

}  // namespace

Chart phase_change_figure(const FitPictureSource& source) {
  const std::string title = "Slip gives way to stick (paper, fig. 9)";
  const auto span = phase_change_span(source);
  if (!span) return strips("figure9", title, {"no slip that ends in stick was found"}, {});
  const MeasuredTrial& trial = source.measurement.trials[span->trial];
  const StickSegments& segments = source.stick.segments[span->trial];
  const Vec2 way = main_way(segments, *span);
  const std::vector<double> t_s(trial.t_s.begin() + static_cast<long>(span->from),
                                trial.t_s.begin() + static_cast<long>(span->to));
  std::vector<ChartPanel> panels;
  panels.push_back(
      strip("velocity along the motion [m/s]", "v [m/s]", "velocity", palette::blue, t_s,
            over_span(trial, *span, [&](std::size_t i) { return segments.velocity_m_per_s[i].dot(way); })));
  if (const double v_min = fitted_number(source.fit, PadNumber::v_min); std::isfinite(v_min)) {
    panels.back().levels.push_back({fmt::format("v_min {:.3g} m/s", v_min), v_min, palette::reddish_purple});
    panels.back().levels.push_back({"", -v_min, palette::reddish_purple});
  }
  panels.push_back(strip("normal force [N]", "n [N]", "normal force", palette::bluish_green, t_s,
                         over_span(trial, *span, [&](std::size_t i) { return trial.normal_force_n[i]; })));
  panels.push_back(strip("tangential force along the motion [N]", "f [N]", "tangential force",
                         palette::orange, t_s, over_span(trial, *span, [&](std::size_t i) {
                           return trial.normal_force_n[i] * trial.force_ratio[i].dot(way);
                         })));
  panels.push_back(
      strip("tangential over normal force [1]", "mu [1]", "their ratio", palette::ink, t_s,
            over_span(trial, *span, [&](std::size_t i) { return trial.force_ratio[i].dot(way); })));
  for (ChartPanel& panel : panels) add_marks(source.fit.evidence[span->trial], *span, panel);
  add_reasons(trial, segments, *span, panels.back());
  std::string told = trial.name;  // the legend is full of reasons
  for (const auto& [number, name] :
       {std::pair(PadNumber::mu_static, "mu_s"), std::pair(PadNumber::mu_dynamic, "mu_d")}) {
    if (const double mu = fitted_number(source.fit, number); std::isfinite(mu)) {
      panels.back().levels.push_back({"", mu, palette::reddish_purple});
      told += fmt::format("; {} {:.3g}", name, mu);
    }
  }
  Chart chart = strips("figure9", title, {told}, std::move(panels));
  chart.stacked = true;
  return chart;
}

Chart slip_oscillation_figure(const FitPictureSource& source) {
  const std::string title = "A slipping fingertip (paper, fig. 10)";
  const std::vector<TrialSpan> spans = slip_spans(source);
  if (spans.empty()) return strips("figure10", title, {"no slip was found"}, {});
  TrialSpan span = spans.front();
  const MeasuredTrial& trial = source.measurement.trials[span.trial];
  const StickSegments& segments = source.stick.segments[span.trial];
  constexpr double shown_s = 0.3;
  span.to = std::min(span.to, span.from + static_cast<std::size_t>(shown_s * trial.rate_hz));
  const Vec2 way = main_way(segments, span);
  const std::vector<double> t_s(trial.t_s.begin() + static_cast<long>(span.from),
                                trial.t_s.begin() + static_cast<long>(span.to));
  std::vector<ChartPanel> panels;
  std::vector<double> way_mm;
  for (std::size_t i = span.from; i < span.to; ++i) way_mm.push_back(1e3 * trial.position_m[i].dot(way));
  constexpr double half_window_s = 0.025;
  const auto half = static_cast<std::size_t>(half_window_s * trial.rate_hz);
  panels.push_back(strip("position along the motion, less its mean over 50 ms [mm]", "x less mean [mm]",
                         "along the motion, less its mean over 50 ms", palette::blue, t_s,
                         less_moving_mean(way_mm, half)));
  panels.push_back(strip("height [mm]", "height [mm]", "height", palette::sky_blue, t_s,
                         over_span(trial, span, [&](std::size_t i) {
                           return 1e3 * (trial.height_m[i] - trial.height_m[span.from]);
                         })));
  panels.push_back(strip("tangential force [N]", "f [N]", "tangential force", palette::orange, t_s,
                         over_span(trial, span, [&](std::size_t i) {
                           return trial.normal_force_n[i] * trial.force_ratio[i].dot(way);
                         })));
  panels.push_back(strip("normal force [N]", "n [N]", "normal force", palette::bluish_green, t_s,
                         over_span(trial, span, [&](std::size_t i) { return trial.normal_force_n[i]; })));
  Chart chart = strips("figure10", title, {trial.name}, std::move(panels));
  chart.stacked = true;
  return chart;
}

Chart slip_spectrum_figure(const FitPictureSource& source) {
  const std::string title = "Power spectral density of the forces in slip (paper, fig. 11)";
  const MeanDensity mean = slip_density(source);
  if (!(mean.windows > 0)) return strips("figure11", title, {"no slip lasts a quarter of a second"}, {});
  std::vector<std::string> notes;
  if (const double hz = fitted_number(source.fit, PadNumber::vibration); std::isfinite(hz))
    notes.push_back(fmt::format("vibration found at {:.1f} Hz", hz));
  ChartPanel panel{"", "frequency [Hz]", "density [N\xC2\xB2/Hz]", false, true, {}};
  panel.curves.push_back({"tangential force",
                          {palette::vermillion, Dash::solid, Marker::none, 1.1},
                          mean.frequency_hz,
                          mean.tangential});
  panel.curves.push_back(
      {"normal force", {palette::blue, Dash::dashed, Marker::none, 1.1}, mean.frequency_hz, mean.normal});
  return strips("figure11", title, std::move(notes), {std::move(panel)});
}

std::vector<Chart> fit_figures(const FitPictureSource& source) {
  return {force_loop_figure(source),         stick_ellipse_figure(source),
          normalised_axes_figure(source),    normalised_ellipses_figure(source),
          force_displacement_figure(source), phase_change_figure(source),
          slip_oscillation_figure(source),   slip_spectrum_figure(source)};
}

}  // namespace fingerpad
