#include <gtest/gtest.h>

#include "support/plane_contact.hpp"

namespace fingerpad::remedy_test {
namespace {

using test::make_law;
using test::PlaneContact;
using test::pressed;

constexpr double rounding = 1e-12;

LawSettings remedied_by(Remedy remedy) {
  LawSettings settings;
  settings.remedy = remedy;
  return settings;
}

/// The answer at a stretch of d, reached from the centre in one step of a millisecond.
Friction stretched(const LawSettings& settings, double load_n, double d_m) {
  const auto law = make_law("stick-slip", settings);
  PlaneContact contact{*law, pressed(load_n, 1000)};
  contact.move_to({0, 0});
  return contact.move_to({d_m, 0});
}

TEST(Remedy, LeavesASpringThatTheLoopHoldsAlone) {
  // b = 0.5 N s/m at 1 kHz holds 2 b/T = 1000 N/m, of which 950 are used: the pad's spring at 0.95 N.
  const Friction plain = stretched({}, 0.94, 1e-4);
  for (const Remedy remedy : {Remedy::damping, Remedy::implicit, Remedy::cap}) {
    const Friction held = stretched(remedied_by(remedy), 0.94, 1e-4);
    EXPECT_FALSE(held.remedied);
    EXPECT_EQ(held.force_n, plain.force_n);
  }
}

TEST(Remedy, CapSoftensTheSpringAndKeepsItsLimit) {
  const Friction soft = stretched(remedied_by(Remedy::cap), 4, 1e-4);
  EXPECT_TRUE(soft.remedied);
  EXPECT_NEAR(soft.force_n.x(), -950 * 1e-4, rounding);
  EXPECT_EQ(stretched(remedied_by(Remedy::cap), 4, 1.26e-3).phase, Phase::stick);  // mu_s n/K = 1.263 mm
  EXPECT_EQ(stretched(remedied_by(Remedy::cap), 4, 1.27e-3).ruptures, 1);
}

TEST(Remedy, ImplicitReadsTheSpringATickLater) {
  const Friction read = stretched(remedied_by(Remedy::implicit), 2, 1e-4);
  EXPECT_TRUE(read.remedied);
  EXPECT_NEAR(read.force_n.x(), -2000 * 2e-4, rounding);  // at 0.1 m/s the finger will be twice as far
}

TEST(Remedy, DampingAddsAForceAgainstTheMotion) {
  const Friction damped = stretched(remedied_by(Remedy::damping), 2, 1e-4);
  EXPECT_TRUE(damped.remedied);
  EXPECT_NEAR(damped.force_n.x(), -2000 * 1e-4 - 1.5 * (2000 - 950) * 1e-3 / 2 * 0.1, rounding);
}

TEST(Remedy, NeverPassesTheStaticLimit) {
  for (const Remedy remedy : {Remedy::damping, Remedy::implicit}) {
    const Friction fast = stretched(remedied_by(remedy), 10, 2.9e-4);
    EXPECT_EQ(fast.phase, Phase::stick);
    EXPECT_NEAR(fast.force_n.norm(), 3, 1e-9);
  }
}

TEST(Remedy, AtRestDampersAreSilent) {
  for (const Remedy remedy : {Remedy::damping, Remedy::implicit}) {
    const auto law = make_law("stick-slip", remedied_by(remedy));
    PlaneContact contact{*law, pressed(4, 1000)};
    contact.move_to({0, 0});
    contact.move_to({1e-4, 0});
    EXPECT_NEAR(contact.move_to({1e-4, 0}).force_n.x(), -0.4, rounding);
  }
}

}  // namespace
}  // namespace fingerpad::remedy_test
