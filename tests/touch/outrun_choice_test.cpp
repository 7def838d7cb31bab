#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <regex>

#include "base/number_text.hpp"
#include "contact/part_measures.hpp"
#include "support/shapes.hpp"
#include "support/worlds.hpp"
#include "touch/closed_loop.hpp"
#include "touch/contact_choice.hpp"
#include "touch/world.hpp"

// A finger that goes so far from tick to tick that its proxy cannot look at all that it goes round: `auto`
// says so beforehand, and at the rate that it names the proxy keeps up.

namespace fingerpad::outrun_choice_test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr double sphere_m = 0.005, ball_m = 0.003, depth_m = 0.0015, speed_m_per_s = 0.5;

/// A sphere in 32,768 facets.
const std::vector<Surface>& sphere() {
  static const std::vector<Surface> surfaces = [] {
    Surface surface;
    surface.part =
        std::make_shared<const Part>(make_part(test::sphere_soup(sphere_m, 6), 30 * std::numbers::pi / 180));
    surface.tree = std::make_shared<const TriangleTree>(surface.part);
    surface.mesh = "sphere.stl";
    return std::vector<Surface>{surface};
  }();
  return surfaces;
}

/// Beside a plane so near that only a proxy can do.
ContactChoice choice_for(const Scene& scene) {
  static const std::vector<PartMeasures> measures{measure_part(*sphere()[0].part, *sphere()[0].tree)};
  std::vector<Surface> surfaces = sphere();
  Surface plane;
  plane.plane_normal_W = Vec3(0, 0.6, -0.8);
  plane.plane_point_W = -0.006 * plane.plane_normal_W;
  surfaces.push_back(plane);
  return choose_contact(scene, surfaces, measures);
}

/// Round the sphere at one depth, at that speed, after a way in.
FingerPath round_the_sphere(double rate_hz) {
  const double at_m = sphere_m + ball_m - depth_m;
  Motion motion;
  const int way_in = 40, around = 1000;
  motion.p_WQ.resize(3, way_in + around);
  for (int k = 0; k < way_in + around; ++k) {
    const double turn = k < way_in ? 0 : 3.0 * (k - way_in) / around;
    const double from_m = at_m + (k < way_in ? 2e-3 * (way_in - k) / way_in : 0);
    const Vec3 way(std::cos(turn), 0.8 * std::sin(turn), 0.6 * std::sin(turn));
    motion.t_s.push_back(k < way_in ? 2e-3 * k / way_in / speed_m_per_s
                                    : (2e-3 + at_m * turn) / speed_m_per_s);
    motion.p_WQ.col(k) = from_m * way;
  }
  return {std::move(motion), rate_hz, Vec3::UnitX()};
}

Scene scene_at(double rate_hz) {
  Scene scene;
  scene.contact.method = automatic_method;
  scene.contact.normals = Normals::facet;
  scene.contact.automatic_normals = true;
  scene.contact.force_tolerance = 0.1;
  scene.contact.greatest_force_n = 1000 * depth_m;
  scene.finger.radius_m = ball_m;
  scene.friction.law = "none";
  scene.motion.rate_hz = rate_hz;
  return with_known_way(scene, round_the_sphere(rate_hz));
}

/// By how much of the closed form's the force is off, at the worst.
double worst_error(const Scene& scene) {
  const FingerPath path = round_the_sphere(scene.motion.rate_hz);
  World world;
  world.surfaces = sphere();
  Scene facets = scene;
  facets.contact.method = "proxy";
  facets.contact.automatic_normals = false;
  ClosedLoop loop(std::make_shared<const World>(world), facets, path);
  double worst = 0;
  for (long k = 0; k < loop.tick_count(); ++k) {
    const TickRecord record = loop.next();
    const Vec3 p = path.at(k).p_WQ;
    const double deep_m = sphere_m + ball_m - p.norm();
    if (deep_m < 0.9 * depth_m) continue;
    worst = std::max(worst, (record.force_W_n - 1000 * deep_m * p.normalized()).norm() / (1000 * deep_m));
  }
  return worst;
}

TEST(OutrunChoice, SaysThatTheProxyIsOutrunAndNamesARateAtWhichItIsNot) {
  const Scene fast = scene_at(250);
  ASSERT_GT(worst_error(fast), 0.5) << "the proxy keeps up after all";
  const std::string said = choice_for(fast).limits.at(0).said;
  EXPECT_THAT(said, HasSubstr("cannot be kept by proxy: at rate_hz = 250 the finger goes 2 mm a tick"));
  std::smatch found;
  ASSERT_TRUE(std::regex_search(said, found, std::regex("a rate_hz of ([0-9.]+) would"))) << said;
  const Scene mended = scene_at(parse_number(found[1].str()).value());
  EXPECT_THAT(choice_for(mended).limits.at(0).said, IsEmpty());
  EXPECT_LT(worst_error(mended), mended.contact.force_tolerance);
}

TEST(OutrunChoice, NothingIsSaidWhereTheWayIsNotKnownBeforehand) {
  Scene live = scene_at(250);
  live.motion.longest_step_m = 0;
  EXPECT_THAT(choice_for(live).limits.at(0).said, IsEmpty());
}

TEST(OutrunChoice, OneJumpInAHundredTicksIsNoSpeed) {
  Motion motion;
  motion.p_WQ.resize(3, 202);
  for (int k = 0; k < 202; ++k) {
    motion.t_s.push_back(1e-3 * k);
    motion.p_WQ.col(k) = Vec3(1e-4 * k + (k > 100 ? 0.05 : 0), 0, 0);
  }
  const Scene scene = with_known_way(Scene(), FingerPath(std::move(motion), 1000, Vec3::UnitX()));
  EXPECT_NEAR(scene.motion.longest_step_m, 1e-4, 1e-9);
}

}  // namespace
}  // namespace fingerpad::outrun_choice_test
