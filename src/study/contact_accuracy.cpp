#include <cmath>
#include <numbers>

#include "study/contact_parts.hpp"
#include "study/contact_runs.hpp"
#include "study/shape_meshes.hpp"

namespace fingerpad {
namespace {

/// What a surface's tessellations gave, one entry a level; the same place in each vector.
struct VariantCurve {
  std::vector<RubError> errors;
  std::vector<RubError>
      near;  ///< with a ball whose centre goes along the exact surface; for the orders alone
  std::vector<double> tick_ns, contact_ns;  ///< of a whole tick with finger-pad, and without friction
  std::vector<double> slowest_ns;           ///< tick of the rub, without friction
};
struct SurfaceResult {
  ExactSurface surface;
  std::vector<double> facet_mm, triangles;
  std::vector<VariantCurve> curves;     ///< one a variant
  std::vector<AutomaticChoice> chosen;  ///< one a level
};

SurfaceResult measured(const ExactSurface& surface) {
  SurfaceResult result{surface, {}, {}, std::vector<VariantCurve>(contact_variants().size()), {}};
  const Rub rub = rub_under(surface, rub_depth_m, 0), near = rub_under(surface, 0, rub_radius_m);
  for (const int level : surface.levels) {
    const auto world = world_of_mesh(surface.mesh(level), surface.name);
    result.facet_mm.push_back(1000 * surface.facet_m(level));
    result.triangles.push_back(world->surfaces[0].part->triangle_count());
    result.chosen.push_back(automatic_choice(*world, 0, rub_force_n));
    for (std::size_t v = 0; v < contact_variants().size(); ++v) {
      result.curves[v].errors.push_back(rub_error(world, surface, contact_variants()[v], rub));
      result.curves[v].near.push_back(rub_error(world, surface, contact_variants()[v], near));
      result.curves[v].tick_ns.push_back(rub_tick_ns(world, contact_variants()[v], rub, "finger-pad"));
      result.curves[v].contact_ns.push_back(rub_tick_ns(world, contact_variants()[v], rub, "none"));
      result.curves[v].slowest_ns.push_back(rub_slowest_tick_ns(world, contact_variants()[v], rub, "none"));
    }
  }
  return result;
}

/// A panel of one number of every variant against the facets' size.
template <typename Number>
ChartPanel panel_by_facet(const SurfaceResult& result, const std::string& title, const std::string& y_label,
                          Number number) {
  ChartPanel panel{title, "size of a facet across the curve [mm]", y_label, true, true, {}, {}};
  for (std::size_t v = 0; v < result.curves.size(); ++v) {
    ChartCurve series{contact_variants()[v].name(), contact_variants()[v].style, result.facet_mm, {}};
    for (const RubError& error : result.curves[v].errors) series.y.push_back(number(error));
    panel.curves.push_back(std::move(series));
  }
  return panel;
}

/// The slope between the two finest tessellations.
double order_of(const std::vector<double>& facet_mm, double coarser, double finest) {
  const std::size_t n = facet_mm.size();
  return std::log(coarser / finest) / std::log(facet_mm[n - 2] / facet_mm[n - 1]);
}

std::string title_of(const ExactSurface& surface) {
  return surface.name + ": " + surface.words;
}

void tell_accuracy(StudyReport& report, const std::vector<SurfaceResult>& results) {
  StudyTable table{"contact_accuracy",
                   {"surface", "triangles", "facet_m", "method", "normals", "position_rms_m",
                    "position_worst_m", "normal_rms_rad", "normal_worst_rad", "force_rms_share",
                    "force_worst_share", "force_step_share", "exact_force_step_share", "lost_ticks"},
                   {}};
  Chart chart{
      "contact_accuracy",
      "Position and normal of the contact against the exact surface",
      {"A point finger rubs 1 mm deep, every vertex on the exact surface; root mean squares over "
       "4000 ticks. contact_orders.csv has the slopes.",
       "Interpolated normals are of second order at the surface alone: a deep finger's foot on a facet is "
       "off by "
       "its depth times the facet's tilt."},
      2,
      {}};
  for (const SurfaceResult& r : results) {
    chart.panels.push_back(panel_by_facet(r, title_of(r.surface), "position off the surface [um]",
                                          [](const RubError& e) { return 1e6 * e.position_rms_m; }));
    chart.panels.push_back(
        panel_by_facet(r, title_of(r.surface), "normal off by [deg]",
                       [](const RubError& e) { return e.normal_rms_rad * 180 / std::numbers::pi; }));
    for (std::size_t v = 0; v < r.curves.size(); ++v) {
      const ContactVariant& variant = contact_variants()[v];
      const std::vector<RubError>& errors = r.curves[v].errors;
      for (std::size_t i = 0; i < errors.size(); ++i) {
        const RubError& e = errors[i];
        table.rows.push_back({r.surface.name, r.triangles[i], r.facet_mm[i] / 1000, variant.method_name,
                              variant.normals_name, e.position_rms_m, e.position_worst_m, e.normal_rms_rad,
                              e.normal_worst_rad, e.force_rms_share, e.force_worst_share, e.step_share,
                              e.exact_step_share, static_cast<double>(e.lost_ticks)});
      }
    }
  }
  report.tables.push_back(std::move(table));
  report.charts.push_back(std::move(chart));
}

void tell_orders(StudyReport& report, const std::vector<SurfaceResult>& results) {
  StudyTable table{
      "contact_orders",
      {"surface", "rub", "method", "normals", "position_order", "normal_order", "excess_step_order"},
      {}};
  for (const SurfaceResult& r : results) {
    for (const bool near : {false, true}) {
      for (std::size_t v = 0; v < r.curves.size(); ++v) {
        const ContactVariant& variant = contact_variants()[v];
        const std::vector<RubError>& errors = near ? r.curves[v].near : r.curves[v].errors;
        const RubError &coarser = errors[errors.size() - 2], &finest = errors.back();
        table.rows.push_back({r.surface.name, near ? "centre on the surface" : "1 mm deep",
                              variant.method_name, variant.normals_name,
                              order_of(r.facet_mm, coarser.position_rms_m, finest.position_rms_m),
                              order_of(r.facet_mm, coarser.normal_rms_rad, finest.normal_rms_rad),
                              order_of(r.facet_mm, coarser.step_share - coarser.exact_step_share,
                                       finest.step_share - finest.exact_step_share)});
      }
    }
  }
  report.tables.push_back(std::move(table));
}

const std::vector<double> edge_speeds_m_per_s{0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2};

/// Steps over a right-angled edge, which no tessellation makes smoother: against the finger's speed.
ChartPanel edge_panel(StudyTable& table) {
  ChartPanel panel{"a right-angled edge: a point 3 mm deep slides off",
                   "speed of the finger [m/s]",
                   "force step [share of the force]",
                   true,
                   true,
                   {},
                   {}};
  const auto block = world_of_mesh(plate_mesh(0.02), "block");
  for (const ContactVariant& variant : contact_variants()) {
    ChartCurve series{variant.name(), variant.style, edge_speeds_m_per_s, {}};
    for (const double speed : edge_speeds_m_per_s) {
      series.y.push_back(edge_step_share(block, variant, speed));
      table.rows.push_back({variant.method_name, variant.normals_name, speed, series.y.back()});
    }
    panel.curves.push_back(std::move(series));
  }
  return panel;
}

void tell_steps(StudyReport& report, const std::vector<SurfaceResult>& results) {
  Chart chart{
      "contact_force_step",
      "Largest change of force from one tick to the next",
      {"The rubs of contact_accuracy at 1 kHz, without friction. Where a curve meets the dotted line, the "
       "surface itself turns under the finger by as much.",
       "Over an edge the closest point turns the force within one tick, whatever the speed; the proxy lets "
       "go "
       "within a motion."},
      2,
      {}};
  for (const SurfaceResult& r : results) {
    ChartPanel panel = panel_by_facet(r, title_of(r.surface), "force step [share of the force]",
                                      [](const RubError& e) { return e.step_share; });
    panel.curves.push_back({"the exact surface",
                            {5, Dash::dotted, Marker::none, 1.2},
                            r.facet_mm,
                            std::vector<double>(r.facet_mm.size(), r.curves[0].errors[0].exact_step_share)});
    panel.curves.push_back({"can be felt: 7 %",
                            {7, Dash::dash_dot, Marker::none, 0.7},
                            r.facet_mm,
                            std::vector<double>(r.facet_mm.size(), 0.07)});
    chart.panels.push_back(std::move(panel));
  }
  StudyTable table{"contact_edge_steps", {"method", "normals", "speed_m_per_s", "force_step_share"}, {}};
  chart.panels.push_back(edge_panel(table));
  report.tables.push_back(std::move(table));
  report.charts.push_back(std::move(chart));
}

/// What `auto` chooses at each tessellation, on the chart of costs.
ChartCurve chosen_points(const SurfaceResult& r) {
  ChartCurve points{"what auto chooses", {5, Dash::none, Marker::ring, 2.4}, {}, {}};
  for (std::size_t i = 0; i < r.chosen.size(); ++i) {
    const VariantCurve& curve =
        r.curves[static_cast<std::size_t>(r.chosen[i].variant - contact_variants().data())];
    points.x.push_back(curve.tick_ns[i]);
    points.y.push_back(curve.errors[i].force_rms_share);
  }
  return points;
}

void tell_choices(StudyReport& report, const std::vector<SurfaceResult>& results) {
  StudyTable table{
      "contact_choice", {"surface", "triangles", "method", "normals", "force_rms_share", "why"}, {}};
  for (const SurfaceResult& r : results) {
    for (std::size_t i = 0; i < r.chosen.size(); ++i) {
      const ContactVariant& variant = *r.chosen[i].variant;
      const auto& curve = r.curves[static_cast<std::size_t>(&variant - contact_variants().data())];
      table.rows.push_back({r.surface.name, r.triangles[i], variant.method_name, variant.normals_name,
                            curve.errors[i].force_rms_share, r.chosen[i].reason});
    }
  }
  report.tables.push_back(std::move(table));
}

/// A panel of one time of every variant against the part's size.
ChartPanel time_panel(const SurfaceResult& r, const std::string& title, const std::string& y_label,
                      std::vector<double> VariantCurve::*times_ns) {
  ChartPanel panel{r.surface.name + ": " + title, "triangles", y_label, true, true, {}, {}};
  for (std::size_t v = 0; v < r.curves.size(); ++v)
    panel.curves.push_back(
        {contact_variants()[v].name(), contact_variants()[v].style, r.triangles, r.curves[v].*times_ns});
  return panel;
}

void tell_costs(StudyReport& report, const std::vector<SurfaceResult>& results) {
  StudyTable table{"contact_cost_measured",
                   {"surface", "triangles", "method", "normals", "whole_tick_ns", "without_friction_ns",
                    "slowest_without_friction_ns", "force_rms_share"},
                   {}};
  Chart chart{
      "contact_speed_against_accuracy_measured",
      "Contact: speed against accuracy",
      {"Each curve is one method and one kind of normals, from the coarse to the fine tessellation. "
       "Whole ticks with finger-pad friction,",
       "slow enough to stick anew every other tick, in a warm cache; times were measured on the machine that "
       "drew this. auto keeps 3 % of the "
       "force "
       "up to 10 N, at the least cost."},
      2,
      {}};
  for (const SurfaceResult& r : results) {
    ChartPanel panel{
        title_of(r.surface), "time of a whole tick [ns]", "force error [share, RMS]", true, true, {}, {}};
    std::vector<std::pair<double, double>> all;
    for (std::size_t v = 0; v < r.curves.size(); ++v) {
      const ContactVariant& variant = contact_variants()[v];
      ChartCurve series{variant.name(), variant.style, r.curves[v].tick_ns, {}};
      for (std::size_t i = 0; i < r.triangles.size(); ++i) {
        series.y.push_back(r.curves[v].errors[i].force_rms_share);
        all.emplace_back(series.x[i], series.y[i]);
        table.rows.push_back({r.surface.name, r.triangles[i], variant.method_name, variant.normals_name,
                              series.x[i], r.curves[v].contact_ns[i], r.curves[v].slowest_ns[i],
                              series.y[i]});
      }
      panel.curves.push_back(std::move(series));
    }
    panel.pareto_front = pareto_front(all);
    panel.curves.push_back(chosen_points(r));
    chart.panels.push_back(std::move(panel));
  }
  const std::string slowest = "slowest tick of the rub, without friction [ns]";
  const SurfaceResult &torus = results[1], &fillet = results[2];
  chart.panels.push_back(
      time_panel(torus, "by the part's size", "time of a whole tick [ns]", &VariantCurve::tick_ns));
  chart.panels.push_back(time_panel(torus, "the worst tick", slowest, &VariantCurve::slowest_ns));
  chart.panels.push_back(time_panel(fillet, "the worst tick", slowest, &VariantCurve::slowest_ns));
  report.tables.push_back(std::move(table));
  report.charts.push_back(std::move(chart));
}

}  // namespace

void study_contact_accuracy(StudyReport& report, int most_levels, const StudyProgress& progress) {
  std::vector<SurfaceResult> results;
  for (const ExactSurface& surface : exact_surfaces(most_levels)) {
    progress(title_of(surface));
    results.push_back(measured(surface));
  }
  tell_accuracy(report, results);
  tell_orders(report, results);
  tell_steps(report, results);
  tell_choices(report, results);
  tell_costs(report, results);
}

}  // namespace fingerpad
