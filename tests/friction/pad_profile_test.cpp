#include "friction/pad_profile.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

namespace fingerpad::pad_profile_test {
namespace {

using testing::HasSubstr;

constexpr double deg = std::numbers::pi / 180;

TEST(PadProfile, AxesFallLinearlyWithTheAngle) {
  const PadProfile pad = assumed_profile(0.3, 1000);
  EXPECT_NEAR(pad.lateral_axis_at(45 * deg), 3e-4, 1e-18);
  EXPECT_NEAR(pad.longitudinal_axis_at(45 * deg), 2.4e-4, 1e-18);
  EXPECT_NEAR(pad.lateral_axis_at(0), 3e-4 * 1.45, 1e-18);
  EXPECT_NEAR(pad.lateral_axis_at(90 * deg), 3e-4 * 0.55, 1e-18);
  EXPECT_THAT(pad.source, HasSubstr("assumption"));
}

}  // namespace
}  // namespace fingerpad::pad_profile_test
