#include "view/stick_region.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "friction/pad_profile.hpp"
#include "touch/touch.hpp"
#include "view/rub.hpp"

namespace fingerpad::test {
namespace {

constexpr double deg = std::numbers::pi / 180;

TEST(StickAxes, OfStickSlipAreTheCircleOfThePaper) {
  FrictionSettings friction;
  friction.law = "stick-slip";
  friction.settings.numbers["stick_stiffness_per_m"] = 200;
  const auto axes = stick_axes(friction, {.mu_static = 0.3}, 0.3);
  ASSERT_TRUE(axes);
  EXPECT_DOUBLE_EQ(axes->lateral_m, 0.3 / 200);
  EXPECT_DOUBLE_EQ(axes->longitudinal_m, 0.3 / 200);
}

TEST(StickAxes, OfTheFingerPadFallWithTheAngleAndScaleWithMu) {
  FrictionSettings friction;
  PadProfile profile = assumed_profile(0.3, 1000);
  friction.settings.profile = profile;
  const auto at45 = stick_axes(friction, {.mu_static = 0.3}, 45 * deg);
  const auto at70 = stick_axes(friction, {.mu_static = 0.6}, 70 * deg);
  ASSERT_TRUE(at45 && at70);
  EXPECT_NEAR(at45->lateral_m, 0.3e-3, 1e-15);
  EXPECT_NEAR(at45->longitudinal_m, 0.24e-3, 1e-15);
  EXPECT_NEAR(at70->lateral_m, 2 * 0.75 * 0.3e-3, 1e-15);
}

TEST(StickAxes, AreNotMadeUpForOtherLaws) {
  FrictionSettings friction;
  friction.law = "coulomb";
  EXPECT_FALSE(stick_axes(friction, {}, 0.5));
}

/// The drawn region is the law's own: the contact leaves it in the tick that slips.
TEST(StickRegion, IsLeftWhereTheLawRuptures) {
  auto world = std::make_shared<World>();
  world->surfaces.emplace_back();
  Scene scene;
  scene.friction.law = "finger-pad";
  const Vec3 pull = Vec3(0.6, 0.8, 0).normalized();
  Touch touch(world, scene);
  double before = 0, last = 0;
  bool ruptured = false;
  constexpr double step_m = 1e-7;
  for (int i = 0; i < 20'000 && !ruptured; ++i) {
    FingerSample sample;
    sample.t_s = 1e-3 * i;
    sample.direction_W = scene.finger.direction;
    sample.p_WQ = Vec3(0, 0, -1e-3) + pull * (step_m * i);
    const TickRecord row = touch.tick(sample);
    ruptured = row.ruptures > 0;
    if (ruptured) break;
    const auto region = stick_region(scene, world->surfaces[0].properties, row);
    ASSERT_TRUE(region);
    const Vec3 d = row.contact_W - region->centre_W;
    before = last;
    last = std::hypot(d.dot(region->lateral_W) / region->axes.lateral_m,
                      d.dot(region->longitudinal_W) / region->axes.longitudinal_m);
  }
  ASSERT_TRUE(ruptured);
  EXPECT_LT(before, last);
  // One step short of the rim: a step is under 1e-7 / 0.24e-3 of an axis.
  EXPECT_NEAR(last, 1, 5e-4);
  EXPECT_LE(last, 1);
}

TEST(StickRegion, InSlipStandsWhereTheSpringWouldPullWithThePresentFriction) {
  Scene scene;
  TickRecord row;
  row.phase = Phase::slip;
  row.contact_W = {0.01, 0.02, 0};
  row.normal_W = Vec3::UnitZ();
  row.normal_force_n = 2;
  row.friction_W_n = {-0.4, 0, 0};
  row.inclination_rad = 45 * deg;
  const auto region = stick_region(scene, {.mu_static = 0.3, .mu_dynamic = 0.2}, row);
  ASSERT_TRUE(region);
  // Paper, eq. 2: c lies mu_d/k_f = (0.2/0.3) a behind the contact, on the side that friction pulls to.
  EXPECT_NEAR((region->centre_W - Vec3(0.01 - 0.2e-3, 0.02, 0)).norm(), 0, 1e-12);
  row.phase = Phase::free;
  EXPECT_FALSE(stick_region(scene, {}, row));
}

TEST(StickRegion, IsLaidOntoACurvedSurface) {
  const ViewInput view = torus_rub();
  const Surface& surface = view.world->surfaces[0];
  const TickRecord& row = view.rows[250];
  auto region = stick_region(*view.scene, surface.properties, row);
  ASSERT_TRUE(region);
  region->axes = {0.004, 0.003};  // large against the tube's 20 mm: flat it would stand off by 0.4 mm
  double flat_m = 0, laid_m = 0;
  const auto off_torus_m = [](const Vec3& p) {
    return std::abs(std::hypot(std::hypot(p.x(), p.y()) - 0.05, p.z()) - 0.02);
  };
  for (const Vec3& p : rim_points(*region, 60, 1)) flat_m = std::max(flat_m, off_torus_m(p));
  const auto rings = region_rings(*region, surface);
  for (const Vec3& p : rings.back()) laid_m = std::max(laid_m, off_torus_m(p));
  EXPECT_GT(flat_m, 3e-4);
  EXPECT_LT(laid_m, 2e-4);  // the facets' own distance from the torus
}

TEST(FingerDirection, HasTheInclinationOfTheTick) {
  TickRecord row;
  row.phase = Phase::stick;
  row.normal_W = Vec3(0.3, -0.2, 0.9).normalized();
  row.inclination_rad = 0.35;
  const Vec3 direction = finger_direction(Vec3(0, 1, -1).normalized(), row);
  EXPECT_NEAR(direction.norm(), 1, 1e-12);
  EXPECT_NEAR(direction.dot(row.normal_W), -std::sin(0.35), 1e-12);
}

}  // namespace
}  // namespace fingerpad::test
