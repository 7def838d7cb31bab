#include "device/pointer_tap.hpp"

#include <gtest/gtest.h>

namespace fingerpad::pointer_tap_test {
namespace {

constexpr double dt_s = 1e-3;
constexpr int longest_ticks = static_cast<int>(pointer_limits::tap_s / dt_s),
              longest_wait = static_cast<int>(pointer_limits::tap_waits_s / dt_s);

PointerAim aim_at(double x_m, double push_n) {
  PointerAim aim;
  aim.finger.p_WQ = Vec3(x_m, 0, 0);
  aim.finger.push_W_n = Vec3(0, 0, -push_n);
  return aim;
}

TEST(PointerTap, AsksOnWhereThePressWasLetGoUntilItIsFelt) {
  PointerTap tap;
  const PointerAim first = aim_at(0.1, 1), last = aim_at(0.2, 1), off = aim_at(0.3, 0);
  EXPECT_FALSE(tap.lead(off, 0, dt_s).presses()) << "nothing was pressed yet";
  EXPECT_EQ(tap.lead(first, 0, dt_s).finger.p_WQ, first.finger.p_WQ);
  tap.lead(last, 0, dt_s);
  for (int k = 0; k < 50; ++k) {
    const PointerAim& led = tap.lead(off, 0.4, dt_s);
    ASSERT_TRUE(led.presses()) << k;
    ASSERT_EQ(led.finger.p_WQ, last.finger.p_WQ);
  }
  EXPECT_FALSE(tap.lead(off, 0.6, dt_s).presses());
  EXPECT_FALSE(tap.lead(off, 0, dt_s).presses()) << "no second time";
  tap.lead(first, 0, dt_s);
  EXPECT_TRUE(tap.lead(off, 0, dt_s).presses()) << "but the next press";
}

TEST(PointerTap, GivesUpWhatDoesNotGetThere) {
  PointerTap tap;
  const PointerAim on = aim_at(0.1, 1), off = aim_at(0.1, 0);
  tap.lead(on, 0, dt_s);
  int asked = 0;
  while (asked < 2 * longest_wait && tap.lead(off, 0, dt_s).presses()) ++asked;
  EXPECT_NEAR(asked, longest_wait, 2);
}

TEST(PointerTap, LetsGoAtOnceWhatWasPressedForLong) {
  PointerTap tap;
  const PointerAim on = aim_at(0.1, 1), off = aim_at(0.1, 0);
  for (int k = 0; k < longest_ticks + 2; ++k) EXPECT_TRUE(tap.lead(on, 0, dt_s).presses());
  EXPECT_FALSE(tap.lead(off, 0, dt_s).presses());
  for (const double felt_n : {0.0, 0.9}) tap.lead(on, felt_n, dt_s);
  EXPECT_FALSE(tap.lead(off, 0.9, dt_s).presses()) << "nor what was felt";
}

TEST(PointerTap, TakesTheForceOfThePressBeforeForNoneOfItsOwn) {
  PointerTap tap;
  const PointerAim first = aim_at(0.1, 1), second = aim_at(0.2, 1), off = aim_at(0.1, 0);
  tap.lead(first, 0, dt_s);
  tap.lead(off, 0.7, dt_s);
  tap.lead(second, 0.6, dt_s);
  EXPECT_TRUE(tap.lead(off, 0.55, dt_s).presses());
  EXPECT_TRUE(tap.lead(off, 0.1, dt_s).presses());
  EXPECT_FALSE(tap.lead(off, 0.6, dt_s).presses()) << "this is its own";
}

// As where the scene is changed under the finger, which may press at that time.
TEST(PointerTap, AsksForNothingOnOnceItHasLetGo) {
  for (const bool is_pressed : {false, true}) {
    PointerTap tap;
    const PointerAim on = aim_at(0.1, 1), off = aim_at(0.1, 0);
    tap.lead(on, 0, dt_s);
    if (!is_pressed) tap.lead(off, 0, dt_s);
    tap.let_go();
    if (is_pressed) tap.lead(on, 0, dt_s);
    EXPECT_FALSE(tap.lead(off, 0, dt_s).presses());
    tap.lead(on, 0, dt_s);
    EXPECT_TRUE(tap.lead(off, 0, dt_s).presses()) << "but the next press";
  }
}

}  // namespace
}  // namespace fingerpad::pointer_tap_test
