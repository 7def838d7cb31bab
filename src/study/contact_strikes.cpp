#include <array>

#include "base/random_stream.hpp"
#include "study/contact_parts.hpp"
#include "study/contact_runs.hpp"
#include "study/shape_meshes.hpp"

namespace fingerpad {
namespace {

const std::vector<double> thicknesses_m{2e-4, 5e-4, 1e-3,    2e-3,    2.8e-3, 3.2e-3,
                                        5e-3, 8e-3, 1.08e-2, 1.12e-2, 1.4e-2, 2e-2};
constexpr std::array speeds_m_per_s{0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0};
constexpr std::array radii_m{0.0, 0.004};
constexpr int places = 4;
constexpr double greatest_force_n = 5.5;  // of these strikes: 5.5 mm at 1000 N/m

/// A strike of each place: near the middle, ticks at any phase.
std::vector<Strike> strikes_at(double speed_m_per_s, double radius_m) {
  RandomStream random(5);
  std::vector<Strike> strikes;
  for (int i = 0; i < places; ++i) {
    const Vec2 at_m(4e-3 * (random.uniform() - 0.5), 4e-3 * (random.uniform() - 0.5));
    strikes.push_back({speed_m_per_s, radius_m, at_m, random.uniform()});
  }
  return strikes;
}

struct StruckWall {
  std::string name, words;
  TriangleSoup (*mesh)(double thickness_m);
};

const std::vector<std::string> columns{"wall",   "thickness_m", "speed_m_per_s", "finger_radius_m",
                                       "method", "normals",     "strikes",       "pop_throughs"};

/// The share of all strikes of a variant that pop through a wall; a row of the table a speed.
double popped_share(StudyTable& table, const StruckWall& wall, double thickness_m, double radius_m,
                    const std::shared_ptr<const World>& world, const ContactVariant& variant) {
  int all_pops = 0, all_strikes = 0;
  for (const double speed : speeds_m_per_s) {
    int pops = 0;
    for (const Strike& strike : strikes_at(speed, radius_m))
      pops += pops_through(world, variant, strike) ? 1 : 0;
    table.rows.push_back({wall.name, thickness_m, speed, radius_m, variant.method_name, variant.normals_name,
                          static_cast<double>(places), static_cast<double>(pops)});
    all_pops += pops;
    all_strikes += places;
  }
  return static_cast<double>(all_pops) / all_strikes;
}

/// Strikes by a finger of this radius, against the wall's thickness.
ChartPanel strikes_panel(StudyTable& table, const StruckWall& wall, double radius_m) {
  ChartPanel panel{wall.words + ", " + (radius_m > 0 ? "a finger of 4 mm" : "a point finger"),
                   "thickness of the wall [mm]",
                   "share of the strikes",
                   true,
                   false,
                   {},
                   {}};
  for (const ContactVariant& variant : contact_variants())
    panel.curves.push_back({variant.name(), variant.style, {}, {}});
  ChartCurve automatic{"what auto chooses", {5, Dash::none, Marker::ring, 2.4}, {}, {}};
  for (const double thickness_m : thicknesses_m) {
    const auto world = world_of_mesh(wall.mesh(thickness_m), wall.name);
    const ContactVariant* chosen = automatic_choice(*world, radius_m, greatest_force_n).variant;
    for (std::size_t v = 0; v < contact_variants().size(); ++v) {
      const ContactVariant& variant = contact_variants()[v];
      ChartCurve& series = panel.curves[v];
      series.x.push_back(1000 * thickness_m);
      series.y.push_back(popped_share(table, wall, thickness_m, radius_m, world, variant));
      if (&variant != chosen) continue;
      automatic.x.push_back(series.x.back());
      automatic.y.push_back(series.y.back());
    }
  }
  panel.curves.push_back(std::move(automatic));
  return panel;
}

}  // namespace

void study_contact_strikes(StudyReport& report) {
  StudyTable table{"contact_strikes", columns, {}};
  Chart chart{"contact_strikes",
              "Strikes that pop through a wall",
              {"5.5 mm deep at 0.05 to 5 m/s, at 1 kHz: 28 strikes a point. auto is told of 5.5 N.",
               "The closest point lets go where the wall is thinner than twice the depth of the finger's "
               "centre, whatever the speed."},
              2,
              {}};
  const std::array<StruckWall, 2> walls{{{"plate", "a flat plate of 12 triangles", plate_mesh},
                                         {"hollow-ball", "a hollow ball of radius 30 mm", hollow_ball_mesh}}};
  for (const double radius_m : radii_m) {
    for (const StruckWall& wall : walls) chart.panels.push_back(strikes_panel(table, wall, radius_m));
  }
  report.tables.push_back(std::move(table));
  report.charts.push_back(std::move(chart));
}

}  // namespace fingerpad
