#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/scene_text.hpp"

namespace fingerpad::device_keys_test {
namespace {

using test::plane_scene;
using test::read_scene;
using test::refusal;
using testing::HasSubstr;
using testing::StartsWith;

TEST(SceneDevice, DefaultsAreTheDocumentedOnes) {
  const DeviceSettings device = read_scene(plane_scene).device;
  EXPECT_EQ(device.rotation, Mat3::Identity());
  EXPECT_EQ(device.scale, 1);
  EXPECT_EQ(device.offset_m, Vec3::Zero());
  EXPECT_EQ(device.force_scale, 1);
  EXPECT_EQ(device.force_limit_n, 5);
  EXPECT_EQ(device.force_rate_limit_n_per_s, 2000);
  EXPECT_EQ(device.watchdog_s, 0.02);
  EXPECT_EQ(device.soft_start_s, 0.05);
}

TEST(SceneDevice, EveryKeyIsReadAndWrittenIntoTheScenesText) {
  const Scene scene = read_scene(plane_scene +
                                 "[device]\nrotation = { axis = [0, 0, 2], angle_deg = 90 }\nscale = 3\n"
                                 "offset_m = [0.1, 0, 0]\nforce_scale = 0.5\nforce_limit_n = 2\n"
                                 "force_rate_limit_n_per_s = 100\nwatchdog_s = 0.1\nsoft_start_s = 0\n");
  for (const DeviceSettings& device : {scene.device, read_scene(scene.text).device}) {
    EXPECT_NEAR((device.rotation * Vec3::UnitX() - Vec3::UnitY()).norm(), 0, 1e-15);  // cos 90 deg rounds
    EXPECT_EQ(device.scale, 3);
    EXPECT_EQ(device.offset_m, Vec3(0.1, 0, 0));
    EXPECT_EQ(device.force_scale, 0.5);
    EXPECT_EQ(device.force_limit_n, 2);
    EXPECT_EQ(device.force_rate_limit_n_per_s, 100);
    EXPECT_EQ(device.watchdog_s, 0.1);
    EXPECT_EQ(device.soft_start_s, 0);
  }
}

TEST(SceneDevice, RefusesWhatIsNoLimit) {
  const auto with = [](const std::string& line) { return plane_scene + "[device]\n" + line + "\n"; };
  EXPECT_THAT(refusal(with("force_limit_n = -1")), StartsWith("s.toml:6:17: 'force_limit_n' in [device]"));
  EXPECT_THAT(refusal(with("force_limit_n = inf")), StartsWith("s.toml:6:17: "));
  EXPECT_THAT(refusal(with("force_rate_limit_n_per_s = 0")), StartsWith("s.toml:6:28: "));
  EXPECT_THAT(refusal(with("watchdog_s = 0")), StartsWith("s.toml:6:14: "));
  EXPECT_THAT(refusal(with("rotation = 90")), HasSubstr("must be { axis = [x, y, z], angle_deg = a }"));
  EXPECT_THAT(refusal(with("force_limit = 3")),
              AllOf(StartsWith("s.toml:6:1: "), HasSubstr("force_limit_n")));
}

}  // namespace
}  // namespace fingerpad::device_keys_test
