#include "touch/unit_hints.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "scene/scene.hpp"
#include "touch/world.hpp"

namespace fingerpad::unit_hints_test {
namespace {

World world_of_size(double part_m) {
  World world;
  Verdict& verdict = world.verdicts.emplace_back();
  verdict.touchable = true;
  verdict.bounds_m.min = Vec3::Zero();
  verdict.bounds_m.max = Vec3(part_m, part_m / 2, part_m / 3);
  return world;
}

Scene scene_of(double radius_m) {
  Scene scene;
  scene.finger.radius_m = radius_m;
  scene.finger.radius_place = "pad.toml:9:12";
  return scene;
}

std::string hint_of(double radius_m, double part_m) {
  return finger_hint(world_of_size(part_m), scene_of(radius_m));
}

// A fingertip of seven metres is hardly meant.
TEST(UnitHints, TellOfAFingerWhoseMillimetresAreReadAsMetres) {
  EXPECT_NE(hint_of(7, 0.12).find("radius_m = 0.007"), std::string::npos) << hint_of(7, 0.12);
}

TEST(UnitHints, TellOfSuchAFingerOverPlanesAlone) {
  EXPECT_EQ(
      finger_hint(World(), scene_of(7)),
      "pad.toml:9:12: a finger of radius_m = 7; it is in metres: if millimetres are meant, radius_m = 0.007");
  EXPECT_EQ(finger_hint(World(), scene_of(0.01)), "");
}

TEST(UnitHints, SayWhereTheRadiusStands) {
  EXPECT_EQ(hint_of(7, 0.12).find("pad.toml:9:12: a finger of radius_m = 7, "), 0u) << hint_of(7, 0.12);
}

// It would press with as many thousand newtons as it has metres.
TEST(UnitHints, RefuseAFingerOfMetresOnASmallPart) {
  const auto is_refused = [](const Scene& scene, double part_m) {
    try {
      refuse_huge_finger(world_of_size(part_m), scene);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::refused);
      EXPECT_EQ(std::string(error.what()).find("pad.toml:9:12: "), 0u) << error.what();
      return true;
    }
    return false;
  };
  EXPECT_TRUE(is_refused(scene_of(7), 0.12));
  EXPECT_TRUE(is_refused(scene_of(0.51), 0.12));
  EXPECT_FALSE(is_refused(scene_of(0.5), 0.12)) << "it is told of";
  EXPECT_FALSE(is_refused(scene_of(7), 20)) << "a ball on a hull";
  Scene on_floor = scene_of(7);
  on_floor.planes.emplace_back();
  EXPECT_FALSE(is_refused(on_floor, 0.12)) << "a floor is larger than any ball";
}

TEST(UnitHints, LeaveFingersAlone) {
  EXPECT_EQ(hint_of(0.007, 0.12), "");
  EXPECT_EQ(hint_of(0.007, 0.003), "") << "a screw";
  EXPECT_EQ(hint_of(0, 0.12), "");
  EXPECT_EQ(hint_of(0.5, 3), "") << "a ball on a car";
}

}  // namespace
}  // namespace fingerpad::unit_hints_test
