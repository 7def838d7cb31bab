#include <gtest/gtest.h>

#include "touch/skin_motion.hpp"

namespace fingerpad::last_inclination_test {
namespace {

TEST(LastInclination, IsTheInclinationWhateverCameBefore) {
  const Vec3 slanted(0, 0.6, -0.8), up = Vec3::UnitZ(), aside = Vec3::UnitX(), along = Vec3::UnitY();
  LastInclination last;
  for (const Vec3& normal_W : {aside, up, up, Vec3(-up), up, aside, along, along})
    EXPECT_EQ(last.of(slanted, normal_W), inclination_rad(slanted, normal_W)) << normal_W.transpose();
  EXPECT_EQ(last.of(up, along), 0) << "another direction";
}

}  // namespace
}  // namespace fingerpad::last_inclination_test
