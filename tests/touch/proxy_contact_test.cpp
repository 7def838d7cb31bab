#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "base/random_stream.hpp"
#include "scene/scene.hpp"
#include "support/shapes.hpp"
#include "support/worlds.hpp"
#include "touch/touch.hpp"

namespace fingerpad::proxy_contact_test {
namespace {

using test::plane_scene;
using test::plane_world;
using test::world_of;

Scene proxy_scene(const std::string& law = "none") {
  Scene scene = plane_scene(law);
  scene.contact.method = "proxy";
  return scene;
}

Scene closest_scene(const std::string& law = "none") {
  Scene scene = plane_scene(law);
  scene.contact.method = "closest-point";
  return scene;
}

std::vector<TickRecord> run(const std::shared_ptr<const World>& world, const Scene& scene,
                            const std::vector<Vec3>& positions) {
  Touch touch(world, scene);
  std::vector<TickRecord> rows;
  for (std::size_t k = 0; k < positions.size(); ++k) {
    rows.push_back(
        touch.tick({static_cast<double>(k) / scene.motion.rate_hz, positions[k], Vec3(0, 0.6, -0.8)}));
  }
  return rows;
}

/// Down onto z = height at a pace, then pressed in by a depth, then held.
std::vector<Vec3> strike(double height_m, double depth_m, double speed_m_per_s, double rate_hz) {
  std::vector<Vec3> positions;
  const double step_m = speed_m_per_s / rate_hz, from_m = height_m + 0.01 + 0.37 * step_m;
  for (double z = from_m; z > height_m - depth_m; z -= step_m) positions.emplace_back(0.0031, 0.0017, z);
  for (int k = 0; k < 20; ++k) positions.emplace_back(0.0031, 0.0017, height_m - depth_m);
  return positions;
}

TEST(ProxyContact, IsTheClosestPointOnAThickConvexSmoothPart) {
  // A rub over a finely tessellated ball, by a point 1 mm deep.
  const double radius_m = 0.05;
  const auto world = world_of(test::sphere_soup(radius_m, 5));
  std::vector<Vec3> positions;
  for (int k = 0; k < 6000; ++k) {
    const double around = 0.011 + 1e-3 * k, up = 0.4 * std::sin(7e-4 * k),
                 r = radius_m - 1e-3 * std::min(1.0, k / 100.0 - 0.5);
    positions.emplace_back(r * std::cos(up) * std::cos(around), r * std::cos(up) * std::sin(around),
                           r * std::sin(up));
  }
  for (const char* law : {"none", "finger-pad"}) {
    const auto proxy = run(world, proxy_scene(law), positions);
    const auto closest = run(world, closest_scene(law), positions);
    for (std::size_t k = 0; k < positions.size(); ++k) {
      ASSERT_EQ(proxy[k].phase, closest[k].phase) << k;
      // Rounding: 1e-17 m at 1000 N/m, and the stick's displacements summed over the run.
      ASSERT_LT((proxy[k].force_W_n - closest[k].force_W_n).norm(), 1e-9)
          << k << " " << proxy[k].depth_m << " " << closest[k].depth_m;
    }
  }
}

TEST(ProxyContact, NeverPopsThroughAPlate) {
  int closest_pops = 0;
  for (const double thickness_m : {1e-3, 2e-4}) {
    for (const double speed : {0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0}) {
      for (const double radius_m : {0.0, 0.004}) {
        const auto world = world_of(test::box_soup(Vec3(0.1, 0.08, thickness_m)));
        const double top_m = thickness_m / 2 + radius_m;
        const auto positions = strike(top_m, 5.5e-3, speed, 1000);
        Scene scene = proxy_scene();
        scene.finger.radius_m = radius_m;
        for (const auto& row : run(world, scene, positions)) {
          const double depth_m = top_m - row.p_WQ.z();
          if (depth_m <= 0) {
            ASSERT_EQ(row.phase, Phase::free);
            continue;
          }
          // Rounding of the coordinates at 1000 N/m.
          ASSERT_NEAR(row.force_W_n.z(), 1000 * depth_m, 1e-9)
              << thickness_m << " " << speed << " " << radius_m;
          ASSERT_LT(row.force_W_n.head<2>().norm(), 1e-9);
        }
        scene.contact.method = "closest-point";
        closest_pops += run(world, scene, positions).back().force_W_n.z() < 1 ? 1 : 0;
      }
    }
  }
  EXPECT_EQ(closest_pops, 28)
      << "the closest point leaves on the far side: without that nothing is shown here";
}

/// The largest change of force from tick to tick, in motions of the finger times the stiffness.
double worst_step(const std::vector<TickRecord>& rows, double stiffness_n_per_m) {
  double worst = 0;
  for (std::size_t k = 1; k < rows.size(); ++k) {
    const double moved_m = (rows[k].p_WQ - rows[k - 1].p_WQ).norm();
    const double change_n = (rows[k].force_W_n - rows[k - 1].force_W_n).norm();
    worst = std::max(worst, change_n / (stiffness_n_per_m * moved_m));
  }
  return worst;
}

std::vector<Vec3> line(const Vec3& from, const Vec3& to, int ticks) {
  std::vector<Vec3> positions;
  for (int k = 0; k <= ticks; ++k)
    positions.emplace_back(from + (to - from) * (static_cast<double>(k) / ticks));
  return positions;
}

TEST(ProxyContact, OverARightAngledEdgeTheForceChangesByNoMoreThanTheMotionExplains) {
  const auto world = world_of(test::box_soup(Vec3(0.04, 0.04, 0.04)));
  for (const double radius_m : {0.0, 0.003}) {
    for (const double depth_m : {1e-4, 1e-3, 3e-3}) {
      for (const int ticks : {200, 2000}) {
        const double z = 0.02 + radius_m - depth_m;
        Scene scene = proxy_scene();
        scene.finger.radius_m = radius_m;
        const auto press = line(Vec3(0.005, 0.001, 0.03), Vec3(0.005, 0.001, z), 300);
        auto positions = press;
        for (const Vec3& p : line(Vec3(0.005, 0.001, z), Vec3(0.035, 0.003, z), ticks))
          positions.push_back(p);
        const auto rows = run(world, scene, positions);
        // In contact the push changes by at most three times as much as the finger goes.
        EXPECT_LE(worst_step(rows, 1000), 3 + 1e-6) << radius_m << " " << depth_m << " " << ticks;
        EXPECT_EQ(rows.back().phase, Phase::free);
      }
    }
  }
}

TEST(ProxyContact, InMillimetresAndInMetresFeelsTheSame) {
  // As a mesh file holds it: numbers a thousand times as large, brought to metres on import.
  const TriangleSoup metres = test::torus_soup(0.05, 0.02, 48, 24);
  TriangleSoup millimetres = metres;
  millimetres.vertices_P *= 1000;
  millimetres.vertices_P *= 1e-3;
  std::vector<Vec3> positions;
  for (int k = 0; k < 4000; ++k) {
    const double around = 0.0123 + 2e-4 * k, across = 0.3 + 1.3e-3 * k,
                 r = 0.0195 + 0.001 * std::sin(0.01 * k);
    positions.emplace_back((0.05 + r * std::cos(across)) * std::cos(around),
                           (0.05 + r * std::cos(across)) * std::sin(around), r * std::sin(across));
  }
  const auto a = run(world_of(metres), proxy_scene("finger-pad"), positions);
  const auto b = run(world_of(millimetres), proxy_scene("finger-pad"), positions);
  for (std::size_t k = 0; k < a.size(); ++k) ASSERT_LT((a[k].force_W_n - b[k].force_W_n).norm(), 1e-9) << k;
}

TEST(ProxyContact, FeelsTheSameFarFromTheOrigin) {
  const Vec3 far(1e4, -1e4, 1e4);
  const auto near_world = world_of(test::box_soup(Vec3(0.1, 0.1, 0.02)));
  auto far_world = std::make_shared<World>(*near_world);
  far_world->surfaces[0].p_WP = far;
  std::vector<Vec3> here, there;
  for (int k = 0; k < 3000; ++k) {
    // No tick lies on a tooth's end, where rounding would choose the side of the jump.
    here.emplace_back(-0.04 + 3.937e-5 * k, 0.01,
                      std::max(0.0095, 0.011 - 1e-5 * k));  // on, along, and off the end
    there.emplace_back(here.back() + far);
  }
  const auto a = run(near_world, proxy_scene("stick-slip"), here);
  const auto b = run(far_world, proxy_scene("stick-slip"), there);
  int same = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    // The input itself is rounded to 1.8e-12 m there: times 1000 N/m and, in stick, 500 N/m more.
    same += (a[k].force_W_n - b[k].force_W_n).norm() < 1e-8 ? 1 : 0;
  }
  EXPECT_GE(same, 2980) << "off the end it is let go over some ticks, of which the first may be another";
}

TEST(ProxyContact, LeansOnAPlaneAndAPartTogether) {
  auto world = std::make_shared<World>(*world_of(test::box_soup(Vec3(0.02, 0.02, 0.02))));
  Surface floor;
  floor.properties.stiffness_n_per_m = 500;
  world->surfaces.push_back(floor);  // z = 0, through the middle of the box
  auto positions = line(Vec3(0.03, 0.001, 0.01), Vec3(0.009, 0.001, -0.003), 100);
  const auto deep = run(world, proxy_scene(), positions).back();
  // In the corner between the box's side and the floor: 1 mm into one, 3 mm into the other, each as stiff as
  // it is. The floor holds most.
  EXPECT_NEAR(deep.depth_m, std::hypot(0.001, 0.003), 1e-12);
  EXPECT_EQ(deep.surface, 1);
  EXPECT_EQ(deep.triangle, -1);
  EXPECT_LT((deep.force_W_n - Vec3(1000 * 0.001, 0, 500 * 0.003)).norm(), 1e-9);
  positions = line(Vec3(0.03, 0.001, 0.01), Vec3(0.007, 0.001, -0.001), 100);
  EXPECT_EQ(run(world, proxy_scene(), positions).back().surface, 0);
}

TEST(ProxyContact, AStartInsideIsHandledAndTold) {
  const auto world = world_of(test::box_soup(Vec3(0.1, 0.1, 0.02)));
  const auto rows =
      run(world, proxy_scene(), {Vec3(0.01, 0.02, 0.004), Vec3(0.01, 0.02, 0.005), Vec3(0.01, 0.02, 0.02)});
  EXPECT_TRUE(rows[0].started_inside);
  EXPECT_NEAR(rows[0].force_W_n.z(), 6, 1e-12);
  EXPECT_FALSE(rows[1].started_inside);
  EXPECT_NEAR(rows[1].force_W_n.z(), 5, 1e-12);
  EXPECT_EQ(rows[2].phase, Phase::free);
  EXPECT_FALSE(run(world, proxy_scene(), {Vec3(0.01, 0.02, 0.02)})[0].started_inside);
  Scene closest = proxy_scene();
  closest.contact.method = "closest-point";
  const auto nearest = run(world, closest, {Vec3(0.01, 0.02, 0.004), Vec3(0.01, 0.02, 0.005)});
  EXPECT_TRUE(nearest[0].started_inside);
  EXPECT_FALSE(nearest[1].started_inside);
}

TEST(ProxyContact, AStartWhereTheBallDoesNotFitIsToldOnce) {
  const TriangleSoup box = test::box_soup(Vec3(0.1, 0.1, 0.1));
  const auto slot =
      world_of(test::joined(test::moved(box, Vec3(0.054, 0, 0)), test::moved(box, Vec3(-0.054, 0, 0))));
  Scene scene = proxy_scene();
  for (const double radius_m : {0.003, 0.005}) {
    scene.finger.radius_m = radius_m;
    const auto rows = run(slot, scene, {Vec3(0, 0, 0), Vec3(0, 0, 0.001), Vec3(0, 0, 0.002)});
    EXPECT_EQ(rows[0].started_inside, radius_m > 0.004) << "the slot is 8 mm wide";
    EXPECT_FALSE(rows[1].started_inside || rows[2].started_inside);
  }
}

TEST(ProxyContact, ForgetsWhereItWasAfterABrokenSample) {
  const auto world = world_of(test::box_soup(Vec3(0.1, 0.1, 0.02)));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Vec3& bad : {Vec3(nan, 0, 0), Vec3(0, 0, -1e300), Vec3(1e9, 0, 0)}) {
    const auto rows =
        run(world, proxy_scene("finger-pad"), {Vec3(0, 0.001, 0.011), bad, Vec3(0, 0.001, 0.009)});
    EXPECT_EQ(rows[1].phase, Phase::free);
    EXPECT_NEAR(rows[2].normal_force_n, 1, 1e-9);
  }
}

TEST(ProxyContact, OnPlanesAloneIsTheDeepestPlane) {
  std::vector<Vec3> positions;
  for (int k = 0; k < 500; ++k) positions.emplace_back(1e-3 * k, 0, 1e-3 * std::cos(0.1 * k));
  const auto a = run(plane_world(), proxy_scene("finger-pad"), positions);
  const auto b = run(plane_world(), closest_scene("finger-pad"), positions);
  for (std::size_t k = 0; k < a.size(); ++k) ASSERT_LT((a[k].force_W_n - b[k].force_W_n).norm(), 1e-12) << k;
}

}  // namespace
}  // namespace fingerpad::proxy_contact_test
