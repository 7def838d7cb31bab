#include "study/stick_energy.hpp"

#include <gtest/gtest.h>

namespace fingerpad::stick_energy_test {
namespace {

TEST(StickEnergy, AStretchedSpringGivesEnergyWhenTheLoadRises) {
  // SCIENCE 3, passivity: 1 -> 3 N at nine tenths of rupture gives k_f (n2 - n1) d^2/2 = 7.29e-5 J; a
  // trapezium sum of a force linear in the way is exact but for rounding.
  EXPECT_NEAR(energy_of_cycle({.released_n = 3}), 1000 * 2 * 2.7e-4 * 2.7e-4 / 2, 1e-15);
  EXPECT_LT(energy_of_cycle({.released_n = 0.5}), 0);
}

TEST(StickEnergy, AtConstantLoadAndAngleNoLawGivesEnergy) {
  for (const char* law : {"stick-slip", "finger-pad", "salisbury", "dahl", "lugre", "elasto-plastic",
                          "max-displacement", "friction-cone", "kikuuwe"}) {
    EXPECT_LT(energy_of_cycle({.law = law}), 1e-18) << law;  // rounding of 1000 sums of 1e-7 J
  }
}

TEST(StickEnergy, TiltingTheFingerGivesEnergyToo) {
  const StickCycle raised{.law = "finger-pad", .stretch_m = 1.35e-4, .released_rad = 1.2};
  EXPECT_GT(energy_of_cycle(raised), 1e-6);
}

}  // namespace
}  // namespace fingerpad::stick_energy_test
