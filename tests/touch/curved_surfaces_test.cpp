#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "support/finger_runs.hpp"
#include "support/shapes.hpp"

// What stretches the spring on curved surfaces is the finger's skin: SCIENCE 7.

namespace fingerpad::curved_surfaces_test {
namespace {

using test::friction_work_j;
using test::plane_scene;
using test::plane_world;
using test::run_finger;
using test::run_places;
using test::world_of;

constexpr double pi = std::numbers::pi;

/// The finger's travel to the first rupture, round a tube of 3 mm at a distance from its axis.
double travel_to_rupture_m(double finger_radius_m, double from_axis_m) {
  const double ring_m = 0.3, step_m = 1e-6;
  static const auto world = world_of(test::torus_soup(ring_m, 0.003, 64, 720));
  Scene scene = plane_scene("stick-slip");
  scene.finger.radius_m = finger_radius_m;
  scene.contact.method = "closest-point";
  const auto rows = run_places(world, scene, 1200, [&](long k) {
    const double angle = 0.4 + step_m * static_cast<double>(k) / from_axis_m;
    return Vec3(ring_m + from_axis_m * std::cos(angle), 0, from_axis_m * std::sin(angle));
  });
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (rows[k].ruptures > 0) return step_m * static_cast<double>(k);
  }
  return std::nan("");
}

TEST(CurvedSurfaces, UnderABallOnATightCylinderThePadRupturesAfterThePlanesTravel) {
  // 1 mm deep: 1 N, mu_s/k_f = 0.3 mm. The contact point would go 0.3 of it, a micrometre is a tick.
  EXPECT_NEAR(travel_to_rupture_m(0.008, 0.003 + 0.008 - 0.001), 3e-4, 1.5e-6);
  // A point 2 mm deep, a third as far from the axis as its contact point.
  EXPECT_NEAR(travel_to_rupture_m(0, 0.003 - 0.002), 3e-4, 1.5e-6);
}

/// Work of friction in loops on a sphere of 5 mm: 0.18 mm along it 2 mm deep, out to 1 mm, back, and in.
double loops_work_j(const std::string& law) {
  static const auto world = world_of(test::sphere_soup(0.005, 6));
  Scene scene = plane_scene(law);
  scene.contact.method = "closest-point";
  const long leg = 500;
  const double angle = 0.18e-3 / 0.003;
  return friction_work_j(run_places(world, scene, 3 * 4 * leg + 1, [&](long k) {
    const double at = static_cast<double>(k % (4 * leg)) / static_cast<double>(leg);
    const double along = at < 1 ? at : (at < 2 ? 1 : (at < 3 ? 3 - at : 0));
    const double out = at < 1 ? 0 : (at < 2 ? at - 1 : (at < 3 ? 1 : 4 - at));
    const double r = 0.003 + 0.001 * out, a = 0.7 + angle * along;
    return Vec3(r * std::cos(a), 0.3e-3, r * std::sin(a));
  }));
}

TEST(CurvedSurfaces, ASpringOfFixedStiffnessGivesNothingInLoopsOfChangingDepth) {
  for (const std::string law :
       {"kikuuwe", "elasto-plastic", "salisbury", "friction-cone", "salcudean-vlaar", "dahl", "lugre"}) {
    // Following the contact point they gave 3.2 uJ a loop. The sum over ticks is of second order in 0.4 um.
    EXPECT_LT(loops_work_j(law), 1e-10) << law;
  }
}

TEST(CurvedSurfaces, ABallMovedRoundAnEdgeSlidesByItsOwnTravel) {
  // Round the upper edge of a box at x = 10 mm, 0.1 mm deep: S stands still on the edge.
  const auto world = world_of(test::box_soup(Vec3(0.02, 0.02, 0.02)));
  for (const std::string method : {"proxy", "closest-point"}) {
    Scene scene = plane_scene("stick-slip");
    scene.finger.radius_m = 0.003;
    scene.contact.method = method;
    scene.friction.settings.numbers["stick_stiffness_per_m"] = 10;  // holds 30 mm
    const double reach_m = 0.0029;
    const auto rows = run_places(world, scene, 2001, [&](long k) {
      const double angle = pi / 2 * static_cast<double>(k) / 2000;
      return Vec3(0.01 + reach_m * std::sin(angle), 0.001, 0.01 + reach_m * std::cos(angle));
    });
    const TickRecord& last = rows.back();
    ASSERT_EQ(last.phase, Phase::stick) << method;
    const double stretch_m = last.friction_W_n.norm() / (10 * last.normal_force_n);
    // Chords of 2 um for arcs: 1e-7 of it.
    EXPECT_NEAR(stretch_m, reach_m * pi / 2, 1e-8) << method;
    EXPECT_GT(last.friction_W_n.normalized().z(), 1 - 1e-6) << "down the far side: held back upwards";
  }
}

/// Friction at the end of a loop round the pole of a sphere, all stick, begun `before_m` along the meridian.
Vec3 loop_friction_n(double polar_rad, double before_m, double finger_m) {
  static const auto world = world_of(test::sphere_soup(0.05, 6));
  Scene scene = plane_scene("stick-slip");
  scene.friction.settings.numbers["stick_stiffness_per_m"] = 1;
  const long lead = 500, loop = 20000;
  const auto rows = run_places(world, scene, lead + loop + 1, [&](long k) {
    const double s = std::min(1.0, static_cast<double>(k) / lead);
    const double polar = polar_rad - before_m / finger_m * (1 - s);
    const double around = 0.1 + 2 * pi * static_cast<double>(std::max(0L, k - lead)) / loop;
    return Vec3(finger_m * Vec3(std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around),
                                std::cos(polar)));
  });
  EXPECT_EQ(rows.back().phase, Phase::stick);
  return rows.back().friction_W_n / rows.back().normal_force_n;
}

TEST(CurvedSurfaces, ALoopTurnsTheStretchByTheCurvatureItEncloses) {
  const double polar = 0.5, finger_m = 0.049, before_m = 0.004;
  const Vec3 plain = loop_friction_n(polar, 0, finger_m);
  const Vec3 carried = loop_friction_n(polar, before_m, finger_m) - plain;
  const Vec3 outward =
      Vec3(std::sin(polar) * std::cos(0.1), std::sin(polar) * std::sin(0.1), std::cos(polar));
  const Vec3 south = Vec3(std::cos(polar) * std::cos(0.1), std::cos(polar) * std::sin(0.1), -std::sin(polar));
  // Friction is against the stretch, which was before_m southwards when the loop began (eastwards round).
  const double turned = std::atan2(outward.dot(south.cross(-carried)), south.dot(-carried));
  const double enclosed = 2 * pi * (1 - std::cos(polar));  // A/R^2
  // Facets of 1 mm turn the normal by up to 1e-4 rad between them; it is a loop of 0.15 m.
  EXPECT_NEAR(std::remainder(turned - enclosed, 2 * pi), 0, 2e-3);
  EXPECT_NEAR(carried.norm(), before_m, 2e-3 * before_m);
  // The loop itself, developed into the plane, is an arc of radius R tan(polar) that lacks A/R^2.
  const double chord_m = 2 * finger_m * std::tan(polar) * std::sin(enclosed / 2);
  EXPECT_NEAR(plain.norm(), chord_m, 2e-3 * chord_m);
}

/// A ball of 8 mm, 1 mm deep in the plane z = 0, that moves along y while it turns about x.
FingerSample rolling(double way_m, double turn_rad, bool with_attitude) {
  const Eigen::AngleAxisd turn(turn_rad, Vec3::UnitX());
  FingerSample sample;
  sample.p_WQ = Vec3(0, way_m, 0.007);
  sample.direction_W = turn * Vec3(0, 0.6, -0.8);
  if (with_attitude) sample.attitude = Attitude(turn);
  return sample;
}

TEST(CurvedSurfaces, PureRollingStretchesNothing) {
  Scene scene = plane_scene("stick-slip");
  scene.finger.radius_m = 0.008;
  for (const bool with_attitude : {false, true}) {
    const auto rolled = run_finger(plane_world(), scene, 1001, [&](long k) {
      const double way_m = 5e-6 * static_cast<double>(k);
      return rolling(way_m, -way_m / 0.007, with_attitude);  // over S, 7 mm below Q
    });
    for (const TickRecord& row : rolled) ASSERT_LT(row.friction_W_n.norm(), 1e-9) << with_attitude;
    EXPECT_NEAR(friction_work_j(rolled), 0, 1e-12);
    // Turned on the spot it slides: 7 mm below Q by 7 mm times the angle.
    const auto turned = run_finger(plane_world(), scene, 201, [&](long k) {
      return rolling(0, -1e-6 * static_cast<double>(k) / 0.007, with_attitude);
    });
    EXPECT_NEAR(turned.back().friction_W_n.y(), 0.2, 1e-6) << "the skin below goes back: " << with_attitude;
  }
}

TEST(CurvedSurfaces, ForceAndTorqueTogetherTakeWhatTheSkinsSlipTakes) {
  Scene scene = plane_scene("stick-slip");
  scene.finger.radius_m = 0.008;
  // 0.4 m/s along y while the skin below goes back half as fast: it slips by 0.2 mm a tick, under 0.2 N.
  const double way_m = 4e-4, turn_rad = -0.5 * way_m / 0.007;
  const auto rows = run_finger(plane_world(), scene, 101, [&](long k) {
    return rolling(way_m * static_cast<double>(k), turn_rad * static_cast<double>(k), true);
  });
  const TickRecord& last = rows.back();
  ASSERT_EQ(last.phase, Phase::slip);
  EXPECT_NEAR(last.friction_W_n.y() * way_m + last.torque_W_n_m.x() * turn_rad, -0.2 * 0.5 * way_m, 1e-12);
  EXPECT_NEAR((last.torque_W_n_m - Vec3(-0.2 * 0.007, 0, 0)).norm(), 0, 1e-12) << "7 mm below, not 8";
}

TEST(CurvedSurfaces, APointHasNoSkinToRoll) {
  Scene scene = plane_scene("stick-slip");
  const auto rows = run_finger(plane_world(), scene, 100, [&](long k) {
    FingerSample sample = rolling(0, -0.01 * static_cast<double>(k), true);
    sample.p_WQ.z() = -0.001;
    return sample;
  });
  EXPECT_EQ(rows.back().friction_W_n, Vec3::Zero());
}

}  // namespace
}  // namespace fingerpad::curved_surfaces_test
