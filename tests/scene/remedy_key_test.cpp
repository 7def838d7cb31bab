#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/scene_text.hpp"

namespace fingerpad::remedy_key_test {
namespace {

using test::plane_scene;
using test::read_scene;
using test::refusal;

TEST(SceneRemedy, IsOffUnlessNamed) {
  EXPECT_EQ(read_scene(plane_scene).friction.settings.remedy, Remedy::none);
  const Scene scene =
      read_scene(plane_scene + "[friction]\nremedy = \"implicit\"\ndevice_damping_n_s_per_m = 2\n");
  EXPECT_EQ(scene.friction.settings.remedy, Remedy::implicit);
  EXPECT_EQ(scene.friction.settings.numbers.at("device_damping_n_s_per_m"), 2);
}

TEST(SceneRemedy, RefusesAnUnknownOneAtItsPlace) {
  EXPECT_THAT(refusal(plane_scene + "[friction]\nremedy = \"prayer\"\n"),
              testing::StartsWith("s.toml:6:10: "));
}

}  // namespace
}  // namespace fingerpad::remedy_key_test
