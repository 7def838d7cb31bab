#include "touch/touch.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/random_stream.hpp"
#include "base/tangent_frame.hpp"
#include "scene/scene.hpp"
#include "support/shapes.hpp"
#include "support/worlds.hpp"

namespace fingerpad::touch_test {
namespace {

using test::plane_scene;
using test::plane_world;
using test::world_of;

/// Runs positions through a fresh Touch.
std::vector<TickRecord> run(const std::shared_ptr<const World>& world, const Scene& scene,
                            const std::vector<Vec3>& positions, const Vec3& direction = Vec3(0, 0.6, -0.8)) {
  Touch touch(world, scene);
  std::vector<TickRecord> rows;
  for (std::size_t k = 0; k < positions.size(); ++k) {
    rows.push_back(touch.tick({static_cast<double>(k) / scene.motion.rate_hz, positions[k], direction}));
  }
  return rows;
}

TEST(Touch, PushesBackAlongTheNormalInProportionToDepth) {
  const auto rows = run(plane_world(), plane_scene("none"), {{0, 0, 0.001}, {0, 0, -0.0005}});
  EXPECT_EQ(rows[0].phase, Phase::free);
  EXPECT_EQ(rows[0].force_W_n, Vec3::Zero());
  EXPECT_TRUE(rows[0].normal_W.hasNaN());
  EXPECT_EQ(rows[0].surface, -1);
  EXPECT_NEAR(rows[1].normal_force_n, 0.5, 1e-15);
  EXPECT_NEAR((rows[1].force_W_n - Vec3(0, 0, 0.5)).norm(), 0, 1e-15);
  EXPECT_EQ(rows[1].surface, 0);
  EXPECT_EQ(rows[1].triangle, -1);
  EXPECT_NEAR(rows[1].inclination_rad, std::asin(0.8), 1e-15);
}

TEST(Touch, AFingerWithARadiusTouchesBeforeItsCentreDoes) {
  Scene scene = plane_scene("none");
  scene.finger.radius_m = 0.008;
  const auto rows = run(plane_world(), scene, {{0, 0, 0.0081}, {0, 0, 0.0075}});
  EXPECT_EQ(rows[0].phase, Phase::free);
  EXPECT_NEAR(rows[1].depth_m, 0.0005, 1e-15);
}

TEST(Touch, TheSurfaceDamperSoftensLeavingButNeverPulls) {
  auto world = std::make_shared<World>(*plane_world());
  world->surfaces[0].properties.damping_n_s_per_m = 5;
  const auto rows =
      run(world, plane_scene("none"), {{0, 0, -0.001}, {0, 0, -0.0011}, {0, 0, -0.0010}, {0, 0, -0.0001}});
  EXPECT_NEAR(rows[1].normal_force_n, 1.1 + 5 * 0.1, 1e-12);
  EXPECT_NEAR(rows[2].normal_force_n, 1.0 - 5 * 0.1, 1e-12);
  EXPECT_EQ(rows[3].normal_force_n, 0);  // 0.1 N of spring against 4.5 N of damper
  EXPECT_NE(rows[3].phase, Phase::free);
}

TEST(Touch, AtRestThereIsNoFrictionAndNoCreep) {
  const auto rows =
      run(plane_world(), plane_scene("finger-pad"), std::vector<Vec3>(5000, Vec3(0.1, 0.2, -0.001)));
  for (const TickRecord& row : rows) {
    ASSERT_EQ(row.phase, Phase::stick);
    ASSERT_EQ(row.friction_W_n, Vec3::Zero());
    ASSERT_EQ(row.stick_centre_W, rows[0].stick_centre_W);
  }
}

TEST(Touch, SlowDragOnATiltedPlaneTestedAtTicksIsTheSawtoothOfTheClosedForm) {
  // SCIENCE section 3: period (mu_s - mu_d)/k_f, mean (mu_s + mu_d) n / 2; one tick of each tooth slips, 1-2
  // V T long.
  Scene scene = plane_scene("stick-slip");
  scene.friction.settings.events = Events::tick;
  scene.motion.rate_hz = 10000;
  const Mat3 tilt = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  auto world = std::make_shared<World>(*plane_world());
  world->surfaces[0].plane_normal_W = tilt.col(2);
  const double speed = 0.002;
  std::vector<Vec3> positions;
  for (int k = 0; k < 40000; ++k) positions.emplace_back(tilt * Vec3(speed * k / 10000, 0, -0.001));
  const auto rows = run(world, scene, positions);

  std::vector<std::size_t> ruptures;
  double sum = 0;
  long counted = 0;
  for (std::size_t k = 1; k < rows.size(); ++k) {
    if (rows[k].phase == Phase::slip && rows[k - 1].phase == Phase::stick) ruptures.push_back(k);
  }
  ASSERT_GT(ruptures.size(), 20u);
  for (std::size_t k = ruptures[1]; k < ruptures.back(); ++k, ++counted) sum += rows[k].mu;
  const double period_m = speed / 10000 * static_cast<double>(ruptures.back() - ruptures[1]) /
                          static_cast<double>(ruptures.size() - 2);
  EXPECT_NEAR(period_m, 1e-4, 0.01e-4);
  EXPECT_NEAR(sum / static_cast<double>(counted), 0.25, 0.0025);
}

TEST(Touch, FrictionNeverExceedsItsLimitAndSlipIsExactlyDynamic) {
  Scene scene = plane_scene("finger-pad");
  RandomStream random(2);
  std::vector<Vec3> positions;
  Vec3 p(0, 0, -0.001);
  for (int k = 0; k < 20000; ++k) {
    p += Vec3(3e-4 * random.normal(), 3e-4 * random.normal(), 0);
    positions.push_back(p);
  }
  const auto rows = run(plane_world(), scene, positions);
  long slips = 0;
  for (const TickRecord& row : rows) {
    ASSERT_LE(row.mu, 0.3 * (1 + 1e-9));
    if (row.phase != Phase::slip) continue;
    ++slips;
    ASSERT_NEAR(row.mu, 0.2, 1e-9);
  }
  EXPECT_GT(slips, 1000);
}

TEST(Touch, TurnsWithTheWorld) {
  const auto soup = test::torus_soup(0.05, 0.02, 48, 24);
  const auto world = world_of(soup);
  auto turned = std::make_shared<World>(*world);
  const Mat3 R = Eigen::AngleAxisd(1.1, Vec3(3, -1, 2).normalized()).toRotationMatrix();
  turned->surfaces[0].R_WP = R;
  turned->surfaces[0].p_WP = Vec3(0.3, -0.2, 0.5);

  std::vector<Vec3> here, there;
  for (int k = 0; k < 3000; ++k) {
    // Off the symmetry plane of the facets, where two points are equally close and rounding would choose.
    const double around = 0.0123 + 2e-4 * k, across = 0.3 + 1e-3 * k;
    const double r = 0.0195;  // half a millimetre deep
    here.emplace_back((0.05 + r * std::cos(across)) * std::cos(around),
                      (0.05 + r * std::cos(across)) * std::sin(around), r * std::sin(across));
    there.emplace_back(R * here.back() + turned->surfaces[0].p_WP);
  }
  const Scene scene = plane_scene("finger-pad");
  const auto a = run(world, scene, here, Vec3(0, 0.6, -0.8));
  const auto b = run(turned, scene, there, R * Vec3(0, 0.6, -0.8));
  for (std::size_t k = 0; k < a.size(); ++k) {
    ASSERT_EQ(a[k].phase, b[k].phase) << k;
    // Rounding of 1e-17 m in the position, times the stick stiffness of 1000 n 1/m and a drift over the run.
    ASSERT_LT((R * a[k].force_W_n - b[k].force_W_n).norm(), 1e-9) << k;
  }
}

TEST(Touch, FeelsTheSameFarFromTheOrigin) {
  const Vec3 far(1e4, -1e4, 1e4);
  const auto near_world = world_of(test::box_soup(Vec3(0.1, 0.1, 0.02)));
  auto far_world = std::make_shared<World>(*near_world);
  far_world->surfaces[0].p_WP = far;
  std::vector<Vec3> here, there;
  for (int k = 0; k < 2000; ++k) {
    // No tick lies on a tooth's end, where rounding would choose the side of the jump.
    here.emplace_back(-0.04 + 3.937e-5 * k, 0.01, 0.0095);
    there.emplace_back(here.back() + far);
  }
  const auto a = run(near_world, plane_scene("stick-slip"), here);
  const auto b = run(far_world, plane_scene("stick-slip"), there);
  for (std::size_t k = 0; k < a.size(); ++k) {
    // The input itself is rounded to 1.8e-12 m there: times 1000 N/m and, in stick, 500 N/m more.
    ASSERT_NEAR(a[k].normal_force_n, b[k].normal_force_n, 4e-9) << k;
    ASSERT_LT((a[k].friction_W_n - b[k].friction_W_n).norm(), 1e-8) << k;
  }
}

TEST(Touch, TheStickCentreLiesOnTheSurfaceItBelongsTo) {
  // A cylinder-like bend: the torus's tube, radius 5 mm, with a pad whose axes reach a third of it.
  const double tube = 0.005;
  const auto world = world_of(test::torus_soup(0.03, tube, 400, 160));
  Scene scene = plane_scene("stick-slip");
  scene.friction.settings.numbers["stick_stiffness_per_m"] = 200;
  std::vector<Vec3> positions;
  const double r = tube - 0.0005;
  for (int k = 0; k < 1500; ++k) {
    const double across =
        0.2 + 0.3 * std::sin(0.01 * k) * 4;  // fast mid-stroke, slow at the ends: slip and stick
    positions.emplace_back(0.03 + r * std::cos(across), 0, r * std::sin(across));
  }
  for (const Events events : {Events::exact, Events::tick}) {
    scene.friction.settings.events = events;
    const auto rows = run(world, scene, positions);
    int sticks = 0, begun = 0;
    for (std::size_t k = 1; k < rows.size(); ++k) {
      if (rows[k].phase != Phase::stick) continue;
      ++sticks;
      const Vec3& c = rows[k].stick_centre_W;
      const double from_tube_axis = std::hypot(std::hypot(c.x(), c.y()) - 0.03, c.z());
      ASSERT_NEAR(from_tube_axis, tube, 2e-6) << k;  // facets of 0.2 mm sag by 1 um
      if (rows[k - 1].phase == Phase::stick && rows[k].ruptures == 0) {
        ASSERT_EQ(c, rows[k - 1].stick_centre_W) << "it stays put while the pad sticks";
      }
      if (rows[k - 1].phase != Phase::slip && rows[k].ruptures == 0) continue;
      ++begun;  // always slower than v_min: between ticks it holds again at once
      if (events == Events::tick) {
        ASSERT_NEAR(rows[k].mu, 0.2, 1e-9) << "no jump from slip to stick";
      }
    }
    EXPECT_GT(sticks, 100);
    EXPECT_GT(begun, 2);
  }
}

TEST(Touch, StickRupturesOnAFilletSmallerThanThePadsReach) {
  // On a tube of 0.5 mm with a stick radius of 1.5 mm the chord never gets that long; the finger's way does.
  const double tube = 0.0005;
  const auto world = world_of(test::torus_soup(0.01, tube, 600, 96));
  Scene scene = plane_scene("stick-slip");
  scene.friction.settings.numbers["stick_stiffness_per_m"] = 200;
  std::vector<Vec3> positions;
  for (int k = 0; k < 4000; ++k) {
    const double across = 1e-3 * k;
    const double r = tube - 1e-5;
    positions.emplace_back(0.01 + r * std::cos(across), 0, r * std::sin(across));
  }
  const auto rows = run(world, scene, positions);
  std::size_t rupture = 0;
  for (std::size_t k = 1; k < rows.size() && rupture == 0; ++k) rupture = rows[k].ruptures > 0 ? k : 0;
  // The finger's own arc, of 0.49 mm, reaches 1.5 mm at 3.061 rad: tick 3061, to a tick or two and the
  // facets.
  EXPECT_NEAR(static_cast<double>(rupture), 3061, 15);
}

TEST(Touch, TheDeepestContactCountsAndTheFirstOfEquals) {
  auto world = std::make_shared<World>(*plane_world());
  Surface wall;
  wall.plane_normal_W = Vec3::UnitX();
  world->surfaces.push_back(wall);
  const auto rows =
      run(world, plane_scene("none"), {{-0.001, 0, -0.002}, {-0.002, 0, -0.001}, {-0.001, 0, -0.001}});
  EXPECT_EQ(rows[0].surface, 0);
  EXPECT_EQ(rows[1].surface, 1);
  EXPECT_EQ(rows[2].surface, 0);
}

TEST(Touch, BrokenSamplesAreFreeAndNothingAfterThemSuffers) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const Vec3 good(0, 0, -0.001);
  for (const Vec3& bad : {Vec3(nan, 0, 0), Vec3(0, inf, 0), Vec3(0, 0, -1e300), Vec3(1e308, 1e308, 1e308)}) {
    Touch touch(plane_world(), plane_scene("finger-pad"));
    touch.tick({0, good, Vec3(0, 1, -1)});
    const TickRecord lost = touch.tick({0.001, bad, Vec3(0, 1, -1)});
    EXPECT_EQ(lost.phase, Phase::free);
    EXPECT_EQ(lost.force_W_n, Vec3::Zero());
    const TickRecord after = touch.tick({0.002, good, Vec3(nan, nan, nan)});
    EXPECT_NEAR(after.normal_force_n, 1, 1e-12);
    EXPECT_TRUE(after.force_W_n.allFinite());
  }
}

TEST(Touch, NoForceIsEverNonFiniteOverRandomTicksOnAnEdgyPart) {
  const auto world = world_of(test::box_soup(Vec3(0.02, 0.02, 0.02)));
  for (const char* law : {"none", "coulomb", "stick-slip", "finger-pad"}) {
    Touch touch(world, plane_scene(law));
    RandomStream random(9);
    for (int k = 0; k < 20000; ++k) {
      const double reach = std::pow(10.0, 3 * random.uniform() - 4);
      const FingerSample sample{k * 1e-3, reach * Vec3(random.normal(), random.normal(), random.normal()),
                                Vec3(random.normal(), random.normal(), random.normal())};
      const TickRecord row = touch.tick(sample);
      ASSERT_TRUE(row.force_W_n.allFinite());
      ASSERT_LE(row.mu, 0.3 * (1 + 1e-9));
    }
  }
}

TEST(Touch, VibratesInSlipOnlyAndStartsStickAtTheForceAsWritten) {
  Scene scene = plane_scene("stick-slip");
  scene.friction.settings.events = Events::tick;
  scene.friction.vibration = VibrationSettings{};
  scene.friction.vibration->normal_amplitude = 0.02;
  std::vector<Vec3> positions;
  for (int k = 0; k < 20000; ++k) positions.emplace_back(0.05 * std::sin(2e-3 * k * 3.14159), 0, -0.001);
  const auto rows = run(plane_world(), scene, positions);
  double sum = 0, squares = 0;
  long slips = 0, begun = 0;
  for (std::size_t k = 1; k < rows.size(); ++k) {
    const double friction_n = rows[k].friction_W_n.norm();
    if (rows[k].phase == Phase::slip) {
      const double relative = friction_n / 0.2 - 1;
      ++slips;
      sum += relative;
      squares += relative * relative;
      continue;
    }
    ASSERT_EQ(rows[k].normal_force_n, 1) << "the normal force rests with the pad";
    if (rows[k - 1].phase != Phase::slip) continue;
    ++begun;
    const double moved_m = (rows[k].p_WQ - rows[k - 1].p_WQ).norm();
    // The spring starts at the last force as written; only the tick's own motion may be felt: k_f n dx.
    ASSERT_NEAR(friction_n, rows[k - 1].friction_W_n.norm(), 1000 * moved_m + 1e-9);
  }
  EXPECT_GT(begun, 10);
  // Variance 0.05^2; some 400 independent swings of 50 ms each in the 20 s.
  EXPECT_NEAR(std::sqrt(squares / static_cast<double>(slips)), 0.05, 0.01);
  EXPECT_NEAR(sum / static_cast<double>(slips), 0, 0.01);
}

TEST(Touch, TheSameSamplesGiveTheSameBits) {
  const auto world = world_of(test::torus_soup(0.05, 0.02, 48, 24));
  std::vector<Vec3> positions;
  for (int k = 0; k < 2000; ++k)
    positions.emplace_back(0.05 + 0.0195 * std::cos(1e-3 * k), 0, 0.0195 * std::sin(1e-3 * k));
  const auto a = run(world, plane_scene("finger-pad"), positions);
  const auto b = run(world, plane_scene("finger-pad"), positions);
  for (std::size_t k = 0; k < a.size(); ++k) ASSERT_EQ(a[k].force_W_n, b[k].force_W_n);
}

}  // namespace
}  // namespace fingerpad::touch_test
