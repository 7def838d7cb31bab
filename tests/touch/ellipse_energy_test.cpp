#include <gtest/gtest.h>

#include <cmath>

#include "support/finger_runs.hpp"

// The ellipse of the finger pad has a soft axis and a stiff one: what a rupture along the stiff one takes is
// less than what a restick along the soft one stores, where the two coefficients are near enough.

namespace fingerpad::ellipse_energy_test {
namespace {

constexpr double rate_hz = 10000, normal_n = 1, mu_static = 0.3;
constexpr double lateral_m = 3e-4, longitudinal_m = 2.4e-4;  // the default pad's under mu_static at 45 deg

/// Places one after the other, a tick apart.
class Way {
 public:
  void go(double dx_m, double dy_m, double speed_m_per_s) {
    const long ticks = std::lround(std::hypot(dx_m, dy_m) / speed_m_per_s * rate_hz);
    const Vec3 from = places_.back();
    for (long k = 1; k <= ticks; ++k)
      places_.push_back(from + Vec3(dx_m, dy_m, 0) * (static_cast<double>(k) / static_cast<double>(ticks)));
  }
  const std::vector<Vec3>& places() const { return places_; }

 private:
  std::vector<Vec3> places_ = std::vector<Vec3>(3, Vec3(0, 0, -1e-3));
};

/// What friction gives over one turn of a closed path, from stick to stick: along the stiff axis to just
/// before rupture, fast across it, so that it ruptures and slips, and back along the soft axis; then the
/// mirror image.
double energy_of_turn_j(double mu_dynamic) {
  constexpr double across_m = 2e-5, slow_m_per_s = 0.005, fast_m_per_s = 0.2;
  Way way;
  std::size_t turn_begins = 0;
  for (int turn = 0; turn < 3; ++turn) {
    turn_begins = way.places().size() - 1;
    for (const int side : {1, -1}) {
      way.go(0, side * 0.9995 * longitudinal_m, slow_m_per_s);
      way.go(side * across_m, 0, fast_m_per_s);
      way.go(-side * lateral_m, 0, slow_m_per_s);
    }
  }
  Scene scene = test::plane_scene("finger-pad");
  scene.motion.rate_hz = rate_hz;
  auto world = std::make_shared<World>(*test::plane_world());
  world->surfaces[0].properties.mu_static = mu_static;
  world->surfaces[0].properties.mu_dynamic = mu_dynamic;
  world->surfaces[0].properties.stiffness_n_per_m = normal_n / 1e-3;
  const auto rows = test::run_places(world, scene, static_cast<long>(way.places().size()),
                                     [&](long k) { return way.places()[static_cast<std::size_t>(k)]; });
  EXPECT_LT((rows.back().p_WQ - rows[turn_begins].p_WQ).norm(), 1e-12) << "closed";
  EXPECT_EQ(rows.back().phase, Phase::stick);
  return test::friction_work_j({rows.begin() + static_cast<long>(turn_begins), rows.end()});
}

TEST(EllipseEnergy, IsGivenWhereTheCoefficientsAreNearlyEqual) {
  EXPECT_NEAR(energy_of_turn_j(0.3), 12e-6, 1e-6);
}

TEST(EllipseEnergy, IsNotGivenWithTheDefaultCoefficients) {
  EXPECT_LT(energy_of_turn_j(0.2), 1e-9);
}

}  // namespace
}  // namespace fingerpad::ellipse_energy_test
