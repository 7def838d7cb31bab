#include "touch/resting_finger.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/shapes.hpp"
#include "support/worlds.hpp"

namespace fingerpad::resting_finger_test {
namespace {

TEST(RestingFinger, StandsClearOfWhatCanBeTouched) {
  const auto torus = test::world_of(test::torus_soup(0.05, 0.02, 48, 24));
  Scene scene;
  scene.finger.radius_m = 0.004;
  const Vec3 p = resting_finger(*torus, scene).p_WQ;
  EXPECT_GT(std::hypot(std::hypot(p.x(), p.y()) - 0.05, p.z()) - 0.02, 0.004 + 0.005);
  EXPECT_NEAR(resting_finger(*test::plane_world(), Scene{}).p_WQ.z(), 0.01, 1e-12);
  EXPECT_TRUE(resting_finger(World{}, Scene{}).p_WQ.allFinite());
}

}  // namespace
}  // namespace fingerpad::resting_finger_test
