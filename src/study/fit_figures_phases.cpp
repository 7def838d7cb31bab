// Figure 9, and where the phases of a trial begin and why.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "study/fit_figure_parts.hpp"
#include "study/phase_boundaries.hpp"

namespace fingerpad {
namespace {

constexpr double shown_s = 2;

/// Samples at which a trial slows below v_min, after it was a tenth faster.
std::vector<std::size_t> slows_below(const StickSegments& segments, double v_min) {
  constexpr double faster = 1.1;
  std::vector<std::size_t> found;
  bool was_faster = false;
  for (std::size_t i = 0; i < segments.velocity_m_per_s.size(); ++i) {
    const double speed = segments.velocity_m_per_s[i].norm();
    if (was_faster && speed < v_min) found.push_back(i);
    was_faster = speed > faster * v_min || (was_faster && speed >= v_min);
  }
  return found;
}

/// Moments of every trial.
using TrialMoments = std::vector<std::vector<std::size_t>>;

/// The ends of slip that v_min rests on; where it is told by a step of friction, where that is passed.
TrialMoments ends_of_slip(const FitPictureSource& source) {
  TrialMoments moments;
  for (std::size_t k = 0; k < source.stick.segments.size(); ++k)
    moments.push_back(source.fit.v_min_by_step
                          ? slows_below(source.stick.segments[k], fitted_number(source.fit, PadNumber::v_min))
                          : source.fit.evidence[k].stop_samples);
  return moments;
}

/// Two seconds of the trial that has most moments in so long, and a little before them.
TrialSpan span_of_most(const FitPictureSource& source, const TrialMoments& moments) {
  TrialSpan span;
  std::size_t most = 0;
  for (std::size_t k = 0; k < moments.size(); ++k) {
    const MeasuredTrial& trial = source.measurement.trials[k];
    const auto width = static_cast<std::size_t>(shown_s * trial.rate_hz);
    std::vector<std::size_t> own = moments[k];
    std::sort(own.begin(), own.end());
    for (std::size_t first = 0; first < own.size(); ++first) {
      const std::size_t from = own[first] > width / 5 ? own[first] - width / 5 : 0;
      const auto within = static_cast<std::size_t>(std::lower_bound(own.begin(), own.end(), from + width) -
                                                   (own.begin() + static_cast<long>(first)));
      if (within <= most) continue;
      most = within;
      span = {k, from, std::min(trial.t_s.size(), from + width)};
    }
  }
  return span;
}

void add_rings(const std::vector<std::size_t>& moments, const std::string& name, const TrialSpan& span,
               ChartPanel& panel) {
  const ChartCurve& curve = panel.curves.front();
  ChartCurve rings{name, {palette::vermillion, Dash::none, Marker::ring, 1.2}, {}, {}};
  for (const std::size_t at : moments) {
    if (at < span.from || at >= span.to) continue;
    rings.x.push_back(curve.x[at - span.from]);
    rings.y.push_back(curve.y[at - span.from]);
  }
  if (!rings.x.empty()) panel.curves.push_back(std::move(rings));
}

/// A number's level, either way of the motion.
void add_levels(const ProfileFit& fit, PadNumber number, const char* name, const char* unit, int colour,
                ChartPanel& panel) {
  const double value = fitted_number(fit, number);
  if (!std::isfinite(value)) return;
  panel.levels.push_back({fmt::format("{} {:.3g}{}", name, value, unit), value, colour});
  panel.levels.push_back({"", -value, colour});
}

ChartPanel speed_strip(const MeasuredTrial& trial, const StickSegments& segments, const TrialSpan& span,
                       const Vec2& way) {
  return strip("velocity along the motion [m/s]", "velocity [m/s]", palette::blue, times_of(trial, span),
               over_span(trial, span, [&](std::size_t i) { return segments.velocity_m_per_s[i].dot(way); }));
}

ChartPanel ratio_strip(const MeasuredTrial& trial, const TrialSpan& span, const Vec2& way) {
  return strip("tangential over normal force [1]", "ratio [1]", palette::ink, times_of(trial, span),
               over_span(trial, span, [&](std::size_t i) { return trial.force_ratio[i].dot(way); }));
}

/// A mark for each reason at which a phase of a span begins.
void add_reasons(const MeasuredTrial& trial, const std::vector<PhaseBoundary>& boundaries,
                 const TrialSpan& span, ChartPanel& panel) {
  struct ReasonMark {
    BoundaryReason reason;
    Marker marker;
    int colour;
  };
  constexpr ReasonMark marks[] = {{BoundaryReason::touchdown, Marker::square, palette::grey},
                                  {BoundaryReason::rupture, Marker::cross, palette::vermillion},
                                  {BoundaryReason::spring_gives, Marker::triangle, palette::orange},
                                  {BoundaryReason::spring_holds, Marker::disc, palette::bluish_green},
                                  {BoundaryReason::hardly_moves, Marker::diamond, palette::reddish_purple},
                                  {BoundaryReason::moves_again, Marker::ring, palette::blue}};
  const ChartCurve curve = panel.curves.front();
  for (const ReasonMark& mark : marks) {
    ChartCurve here{std::string(reason_text(mark.reason)), {mark.colour, Dash::none, mark.marker, 1}, {}, {}};
    for (const PhaseBoundary& boundary : boundaries) {
      if (boundary.reason != mark.reason || boundary.sample < span.from || boundary.sample >= span.to)
        continue;
      here.x.push_back(curve.x[boundary.sample - span.from]);
      here.y.push_back(trial.starts_anew[boundary.sample] ? 0 : curve.y[boundary.sample - span.from]);
    }
    if (!here.x.empty()) panel.curves.push_back(std::move(here));
  }
}

/// The phases of a span.
ChartBand phase_strip(const MeasuredTrial& trial, const StickSegments& segments, const TrialSpan& span) {
  ChartBand band{"phase",
                 {{std::string(phase_text(PadPhase::unknown)), {150, 156, 164}},
                  {std::string(phase_text(PadPhase::stick)), colours::bluish_green},
                  {std::string(phase_text(PadPhase::slip)), colours::orange}},
                 times_of(trial, span),
                 {}};
  for (std::size_t i = span.from; i < span.to; ++i)
    band.key_at.push_back(static_cast<std::size_t>(segments.phase[i]));
  return band;
}

/// Of what the levels are that fig. 9 draws over one trial.
std::string levels_note(const FitPictureSource& source, const MeasuredTrial& trial) {
  std::string names = "v_min";
  bool has_mu = false;
  for (const auto& [number, name] :
       {std::pair(PadNumber::mu_static, ", mu_s"), std::pair(PadNumber::mu_dynamic, ", mu_d")}) {
    if (!value_of(source.fit.values, number).refusal.empty()) continue;
    names += name;
    has_mu = true;
  }
  const std::size_t subjects = subjects_in(source.measurement).size();
  return fmt::format(
      "{}: the profile's{}, of {}", names, has_mu ? fmt::format(" (at {:.3g} N)", source.fit.mu_load_n) : "",
      subjects > 1 ? fmt::format("all {} subjects; the strips: subject {}'s alone", subjects, trial.subject)
                   : "all trials");
}

/// What of the local stiffness is of interest: its border lies in the middle of it.
ChartPanel stiffness_strip(const MeasuredTrial& trial, const StickSegments& segments, const TrialSpan& span) {
  const std::vector<double> per_m = local_stiffness_per_m(trial, segments);
  const double least = -segments.border_per_m, most = 6 * segments.border_per_m;
  ChartPanel panel =
      strip("local stiffness [1/m]", "stiffness [1/m]", palette::blue, times_of(trial, span),
            over_span(trial, span, [&](std::size_t i) { return std::clamp(per_m[i], least, most); }));
  panel.levels.push_back({fmt::format("border: slip below {:.3g}/m", segments.border_per_m),
                          segments.border_per_m, palette::reddish_purple});
  return panel;
}

}  // namespace

Chart phase_change_figure(const FitPictureSource& source) {
  const std::string title = "Slip gives way to stick (paper, fig. 9)";
  const PadValue& v_min = value_of(source.fit.values, PadNumber::v_min);
  if (!v_min.refusal.empty()) return refused_figure(title, "v_min_m_per_s refused: " + v_min.refusal);
  const TrialMoments moments = ends_of_slip(source);
  const TrialSpan span = span_of_most(source, moments);
  if (span.size() == 0) return refused_figure(title, "no trial shows an end of slip by itself");
  const MeasuredTrial& trial = source.measurement.trials[span.trial];
  const StickSegments& segments = source.stick.segments[span.trial];
  const Vec2 way = main_way(segments, span);
  Chart chart{"", title, {trial.name}, 1, {}};
  chart.stacked = true;
  chart.panels.push_back(speed_strip(trial, segments, span, way));
  add_levels(source.fit, PadNumber::v_min, "v_min", " m/s", palette::reddish_purple, chart.panels.back());
  const std::vector<double> t_s = times_of(trial, span);
  chart.panels.push_back(
      strip("normal force [N]", "normal [N]", palette::bluish_green, t_s,
            over_span(trial, span, [&](std::size_t i) { return trial.normal_force_n[i]; })));
  chart.panels.push_back(strip("tangential force along the motion [N]", "tangential [N]", palette::orange,
                               t_s, over_span(trial, span, [&](std::size_t i) {
                                 return trial.normal_force_n[i] * trial.force_ratio[i].dot(way);
                               })));
  chart.panels.push_back(ratio_strip(trial, span, way));
  add_levels(source.fit, PadNumber::mu_static, "mu_s", "", palette::bluish_green, chart.panels.back());
  add_levels(source.fit, PadNumber::mu_dynamic, "mu_d", "", palette::orange, chart.panels.back());
  for (ChartPanel& panel : chart.panels)
    add_rings(moments[span.trial], source.fit.v_min_by_step ? "slows below v_min" : "end of slip", span,
              panel);
  add_note(levels_note(source, trial), note_of_strips, chart);
  for (std::string& note :
       refusal_notes(source.fit, {PadNumber::mu_static, PadNumber::mu_dynamic}, note_of_strips))
    chart.notes.push_back(std::move(note));
  return chart;
}

Chart phase_boundaries_figure(const FitPictureSource& source) {
  const std::string title = "Where stick and slip begin, and why";
  TrialMoments moments;
  std::vector<std::vector<PhaseBoundary>> boundaries;
  for (std::size_t k = 0; k < source.stick.segments.size(); ++k) {
    boundaries.push_back(phase_boundaries(source.measurement.trials[k], source.stick.segments[k]));
    moments.emplace_back();
    for (const PhaseBoundary& boundary : boundaries.back())
      if (boundary.reason != BoundaryReason::rupture && boundary.before != boundary.after)
        moments.back().push_back(boundary.sample);
  }
  const TrialSpan span = span_of_most(source, moments);
  if (span.size() == 0)
    return refused_figure(title, moments.empty() ? "no trial has contact" : "no phase is told in any trial");
  const MeasuredTrial& trial = source.measurement.trials[span.trial];
  const StickSegments& segments = source.stick.segments[span.trial];
  const Vec2 way = main_way(segments, span);
  Chart chart{"", title, {trial.name + "; boundaries.csv has those of all trials"}, 1, {}};
  if (segments.is_too_noisy) chart.notes.emplace_back("too noisy for its load: its phases are not told");
  chart.stacked = true;
  chart.band = phase_strip(trial, segments, span);
  chart.panels.push_back(ratio_strip(trial, span, way));
  chart.panels.back().curves.front().name = "ratio";  // the legend is full of reasons
  add_reasons(trial, boundaries[span.trial], span, chart.panels.back());
  chart.panels.push_back(stiffness_strip(trial, segments, span));
  chart.panels.push_back(speed_strip(trial, segments, span, way));
  return chart;
}

StudyTable boundaries_table(const FitPictureSource& source) {
  StudyTable table{"boundaries", {"trial", "t_s", "before", "after", "why"}, {}};
  for (std::size_t k = 0; k < source.stick.segments.size(); ++k) {
    const MeasuredTrial& trial = source.measurement.trials[k];
    for (const PhaseBoundary& boundary : phase_boundaries(trial, source.stick.segments[k]))
      table.rows.push_back({trial.name, trial.t_s[boundary.sample], std::string(phase_text(boundary.before)),
                            std::string(phase_text(boundary.after)),
                            std::string(reason_text(boundary.reason))});
  }
  return table;
}

}  // namespace fingerpad
