#include "device/pointer_rest.hpp"

#include <gtest/gtest.h>

namespace fingerpad::pointer_rest_test {
namespace {

PointerAim aim_at(double x_m) {
  PointerAim aim;
  aim.finger.p_WQ = Vec3(x_m, 0, 0);
  return aim;
}

TEST(PointerRest, AFlightEndsWhenThePointerHasRestedForLong) {
  PointerRest rest;
  const PointerAim aim = aim_at(0.1);
  for (int k = 0; k < 2900; ++k) rest.note(aim, aim, 1e-3);
  EXPECT_EQ(rest.flying_left(), 1);
  double last = 1;
  for (int k = 0; k < 5000; ++k) {
    rest.note(aim, aim, 1e-3);
    EXPECT_LE(rest.flying_left(), last);
    EXPECT_GT(rest.flying_left() - last, -0.01) << "no jump";
    last = rest.flying_left();
  }
  EXPECT_EQ(last, 0);
  rest.note(aim, aim_at(0.2), 1e-3);
  EXPECT_EQ(rest.flying_left(), 1) << "the pointer goes on";
  PointerAim turned = aim;
  for (int k = 0; k < 8000; ++k) rest.note(aim, aim, 1e-3);
  turned.towards_eye_W = Vec3::UnitX();
  rest.note(aim, turned, 1e-3);
  EXPECT_EQ(rest.flying_left(), 1) << "seen from elsewhere";
}

TEST(PointerRest, APressedFingerRestsWithinASecondOfItsLanding) {
  PointerRest rest;
  const PointerAim aim = aim_at(0.1);
  for (int k = 0; k < 2000; ++k) rest.note(aim, aim, 1e-3);
  EXPECT_EQ(rest.pressing_left(), 1) << "it is on its way";
  for (int k = 0; k < 1000; ++k) rest.press(1e-6, 1e-3);
  EXPECT_EQ(rest.pressing_left(), 0);
  EXPECT_GT(rest.gone_m(), 0);
  EXPECT_LT(rest.gone_m(), 0.9e-3) << "of its rest alone";
  rest.forget();
  EXPECT_EQ(rest.pressing_left(), 1);
  EXPECT_EQ(rest.gone_m(), 0);
}

}  // namespace
}  // namespace fingerpad::pointer_rest_test
