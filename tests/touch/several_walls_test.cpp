#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

#include "support/finger_runs.hpp"
#include "support/shapes.hpp"

// Each wall that holds the finger has its own normal force, coefficients and friction state: SCIENCE 7.

namespace fingerpad::several_walls_test {
namespace {

using test::plane_scene;
using test::plane_surface;
using test::run_places;
using test::world_of;

/// A groove along y of two planes, each `half_angle` from the vertical.
std::shared_ptr<World> groove(double half_angle_rad) {
  auto world = std::make_shared<World>();
  for (const double side : {1.0, -1.0}) {
    world->surfaces.push_back(
        plane_surface(Vec3::Zero(), Vec3(side * std::cos(half_angle_rad), 0, std::sin(half_angle_rad))));
  }
  return world;
}

Scene ball_scene(const std::string& law = "stick-slip") {
  Scene scene = plane_scene(law);
  scene.contact.method = "proxy";
  scene.finger.radius_m = 0.004;
  return scene;
}

/// A ball pressed 1 mm into a groove and moved along it; `aside_m` off its middle.
std::vector<TickRecord> along(const std::shared_ptr<const World>& world, double half_angle_rad, double speed,
                              double aside_m = 0, const Scene& scene = ball_scene()) {
  const double rest_m = 0.004 / std::sin(half_angle_rad);
  return run_places(world, scene, 500, [=](long k) {
    const double pressed_m = 2e-5 * static_cast<double>(std::min(k, 100L)) - 0.001;
    return Vec3(aside_m, speed * 1e-3 * static_cast<double>(std::max(0L, k - 100)), rest_m - pressed_m);
  });
}

constexpr double deg = std::numbers::pi / 180;

TEST(SeveralWalls, AGrooveMultipliesFrictionByItsWedge) {
  for (const double half_angle : {30 * deg, 45 * deg}) {
    const TickRecord last = along(groove(half_angle), half_angle, 0.2).back();
    EXPECT_EQ(last.walls, 2);
    EXPECT_EQ(last.phase, Phase::slip);
    EXPECT_NEAR(-last.friction_W_n.y() / last.force_W_n.z(), 0.2 / std::sin(half_angle), 1e-9);
    EXPECT_NEAR(last.mu, 0.2, 1e-12) << "the whole friction over the sum of the normal forces";
    EXPECT_NEAR(last.force_W_n.x(), 0, 1e-9);
  }
}

TEST(SeveralWalls, FrictionsTorqueIsTheSumOverTheWalls) {
  const TickRecord last = along(groove(45 * deg), 45 * deg, 0.2, 4e-4).back();
  ASSERT_EQ(last.walls, 2);
  // The proxy rests in the middle of the groove, the finger below and beside it.
  const Vec3 to_proxy_m(-4e-4, 0, 0.001);
  Vec3 torque_W_n_m = Vec3::Zero();
  for (const double side : {1.0, -1.0}) {
    const Vec3 normal = Vec3(side, 0, 1).normalized();
    const double friction_n = 0.2 * 1000 * to_proxy_m.dot(normal);
    torque_W_n_m += (to_proxy_m - 0.004 * normal).cross(Vec3(0, -friction_n, 0));
  }
  EXPECT_NEAR((last.torque_W_n_m - torque_W_n_m).norm(), 0, 1e-9);
}

TEST(SeveralWalls, EachRubsWithItsOwnCoefficientsAndNoneJumpsAsideBy1Um) {
  auto world = groove(45 * deg);
  world->surfaces[0].properties.mu_dynamic = 0.2;
  world->surfaces[1].properties.mu_static = 0.9;
  world->surfaces[1].properties.mu_dynamic = 0.8;
  const TickRecord middle = along(world, 45 * deg, 0.2).back();
  EXPECT_NEAR(-middle.friction_W_n.y() / middle.force_W_n.z(), 0.5 / std::sin(45 * deg), 1e-9);  // .707
  for (const double aside_m : {1e-6, -1e-6}) {
    const TickRecord aside = along(world, 45 * deg, 0.2, aside_m).back();
    // A micrometre shifts 0.7 mN from wall to wall, of which friction takes mu.
    EXPECT_LT((aside.force_W_n - middle.force_W_n).norm(), 3 * 1000 * 1e-6);
    EXPECT_EQ(aside.walls, 2);
  }
}

/// What the finger's force gives to it along a way that ends where it began [J].
double energy_given(const std::vector<TickRecord>& rows) {
  double given_j = 0;
  for (std::size_t k = 1; k < rows.size(); ++k)
    given_j += 0.5 * (rows[k].force_W_n + rows[k - 1].force_W_n).dot(rows[k].p_WQ - rows[k - 1].p_WQ);
  return given_j;
}

TEST(SeveralWalls, DampersOfACornerTakeEnergyWhicheverWayTheFingerGoes) {
  auto world = std::make_shared<World>();
  world->surfaces = {plane_surface(Vec3::Zero(), Vec3::UnitY()), plane_surface(Vec3::Zero(), Vec3::UnitZ())};
  world->surfaces[0].properties.damping_n_s_per_m = 5;
  for (const double other : {0.0, 5.0, 20.0}) {
    world->surfaces[1].properties.damping_n_s_per_m = other;
    for (int way = 0; way < 12; ++way) {
      SCOPED_TRACE(way);
      const Vec3 along_W(0, std::cos(15 * way * deg), std::sin(15 * way * deg));
      const auto rows = run_places(world, ball_scene("none"), 1001, [&](long k) {
        const double swing = 3e-4 * std::sin(2 * std::numbers::pi * 20 * 1e-3 * static_cast<double>(k));
        return Vec3(Vec3(0, 0.003, 0.003) + swing * along_W);
      });
      EXPECT_LT(energy_given(rows), 1e-12);
    }
  }
}

TEST(SeveralWalls, EachPushesWithItsOwnStiffness) {
  auto world = groove(45 * deg);
  world->surfaces[1].properties.stiffness_n_per_m = 3000;
  const TickRecord middle = along(world, 45 * deg, 0.2).back();
  const double share_m = 0.001 * std::sin(45 * deg);
  EXPECT_NEAR(middle.normal_force_n, 4000 * share_m, 1e-9);
  EXPECT_NEAR(middle.force_W_n.x(), (1000 - 3000) * share_m * std::cos(45 * deg), 1e-9);
  EXPECT_NEAR(-middle.friction_W_n.y(), 0.2 * 4000 * share_m, 1e-9);
  for (const double aside_m : {1e-6, -1e-6}) {
    const TickRecord aside = along(world, 45 * deg, 0.2, aside_m).back();
    EXPECT_LT((aside.force_W_n - middle.force_W_n).norm(), 3 * 3000 * 1e-6);
  }
}

TEST(SeveralWalls, EachHoldsByASpringOfItsOwn) {
  // 0.2 mm along the groove: k_f n on either wall, beside what the way in has stretched down the walls.
  Scene scene = ball_scene();
  scene.friction.settings.numbers["stick_stiffness_per_m"] = 100;
  const auto rows = along(groove(30 * deg), 30 * deg, 0.0005, 0, scene);
  const TickRecord& last = rows.back();
  ASSERT_EQ(last.phase, Phase::stick);
  EXPECT_EQ(test::ruptures_of(rows), 0);
  EXPECT_NEAR(-last.friction_W_n.y(), 100 * last.p_WQ.y() * last.normal_force_n, 1e-9);
  // Down each wall it has gone by cos 30 of the millimetre that it was pressed in, less the tick of first
  // touch, 20 um, which stretches nothing; both hold it upwards.
  const double down_m = (0.001 - 2e-5) * std::cos(30 * deg);
  EXPECT_NEAR(last.friction_W_n.z(), 100 * down_m * last.normal_force_n * std::cos(30 * deg), 1e-9);
}

TEST(SeveralWalls, ACornerOfThreeHoldsByAllThree) {
  auto world = std::make_shared<World>();
  for (const Vec3& normal : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)})
    world->surfaces.push_back(plane_surface(Vec3::Zero(), normal));
  Scene scene = ball_scene();
  scene.finger.radius_m = 0;
  // Into the corner, then 2 mm on into the wall of x at 0.2 m/s: that wall is pressed, the other two rubbed.
  const auto rows = run_places(world, scene, 31, [](long k) {
    const double in = std::min(1.0, static_cast<double>(k) / 10);
    const double on = 2e-4 * static_cast<double>(std::max(0L, k - 20));
    return Vec3(0.001 - in * 0.002 - on, 0.001 - in * 0.003, 0.001 - in * 0.005);
  });
  const TickRecord& last = rows.back();
  EXPECT_EQ(last.walls, 3);
  EXPECT_NEAR(last.normal_force_n, 3 + 2 + 4, 1e-9);
  EXPECT_EQ(last.surface, 2) << "the greatest share";
  EXPECT_EQ(last.phase, Phase::slip);
  EXPECT_NEAR(last.friction_W_n.x(), 0.2 * (2 + 4), 1e-9);
  // The wall of x does not slip: it keeps what it was stretched by on the way in.
  EXPECT_GT(last.friction_W_n.tail<2>().norm(), 0.01);
  EXPECT_LE(last.friction_W_n.tail<2>().norm(), 0.3 * 3);
}

TEST(SeveralWalls, AWallThatStaysKeepsItsSpringWhenAnotherComesAndGoes) {
  auto world = std::make_shared<World>();
  world->surfaces.push_back(plane_surface(Vec3::Zero(), Vec3::UnitZ()));
  world->surfaces.push_back(plane_surface(Vec3(0.0001, 0, 0), -Vec3::UnitX()));
  Scene scene = ball_scene();
  scene.finger.radius_m = 0;
  // 0.15 mm along x on the floor, the last 0.05 mm into the wall, and back.
  const auto rows = run_places(world, scene, 301, [](long k) {
    const double way = 1e-6 * static_cast<double>(k < 150 ? k : 300 - k);
    return Vec3(way, 0, -0.001);
  });
  for (std::size_t k = 0; k < rows.size(); ++k) {
    EXPECT_EQ(rows[k].walls, rows[k].p_WQ.x() > 0.0001 + 1e-12 ? 2 : 1) << k;
    ASSERT_NEAR(rows[k].friction_W_n.x(), -1000 * rows[k].p_WQ.x(), 1e-9) << k;
  }
}

TEST(SeveralWalls, FacetsOfOneSmoothSurfaceAreOneWall) {
  // A ball over a finely tessellated one: the proxy may stand in the dent between facets.
  const auto world = world_of(test::sphere_soup(0.05, 4));
  for (const std::string method : {"proxy", "closest-point"}) {
    Scene scene = ball_scene();
    scene.contact.method = method;
    scene.friction.settings.numbers["stick_stiffness_per_m"] = 10;
    const double r = 0.05 + 0.004 - 0.001;
    const auto rows = run_places(world, scene, 2001, [=](long k) {
      const double a = 0.4 + 1e-5 * static_cast<double>(k) / r;
      return Vec3(r * std::cos(a) * std::cos(0.2), r * std::cos(a) * std::sin(0.2), r * std::sin(a));
    });
    for (std::size_t k = 0; k < rows.size(); ++k) {
      ASSERT_EQ(rows[k].walls, 1) << method << " " << k;
      // Facets of 4 mm: their normals are off by up to 0.02 rad within one, which the projection feels.
      const double way_m = 1e-5 * static_cast<double>(k);
      ASSERT_NEAR(rows[k].friction_W_n.norm(), 10 * way_m * rows[k].normal_force_n,
                  1e-3 * 10 * way_m * rows[k].normal_force_n + 1e-9)
          << method << " " << k;
    }
  }
}

}  // namespace
}  // namespace fingerpad::several_walls_test
