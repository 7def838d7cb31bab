// The table and the chart of a study of a scene.
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

double drawn(double share) {
  return std::isfinite(share) ? std::max(share, least_drawn) : share;
}

bool is_same(const TouchChoice& a, const TouchChoice& b) {
  return a.method == b.method && a.normals == b.normals && a.rate_hz == b.rate_hz && a.events == b.events;
}

/// "auto", "cheapest", both, or nothing.
std::string mark_of(const SceneStudyInput& input, const SceneStudy& study, const ChoicePrice& price) {
  const bool automatic = input.automatic && is_same(*input.automatic, price.choice);
  const bool is_cheapest = &price == &cheapest(study.prices);
  return fmt::format("{}{}{}", automatic ? "auto" : "", automatic && is_cheapest ? " " : "",
                     is_cheapest ? "cheapest" : "");
}

StudyTable table_of(const SceneStudyInput& input, const SceneStudy& study) {
  StudyTable table{"choices",
                   {"method",
                    "normals",
                    "rate_hz",
                    "events",
                    "force_rms_share",
                    "ns_per_tick",
                    "keeps",
                    "force_largest_share",
                    "contact_rms_share",
                    "contact_largest_share",
                    "contact_99_share",
                    "step_beyond_n",
                    "mean_mu",
                    "mu_error_share",
                    "held_mu_share",
                    "held_force_share",
                    "ruptures_missed",
                    "pop_throughs",
                    "ticks",
                    "late_ticks",
                    "load_share",
                    "mark",
                    "loses"},
                   {}};
  const auto count = [](long n) { return static_cast<double>(n); };
  for (const ChoicePrice& p : study.prices) {
    const ForceFigures& f = p.figures;
    table.rows.push_back({p.choice.method,
                          std::string(p.choice.normals->name),
                          p.choice.rate_hz,
                          std::string(events_word(p.choice.events)),
                          f.force_rms_share,
                          p.tick_ns,
                          std::string(p.keeps() ? "true" : "false"),
                          f.force_largest_share,
                          f.contact_rms_share,
                          f.contact_largest_share,
                          f.contact_99_share,
                          f.step_beyond_n,
                          f.mean_mu,
                          f.mu_error_share,
                          p.rate.held_mu_share,
                          p.rate.held_force_share,
                          p.rate.unseen_teeth_share,
                          count(f.ruptures_missed),
                          count(f.pop_throughs),
                          count(f.ticks),
                          count(p.late_ticks),
                          p.load(),
                          mark_of(input, study, p),
                          fmt::format("{}", fmt::join(p.broken, "; "))});
  }
  return table;
}

/// The model's own row, the last: what it costs, against itself.
void add_model(const SceneStudy& study, StudyTable& table) {
  std::vector<StudyTable::Cell> row(table.columns.size(), 0.0);
  const auto put = [&](std::string_view column, StudyTable::Cell value) {
    row[static_cast<std::size_t>(std::find(table.columns.begin(), table.columns.end(), column) -
                                 table.columns.begin())] = std::move(value);
  };
  put("method", study.model.method);
  put("normals", std::string(study.model.normals->name));
  put("rate_hz", study.model.rate_hz);
  put("events", std::string(events_word(study.model.events)));
  put("ns_per_tick", study.model_tick_ns);
  put("keeps", std::string("true"));
  put("mean_mu", study.prices.front().figures.model_mean_mu);
  put("ticks", static_cast<double>(study.model_ticks));
  put("load_share", 1e-9 * study.model_tick_ns * study.model.rate_hz);
  put("mark", std::string("model"));
  put("loses", std::string());
  table.rows.push_back(std::move(row));
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
      curve.y.push_back(drawn(y(price)));
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
    if (!input.automatic || !is_same(*input.automatic, price.choice)) continue;
    panel.curves.push_back(
        {"what auto chooses", {palette::ink, Dash::none, Marker::ring, 2.6}, {x(price)}, {drawn(y(price))}});
  }
  // Behind the others, as a frame.
  panel.curves.insert(panel.curves.begin(), {chosen.keeps() ? "the cheapest that keeps the tolerances"
                                                            : "the nearest; none keeps them",
                                             {palette::ink, Dash::none, Marker::square, 3.2},
                                             {x(chosen)},
                                             {drawn(y(chosen))}});
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
    mu.y.push_back(drawn(rate.held_mu_share));
    force.y.push_back(drawn(rate.held_force_share));
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

Chart chart_of(const SceneStudyInput& input, const SceneStudy& study) {
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

}  // namespace

StudyReport scene_report(const SceneStudyInput& input, const SceneStudy& study) {
  StudyTable table = table_of(input, study);
  add_model(study, table);
  return {{std::move(table)}, {chart_of(input, study)}};
}

}  // namespace fingerpad
