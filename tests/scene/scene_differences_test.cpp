#include "scene/scene_differences.hpp"

#include <gtest/gtest.h>

namespace fingerpad::scene_differences_test {
namespace {

using Words = std::vector<std::string>;

TEST(SceneDifferences, NameOnlyWhatDiffers) {
  const auto scene = [](const std::string& mu, const std::string& name) {
    return "name = \"" + name + "\"\n[[part]]\nmesh = \"a.stl\"\nmu_static = " + mu +
           "\n[motion]\nrate_hz = 1000\n";
  };
  EXPECT_EQ(scene_differences({scene("0.30", "a"), scene("0.4", "b")}),
            (Words{"mu_static 0.3", "mu_static 0.4"}));
  EXPECT_EQ(scene_differences({scene("0.3", "a"), scene("0.3", "a")}), (Words{"", ""}));
}

TEST(SceneDifferences, AreNoneInHowANumberIsWritten) {
  const std::string plane = "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n[motion]\n";
  const std::string same = "[[plane]]\npoint_m = [0.0, 0e3, 0]\nnormal = [0, 0, 1.0]\n[motion]\n";
  EXPECT_EQ(scene_differences({plane + "rate_hz = 1000\n", same + "rate_hz = 1000.0\n"}), (Words{"", ""}));
  EXPECT_EQ(scene_differences({plane + "rate_hz = 1000\n", same + "rate_hz = 1e4\n"}),
            (Words{"rate_hz 1000", "rate_hz 10000.0"}));
  EXPECT_EQ(scene_differences({"seed = 9007199254740993\n", "seed = 9007199254740992\n"}),
            (Words{"seed 9007199254740993", "seed 9007199254740992"}))
      << "which are one double";
}

TEST(SceneDifferences, CallFilesByTheirNamesAndTellDefaults) {
  EXPECT_EQ(scene_differences({"[[part]]\nmesh = \"x/a.stl\"\n[friction]\nlaw = \"dahl\"\n",
                               "[[part]]\nmesh = \"y/b.stl\"\n"}),
            (Words{"law dahl, a.stl", "law as by default, b.stl"}));
}

TEST(SceneDifferences, TellKeysThatEndAlikeApart) {
  EXPECT_EQ(scene_differences({"[[part]]\nmu_static = 0.1\n[[part]]\nmu_static = 0.2\n",
                               "[[part]]\nmu_static = 0.3\n[[part]]\nmu_static = 0.4\n"}),
            (Words{"part 2.mu_static 0.2, part.mu_static 0.1", "part 2.mu_static 0.4, part.mu_static 0.3"}));
}

TEST(SceneDifferences, NameATableThatOthersHaveMoreOfOnce) {
  const std::string one = "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n";
  EXPECT_EQ(scene_differences({one + "[[plane]]\npoint_m = [1, 0, 0]\nnormal = [1, 0, 0]\n", one}),
            (Words{"normal [1, 0, 0], point_m [1, 0, 0]", "no plane 2"}));
  EXPECT_EQ(scene_differences({one, "[[part]]\nmesh = \"a.stl\"\n"}),
            (Words{"no part, normal [0, 0, 1], point_m [0, 0, 0]", "a.stl, no plane"}));
}

}  // namespace
}  // namespace fingerpad::scene_differences_test
