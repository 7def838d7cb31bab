#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/scene_text.hpp"

namespace fingerpad::repair_key_test {
namespace {

using test::read_scene;
using test::refusal;

const std::string part = "[[part]]\nmesh = \"a.stl\"\n";

TEST(SceneRepair, IsOffUnlessAskedFor) {
  EXPECT_FALSE(read_scene(part).parts[0].repair);
  const Scene scene = read_scene(part + "repair = true\n" + part + "repair = false\n");
  EXPECT_TRUE(scene.parts[0].repair);
  EXPECT_FALSE(scene.parts[1].repair);
}

TEST(SceneRepair, CanBeSetKeyByKeyInASet) {
  const SceneFile file =
      read_scene_text(part + "[[set]]\npart.repair = [true, false]\nmesh = [\"a.stl\"]\n", "s.toml");
  ASSERT_EQ(file.jobs.size(), 2u);
  EXPECT_TRUE(file.jobs[0].scene.parts[0].repair);
  EXPECT_FALSE(file.jobs[1].scene.parts[0].repair);
}

TEST(SceneRepair, RefusesWhatIsNeitherTrueNorFalse) {
  EXPECT_THAT(refusal(part + "repair = 1\n"),
              testing::StartsWith("s.toml:3:10: 'repair' in [[part]] must be true or false"));
  EXPECT_THAT(refusal("[[plane]]\npoint_m = [0,0,0]\nnormal = [0,0,1]\nrepair = true\n"),
              testing::StartsWith("s.toml:4:1: "));
}

}  // namespace
}  // namespace fingerpad::repair_key_test
