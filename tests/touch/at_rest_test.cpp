#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/finger_runs.hpp"

// A finger at rest, as far as a finger ever is: SCIENCE 7 and DESIGN, "Friction in one place".

namespace fingerpad::at_rest_test {
namespace {

using test::friction_work_j;
using test::plane_scene;
using test::plane_world;
using test::run_finger;
using test::run_places;

/// A pad stretched by 0.2 mm along x and then tilted, so that its region shrinks past it; on top of that it
/// moves as `wander` says.
std::vector<TickRecord> tilted_until_it_gives_way(Events events, Restick restick,
                                                  const std::function<Vec3(double)>& wander) {
  Scene scene = plane_scene("finger-pad");
  scene.friction.settings.events = events;
  scene.friction.settings.restick = restick;
  return run_finger(plane_world(), scene, 3000, [&](long k) {
    const double t = 1e-3 * static_cast<double>(k), drawn = std::min(1.0, t / 0.5);
    const double tilt = (30 + 55 * std::max(0.0, t - 1) / 2) * std::numbers::pi / 180;
    FingerSample sample;
    sample.p_WQ = Vec3(2e-4 * drawn, 0, -0.001) + (t > 0.5 ? wander(t - 0.5) : Vec3(0, 0, 0));
    sample.direction_W = Vec3(0, std::cos(tilt), -std::sin(tilt));
    return sample;
  });
}

TEST(AtRest, NeitherACreepNorATremorTurnsTheForceOfARupture) {
  struct Wander {
    Vec3 (*at)(double t_s);
    double most_rad;
  };
  const Wander wanders[] = {
      {[](double t) { return Vec3(-1e-9 * t, 0, 0); }, 1e-4},
      {[](double t) { return Vec3(0, 1e-9 * t, 0); }, 1e-4},
      // After the rupture 0.13 mm of stretch are left, anew from wherever the tremor was: 10 um from there
      // to its other end, on an axis stiffer by a quarter, are 0.094 rad.
      {[](double t) { return Vec3(0, 5e-6 * std::sin(2 * std::numbers::pi * 8 * t), 0); }, 0.095}};
  for (const Events events : {Events::exact, Events::tick}) {
    for (const Restick restick : {Restick::level, Restick::crossing}) {
      for (const Wander& wander : wanders) {
        const auto rows = tilted_until_it_gives_way(events, restick, wander.at);
        EXPECT_GE(test::ruptures_of(rows), 1);
        for (std::size_t k = 500; k < rows.size(); ++k) {
          const Vec3 friction = rows[k].friction_W_n;
          const double off_rad = std::atan2(std::abs(friction.y()), -friction.x());
          ASSERT_LT(off_rad, wander.most_rad) << k;
        }
      }
    }
  }
}

TEST(AtRest, LandingAtSpeedGivesNeitherAJumpNorEnergy) {
  for (const std::string law : {"stick-slip", "finger-pad", "salisbury", "salcudean-vlaar", "contact-area"}) {
    const auto rows = run_places(plane_world(), plane_scene(law), 200, [](long k) {
      // In at 0.12 m/s, touching at tick 10, then held at once, and drawn back by 0.2 mm at 2 mm/s.
      const double at = static_cast<double>(k);
      const double x = at < 11 ? 1.2e-4 * at : 1.2e-4 * 10 - 2e-6 * std::min(at - 10, 100.0);
      return Vec3(x, 0, at < 9.5 ? 1e-4 : -1e-3);
    });
    EXPECT_EQ(rows[9].phase, Phase::free);
    EXPECT_EQ(rows[10].friction_W_n, Vec3::Zero()) << law;
    EXPECT_LE(friction_work_j(rows), 1e-12) << law;
  }
}

TEST(AtRest, UnderASteadyPushThePadCreepsNotAtAll) {
  // Held 0.29 mm from its centre, within a hair of its limit, for ten seconds.
  for (const Events events : {Events::exact, Events::tick}) {
    Scene scene = plane_scene("stick-slip");
    scene.friction.settings.events = events;
    const auto rows = run_places(plane_world(), scene, 10300,
                                 [](long k) { return Vec3(1e-6 * std::min(k, 299L), 0, -1e-3); });
    for (std::size_t k = 300; k < rows.size(); ++k) {
      ASSERT_EQ(rows[k].stick_centre_W, rows[0].stick_centre_W);
      ASSERT_EQ(rows[k].force_W_n, rows[299].force_W_n);
    }
  }
}

}  // namespace
}  // namespace fingerpad::at_rest_test
