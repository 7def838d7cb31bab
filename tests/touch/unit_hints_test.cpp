#include "touch/unit_hints.hpp"

#include <gtest/gtest.h>

#include "scene/scene.hpp"
#include "touch/world.hpp"

namespace fingerpad::unit_hints_test {
namespace {

std::string hint_of(double radius_m, double part_m) {
  World world;
  Verdict& verdict = world.verdicts.emplace_back();
  verdict.touchable = true;
  verdict.bounds_m.min = Vec3::Zero();
  verdict.bounds_m.max = Vec3(part_m, part_m / 2, part_m / 3);
  Scene scene;
  scene.finger.radius_m = radius_m;
  return finger_hint(world, scene);
}

// A fingertip of seven metres is hardly meant.
TEST(UnitHints, TellOfAFingerWhoseMillimetresAreReadAsMetres) {
  EXPECT_NE(hint_of(7, 0.12).find("radius_m = 0.007"), std::string::npos) << hint_of(7, 0.12);
}

TEST(UnitHints, LeaveFingersAlone) {
  EXPECT_EQ(hint_of(0.007, 0.12), "");
  EXPECT_EQ(hint_of(0.007, 0.003), "") << "a screw";
  EXPECT_EQ(hint_of(0, 0.12), "");
  EXPECT_EQ(hint_of(0.5, 3), "") << "a ball on a car";
}

}  // namespace
}  // namespace fingerpad::unit_hints_test
