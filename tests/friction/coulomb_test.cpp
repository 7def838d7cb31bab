#include <gtest/gtest.h>

#include "support/sliding_mass.hpp"

namespace fingerpad::coulomb_test {
namespace {

using test::make_law;
using test::PlaneContact;
using test::pressed;

TEST(Coulomb, SlipForceOpposesTheMotion) {
  const auto law = make_law("coulomb");
  PlaneContact contact{*law, pressed(2, 1000)};
  const Friction f = contact.move_to({0, 0}, {0.3, 0.4});
  EXPECT_EQ(f.phase, Phase::slip);
  EXPECT_NEAR((f.force_n - Vec2(-0.24, -0.32)).norm(), 0, 1e-15);  // a few roundings of 0.4
}

TEST(Coulomb, CreepsUnderAPushAtTheStatedSpeed) {
  const double v_t = 0.004, n = 2, push_n = 0.1;
  const auto law = make_law("coulomb", test::settings_of({{"creep_speed_m_per_s", v_t}}));
  PlaneContact contact{*law, pressed(n, 1000)};
  const double creep = push_n * v_t / (0.2 * n);
  EXPECT_NEAR(contact.move_to({0, 0}, {creep, 0}).force_n.x(), -push_n, 1e-15);
}

TEST(Coulomb, AMassUnderASteadyPushCreepsAtTheStatedSpeedForEver) {
  const auto law = make_law("coulomb");
  test::SlidingMass mass{{*law, pressed(1, 1000)}};
  const auto push = [](double, double) { return 0.1; };
  while (mass.t_s < 4) mass.tick(push);
  const double start_m = mass.x_m;
  while (mass.t_s < 8) mass.tick(push);
  // f v_t/(mu n) = 5 mm/s at the defaults; 4 s are 4000 ticks, and one may be miscounted.
  EXPECT_NEAR((mass.x_m - start_m) / 4, 0.1 * 0.01 / 0.2, 1e-5);
}

TEST(None, NeverPushes) {
  const auto law = make_law("none");
  PlaneContact contact{*law, pressed(5, 1000)};
  EXPECT_EQ(contact.move_to({0, 0}, {1, 1}).force_n, Vec2(0, 0));
  EXPECT_EQ(contact.move_to({1, 0}).phase, Phase::slip);
}

}  // namespace
}  // namespace fingerpad::coulomb_test
