#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/scene_text.hpp"

namespace fingerpad::rate_key_test {
namespace {

using test::plane_scene;
using test::read_scene;
using test::refusal;
using testing::StartsWith;

const std::string sine =
    "[motion]\nkind = \"sine\"\ncentre_m = [0,0,0]\namplitude_m = 1\nfrequency_hz = 1\nduration_s = 1\n";

TEST(RateKey, MayLeaveTheRateToTheProgram) {
  const MotionSettings motion = read_scene(plane_scene + sine + "rate_hz = \"auto\"\n").motion;
  EXPECT_TRUE(motion.automatic_rate);
  EXPECT_TRUE(motion.is_rate_open());
  EXPECT_FALSE(motion.has_own_rate());
  EXPECT_FALSE(read_scene(plane_scene + sine + "rate_hz = 500\n").motion.automatic_rate);
  // Nor is it a file's own.
  EXPECT_FALSE(
      read_scene(plane_scene + "[motion]\nfile = \"m.csv\"\nrate_hz = \"auto\"\n").motion.has_own_rate());
}

TEST(RateKey, RefusesAnotherWord) {
  EXPECT_THAT(refusal(plane_scene + sine + "rate_hz = \"fast\"\n"),
              StartsWith("s.toml:11:11: 'rate_hz' in [motion] must be a number or \"auto\", not \"fast\""));
}

TEST(RateKey, LeftOpenReadsTheTolerances) {
  const std::string contact = "[contact]\nmethod = \"proxy\"\nmu_tolerance = 0.2\n";
  EXPECT_NE(refusal(plane_scene + contact + sine), "");
  EXPECT_EQ(refusal(plane_scene + contact + sine + "rate_hz = \"auto\"\n"), "");
}

TEST(RateKey, OfASetIsANumberOrLeftOpen) {
  const SceneFile file =
      read_scene_text(plane_scene + sine + "[[set]]\nmotion.rate_hz = [500, \"auto\"]\n", "s.toml");
  ASSERT_EQ(file.jobs.size(), 2u);
  EXPECT_EQ(file.jobs[0].scene.motion.rate_hz, 500);
  EXPECT_TRUE(file.jobs[1].scene.motion.automatic_rate);
}

}  // namespace
}  // namespace fingerpad::rate_key_test
