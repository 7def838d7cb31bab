// The chart of a study of a scene.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/number_text.hpp"
#include "scene/scene.hpp"
#include "study/contact_runs.hpp"
#include "study/scene_study.hpp"

namespace fingerpad {
namespace {

/// So that a logarithmic axis can show them, smaller errors are drawn here.
constexpr double least_drawn = 1e-5;

double as_drawn(double share) {
  return std::isfinite(share) ? std::max(share, least_drawn) : share;
}

using Number = double (*)(const ChoicePrice&);
double load_of(const ChoicePrice& price) {
  return price.load();
}

/// One curve for each method with each normals, from the slowest rate to the fastest.
std::vector<ChartCurve> curves_of(const SceneStudy& study, Events events, Number x, Number y) {
  std::vector<ChartCurve> curves;
  for (const ContactVariant& variant : contact_variants()) {
    ChartCurve curve{study.has_meshes ? variant.name() : "planes", variant.style, {}, {}};
    if (events == Events::tick) {
      curve.name.clear();  // told in the chart's notes
      curve.style.dash = Dash::dotted;
    }
    for (const ChoicePrice& price : study.prices) {
      const TouchChoice& choice = price.choice;
      if (choice.method != variant.method_name || choice.normals != variant.normals ||
          choice.events != events)
        continue;
      curve.x.push_back(x(price));
      curve.y.push_back(as_drawn(y(price)));
    }
    if (!curve.x.empty()) curves.push_back(std::move(curve));
  }
  return curves;
}

/// What `auto` takes, and the cheapest.
void mark_choices(const SceneStudyInput& input, const SceneStudy& study, Number x, Number y,
                  ChartPanel& panel) {
  const ChoicePrice& chosen = cheapest(study.prices);
  for (const ChoicePrice& price : study.prices) {
    if (!input.automatic || *input.automatic != price.choice) continue;
    panel.curves.push_back({"what auto chooses",
                            {palette::ink, Dash::none, Marker::ring, 2.6},
                            {x(price)},
                            {as_drawn(y(price))}});
  }
  // Behind the others, as a frame.
  panel.curves.insert(panel.curves.begin(), {chosen.keeps() ? "the cheapest that keeps the tolerances"
                                                            : "the nearest; none keeps them",
                                             {palette::ink, Dash::none, Marker::square, 3.2},
                                             {x(chosen)},
                                             {as_drawn(y(chosen))}});
}

void add_front(ChartPanel& panel) {
  std::vector<std::pair<double, double>> all;
  for (const ChartCurve& curve : panel.curves) {
    for (std::size_t i = 0; i < curve.x.size(); ++i) all.emplace_back(curve.x[i], curve.y[i]);
  }
  panel.pareto_front = pareto_front(std::move(all));
}

const std::string load_label = "processor time per time touched [share of a core]";

ChartPanel contact_panel(const SceneStudyInput& input, const SceneStudy& study) {
  ChartPanel panel{"Contact's force, without friction",
                   load_label,
                   "error on one tick in a hundred [share]",
                   true,
                   true,
                   {},
                   {}};
  const Number y = [](const ChoicePrice& price) { return price.figures.contact_99_share; };
  panel.curves = curves_of(study, Events::exact, load_of, y);
  add_front(panel);
  mark_choices(input, study, load_of, y, panel);
  panel.levels.push_back({"force_tolerance", input.scene.contact.force_tolerance, palette::vermillion});
  return panel;
}

ChartPanel friction_panel(const SceneStudyInput& input, const SceneStudy& study) {
  ChartPanel panel{"Mean coefficient of friction", load_label, "error [share]", true, true, {}, {}};
  const Number y = [](const ChoicePrice& price) { return price.figures.mu_error_share; };
  panel.curves = curves_of(study, Events::exact, load_of, y);
  for (ChartCurve& curve : curves_of(study, Events::tick, load_of, y))
    panel.curves.push_back(std::move(curve));
  add_front(panel);
  mark_choices(input, study, load_of, y, panel);
  panel.levels.push_back({"mu_tolerance", input.scene.contact.mu_tolerance, palette::vermillion});
  return panel;
}

ChartPanel rate_panel(const SceneStudyInput& input, const SceneStudy& study) {
  ChartPanel panel{"What the rate alone costs: the model held from tick to tick",
                   "rate [Hz]",
                   "error [share, RMS]",
                   true,
                   true,
                   {},
                   {}};
  ChartCurve mu{"coefficient of friction", {palette::ink, Dash::solid, Marker::disc, 1}, {}, {}};
  ChartCurve unseen{"teeth under two ticks", {palette::ink, Dash::dotted, Marker::ring, 1}, {}, {}};
  ChartCurve force{"whole force", {palette::grey, Dash::dash_dot, Marker::cross, 1}, {}, {}};
  for (const ChoicePrice& price : study.prices) {
    const RateFigures& rate = price.rate;
    if (!mu.x.empty() && rate.rate_hz <= mu.x.back()) continue;
    mu.x.push_back(rate.rate_hz);
    force.x.push_back(rate.rate_hz);
    unseen.x.push_back(rate.rate_hz);
    unseen.y.push_back(rate.unseen_teeth_share > 0 ? rate.unseen_teeth_share : HUGE_VAL);
    mu.y.push_back(as_drawn(rate.held_mu_share));
    force.y.push_back(as_drawn(rate.held_force_share));
  }
  if (study.has_friction) {
    panel.curves.push_back(std::move(mu));
    panel.curves.push_back(std::move(unseen));
    panel.levels.push_back({"mu_tolerance", input.scene.contact.mu_tolerance, palette::vermillion});
  }
  panel.curves.push_back(std::move(force));
  return panel;
}

ChartPanel whole_force_panel(const SceneStudyInput& input, const SceneStudy& study) {
  ChartPanel panel{
      "Whole force, teeth and all", "time of a whole tick [ns]", "error [share, RMS]", true, true, {}, {}};
  const Number x = [](const ChoicePrice& price) { return price.tick_ns; };
  const Number y = [](const ChoicePrice& price) { return price.figures.force_rms_share; };
  panel.curves = curves_of(study, Events::exact, x, y);
  for (ChartCurve& curve : curves_of(study, Events::tick, x, y)) panel.curves.push_back(std::move(curve));
  add_front(panel);
  double least = HUGE_VAL, most = 0;
  for (const ChartCurve& curve : panel.curves) {
    for (const double share : curve.y) {
      least = std::min(least, share);
      most = std::max(most, share);
    }
  }
  mark_choices(input, study, x, y, panel);
  panel.curves.push_back({"a tick of the model",
                          {palette::grey, Dash::dashed, Marker::none, 1.4},
                          {study.model_tick_ns, study.model_tick_ns},
                          {least, most}});
  return panel;
}

}  // namespace

Chart scene_chart(const SceneStudyInput& input, const SceneStudy& study) {
  Chart chart{
      "choices",
      fmt::format("{}: what each choice costs and what it loses", input.scene.name),
      {fmt::format("Each curve is one method with one kind of normals, from {} to {} Hz, against the model "
                   "({}), over {:.4g} s of the scene's motion.",
                   number_text(std::begin(choice_rates_hz)[0]), number_text(*std::rbegin(choice_rates_hz)),
                   study.model.name(), study.compared_s),
       "Dotted: events at ticks only. Thin dashed lines: the scene's tolerances. Times were measured on the "
       "machine that drew this. Errors "
       "under "
       "1e-5 are drawn there."},
      2,
      {}};
  chart.panels.push_back(contact_panel(input, study));
  if (study.has_friction) chart.panels.push_back(friction_panel(input, study));
  chart.panels.push_back(rate_panel(input, study));
  chart.panels.push_back(whole_force_panel(input, study));
  return chart;
}

}  // namespace fingerpad
