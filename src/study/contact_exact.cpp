#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>

#include "study/contact_exact_findings.hpp"
#include "study/contact_parts.hpp"

namespace fingerpad {
namespace {

const std::string facet_label = "mean width of the curved faces' facets [mm]";
constexpr double um = 1e6, degrees = 180 / std::numbers::pi;

std::string words_of(const std::string& path) {
  return "a rub over the " + path + ", 1 mm deep";
}

/// A panel of a number of every variant over a path.
template <typename Number>
ChartPanel path_panel(const ExactFindings& found, std::size_t p, const std::string& y_label, Number number) {
  ChartPanel panel{words_of(found.path_names[p]), facet_label, y_label, true, true, {}, {}};
  for (std::size_t v = 0; v < contact_variants().size(); ++v) {
    ChartCurve series{contact_variants()[v].name(), contact_variants()[v].style, found.facet_mm, {}};
    for (const RubError& error : found.paths[p][v].deep) series.y.push_back(number(error));
    panel.curves.push_back(std::move(series));
  }
  return panel;
}

/// A panel of a number of every kind of normals at the samples.
template <typename Number>
ChartPanel sample_panel(const ExactFindings& found, const std::string& y_label, Number number) {
  ChartPanel panel{"points within 2 mm of the whole part", facet_label, y_label, true, true, {}, {}};
  for (std::size_t n = 0; n < found.samples.size(); ++n) {
    ChartCurve series{contact_variants()[n].name(), contact_variants()[n].style, found.facet_mm, {}};
    for (const SampleError& error : found.samples[n]) series.y.push_back(number(error));
    panel.curves.push_back(std::move(series));
  }
  return panel;
}

/// Adds straight lines to hold the curves against: from above the first curve's coarsest mesh, falling with
/// these powers of the facets' size.
void add_orders(ChartPanel& panel, int low, int high) {
  const ChartCurve first = panel.curves.front();
  for (const int order : {low, high}) {
    constexpr int colours[] = {7, 5, 7};
    ChartCurve line{"order " + std::to_string(order),
                    {colours[order - 1], order == 2 ? Dash::dotted : Dash::dash_dot, Marker::none,
                     order == 3 ? 0.5 : 0.9},
                    first.x,
                    {}};
    for (const double facet_mm : first.x)
      line.y.push_back(1.4 * first.y.front() * std::pow(facet_mm / first.x.front(), order));
    panel.curves.push_back(std::move(line));
  }
}

void tell_accuracy(StudyReport& report, const ExactFindings& found) {
  Chart chart{"contact_exact_accuracy",
              "Position and normal of the contact against a CAD part's exact surface",
              {"One solid's tessellations against its exact faces (scenes/exact); root mean squares, normals "
               "where no sharp edge is near. contact_exact_orders.csv has the slopes.",
               "Beside fillets and on irregular triangles interpolated normals are of first order, and a "
               "proxy stands on the facets, whatever its normals."},
              2,
              {}};
  const auto add = [&chart](ChartPanel position, ChartPanel normal) {
    add_orders(position, 2, 3);
    add_orders(normal, 1, 2);
    chart.panels.push_back(std::move(position));
    chart.panels.push_back(std::move(normal));
  };
  for (std::size_t p = 0; p < found.paths.size(); ++p) {
    add(path_panel(found, p, "depth off by [um]", [](const RubError& e) { return um * e.position_rms_m; }),
        path_panel(found, p, "normal off by [deg]",
                   [](const RubError& e) { return degrees * e.normal_rms_rad; }));
  }
  add(sample_panel(found, "distance off by [um]", [](const SampleError& e) { return um * e.distance_rms_m; }),
      sample_panel(found, "normal off by [deg]",
                   [](const SampleError& e) { return degrees * e.normal_rms_rad; }));
  report.charts.push_back(std::move(chart));
}

void tell_samples(StudyReport& report, const ExactFindings& found) {
  StudyTable table{"contact_exact_samples",
                   {"triangles", "facet_m", "normals", "distance_rms_m", "distance_worst_m", "normal_rms_rad",
                    "normal_worst_rad", "samples", "normal_samples"},
                   {}};
  for (std::size_t n = 0; n < found.samples.size(); ++n) {
    for (std::size_t i = 0; i < found.facet_mm.size(); ++i) {
      const SampleError& e = found.samples[n][i];
      table.rows.push_back({found.triangles[i], found.facet_mm[i] / 1000, contact_variants()[n].normals_name,
                            e.distance_rms_m, e.distance_worst_m, e.normal_rms_rad, e.normal_worst_rad,
                            found.sample_count, static_cast<double>(e.normals)});
    }
  }
  report.tables.push_back(std::move(table));
}

void tell_rubs(StudyReport& report, const ExactFindings& found) {
  StudyTable table{"contact_exact_rubs",
                   {"path", "triangles", "facet_m", "method", "normals", "depth_rms_m", "depth_worst_m",
                    "normal_rms_rad", "normal_worst_rad", "force_rms_share", "force_worst_share",
                    "force_step_share", "exact_force_step_share", "lost_ticks"},
                   {}};
  for (std::size_t p = 0; p < found.paths.size(); ++p) {
    for (std::size_t v = 0; v < contact_variants().size(); ++v) {
      const ContactVariant& variant = contact_variants()[v];
      const PathCurve& curve = found.paths[p][v];
      for (std::size_t i = 0; i < curve.deep.size(); ++i) {
        const RubError& e = curve.deep[i];
        table.rows.push_back({found.path_names[p], found.triangles[i], found.facet_mm[i] / 1000,
                              variant.method_name, variant.normals_name, e.position_rms_m, e.position_worst_m,
                              e.normal_rms_rad, e.normal_worst_rad, e.force_rms_share, e.force_worst_share,
                              e.step_share, e.exact_step_share, static_cast<double>(e.lost_ticks)});
      }
    }
  }
  report.tables.push_back(std::move(table));
}

void tell_strikes(StudyReport& report, const ExactFindings& found) {
  StudyTable table{
      "contact_exact_strikes", {"triangles", "method", "normals", "strikes", "pop_throughs"}, {}};
  for (std::size_t v = 0; v < contact_variants().size(); ++v) {
    for (std::size_t i = 0; i < found.triangles.size(); ++i) {
      const StrikeCount& count = found.strikes[v][i];
      table.rows.push_back({found.triangles[i], contact_variants()[v].method_name,
                            contact_variants()[v].normals_name, static_cast<double>(count.strikes),
                            static_cast<double>(count.pops)});
    }
  }
  report.tables.push_back(std::move(table));
}

/// The slope between the two finest meshes.
double order_of(const ExactFindings& found, double coarser, double finest) {
  const std::size_t n = found.facet_mm.size();
  return std::log(coarser / finest) / std::log(found.facet_mm[n - 2] / found.facet_mm[n - 1]);
}

void tell_orders(StudyReport& report, const ExactFindings& found) {
  StudyTable table{
      "contact_exact_orders", {"where", "rub", "method", "normals", "position_order", "normal_order"}, {}};
  const std::size_t finest = found.facet_mm.size() - 1;
  for (std::size_t n = 0; n < found.samples.size(); ++n) {
    const SampleError &a = found.samples[n][finest - 1], &b = found.samples[n][finest];
    table.rows.push_back({"samples", "none", contact_variants()[n].method_name,
                          contact_variants()[n].normals_name,
                          order_of(found, a.distance_rms_m, b.distance_rms_m),
                          order_of(found, a.normal_rms_rad, b.normal_rms_rad)});
  }
  for (std::size_t p = 0; p < found.paths.size(); ++p) {
    for (const bool near : {false, true}) {
      for (std::size_t v = 0; v < contact_variants().size(); ++v) {
        const PathCurve& curve = found.paths[p][v];
        const std::vector<RubError>& errors = near ? curve.near : curve.deep;
        const RubError &a = errors[finest - 1], &b = errors[finest];
        table.rows.push_back({found.path_names[p], near ? "centre on the surface" : "1 mm deep",
                              contact_variants()[v].method_name, contact_variants()[v].normals_name,
                              order_of(found, a.position_rms_m, b.position_rms_m),
                              order_of(found, a.normal_rms_rad, b.normal_rms_rad)});
      }
    }
  }
  report.tables.push_back(std::move(table));
}

void tell_choices(StudyReport& report, const ExactFindings& found) {
  StudyTable table{"contact_exact_choice", {"triangles", "method", "normals", "why"}, {}};
  for (std::size_t i = 0; i < found.triangles.size(); ++i) {
    const AutomaticChoice& choice = found.chosen[i];
    table.rows.push_back(
        {found.triangles[i], choice.variant->method_name, choice.variant->normals_name, choice.reason});
  }
  report.tables.push_back(std::move(table));
}

void tell_steps(StudyReport& report, const ExactFindings& found) {
  Chart chart{"contact_exact_force_step",
              "Largest change of force from one tick to the next, on a CAD part",
              {"The rubs of contact_exact_accuracy at 1 kHz and 0.1 m/s, without friction. Where a "
               "curve meets the dotted line, the surface itself turns by as much."},
              2,
              {}};
  for (std::size_t p = 0; p < found.paths.size(); ++p) {
    ChartPanel panel = path_panel(found, p, "force step [share of the force]",
                                  [](const RubError& e) { return e.step_share; });
    panel.curves.push_back(
        {"the exact surface",
         {5, Dash::dotted, Marker::none, 1.2},
         found.facet_mm,
         std::vector<double>(found.facet_mm.size(), found.paths[p][0].deep[0].exact_step_share)});
    panel.curves.push_back({"can be felt: 7 %",
                            {7, Dash::dash_dot, Marker::none, 0.7},
                            found.facet_mm,
                            std::vector<double>(found.facet_mm.size(), 0.07)});
    chart.panels.push_back(std::move(panel));
  }
  report.charts.push_back(std::move(chart));
}

/// What `auto` chooses at each mesh, on the chart of costs.
ChartCurve chosen_points(const ExactFindings& found, std::size_t p) {
  ChartCurve points{"what auto chooses", {5, Dash::none, Marker::ring, 2.4}, {}, {}};
  for (std::size_t i = 0; i < found.triangles.size(); ++i) {
    const PathCurve& curve =
        found.paths[p][static_cast<std::size_t>(found.chosen[i].variant - contact_variants().data())];
    points.x.push_back(curve.tick_ns[i]);
    points.y.push_back(curve.deep[i].force_rms_share);
  }
  return points;
}

void tell_costs(StudyReport& report, const ExactFindings& found) {
  StudyTable table{
      "contact_exact_cost_measured",
      {"path", "triangles", "method", "normals", "whole_tick_ns", "without_friction_ns", "force_rms_share"},
      {}};
  Chart chart{
      "contact_exact_speed_against_accuracy_measured",
      "Contact on a CAD part: speed against accuracy",
      {"Each curve is one method and one kind of normals, from the coarse to the fine "
       "tessellation. Whole ticks with finger-pad friction, in a warm cache;",
       "times were measured on the machine that drew this. auto expects up to 10 N and takes the proxy "
       "where that presses past a wall's middle: contact_exact_choice.csv has its reasons."},
      2,
      {}};
  for (std::size_t p = 0; p < found.paths.size(); ++p) {
    ChartPanel panel{words_of(found.path_names[p]),
                     "time of a whole tick [ns]",
                     "force error [share, RMS]",
                     true,
                     true,
                     {},
                     {}};
    std::vector<std::pair<double, double>> all;
    for (std::size_t v = 0; v < contact_variants().size(); ++v) {
      const ContactVariant& variant = contact_variants()[v];
      const PathCurve& curve = found.paths[p][v];
      ChartCurve series{variant.name(), variant.style, curve.tick_ns, {}};
      for (std::size_t i = 0; i < found.triangles.size(); ++i) {
        series.y.push_back(curve.deep[i].force_rms_share);
        all.emplace_back(series.x[i], series.y[i]);
        table.rows.push_back({found.path_names[p], found.triangles[i], variant.method_name,
                              variant.normals_name, series.x[i], curve.contact_ns[i], series.y[i]});
      }
      panel.curves.push_back(std::move(series));
    }
    panel.pareto_front = pareto_front(all);
    panel.curves.push_back(chosen_points(found, p));
    chart.panels.push_back(std::move(panel));
  }
  report.tables.push_back(std::move(table));
  report.charts.push_back(std::move(chart));
}

}  // namespace

void study_contact_exact(StudyReport& report, const ExactSet& set, const StudyProgress& progress) {
  progress("a CAD part: its exact surface");
  const ExactFindings found = exact_findings(set);
  tell_samples(report, found);
  tell_rubs(report, found);
  tell_strikes(report, found);
  tell_orders(report, found);
  tell_choices(report, found);
  tell_accuracy(report, found);
  tell_steps(report, found);
  tell_costs(report, found);
}

}  // namespace fingerpad
