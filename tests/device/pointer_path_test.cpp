#include "device/pointer_path.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace fingerpad::pointer_path_test {
namespace {

constexpr double dt_s = 1e-3;

PointerAim aim_at(double t_s, double x_m) {
  PointerAim aim;
  aim.finger.t_s = t_s;
  aim.finger.p_WQ = Vec3(x_m, 0, 0);
  return aim;
}

PointerAim press_at(double t_s, double x_m) {
  PointerAim press = aim_at(t_s, x_m);
  press.finger.push_W_n = Vec3(0, 0, -1);
  return press;
}

/// A pointer at 0.2 m/s whose events, 125 a second, are handed over once in `frame_s`.
double unevenness_m_per_s(double frame_s) {
  PointerPath path(aim_at(0, 0));
  double worst = 0, last_m = 0;
  int event = 1;
  for (int k = 0; k < 2000; ++k) {
    const double handed_over_s = std::floor(k * dt_s / frame_s) * frame_s;
    for (; event * 0.008 <= handed_over_s; ++event)
      path.put(aim_at(100 + event * 0.008, 0.2 * event * 0.008));
    const double x_m = path.advance(dt_s).finger.p_WQ.x();
    if (k * dt_s > 0.5) worst = std::max(worst, std::abs((x_m - last_m) / dt_s - 0.2));
    last_m = x_m;
  }
  EXPECT_NEAR(last_m, 0.4, 0.05);  // two frames late at the most
  return worst;
}

TEST(PointerPath, GoesAsFastAsThePointerWentHoweverSlowTheFrames) {
  EXPECT_LT(unevenness_m_per_s(0.008), 1e-9);
  // A frame of 0.1 s, which no pointer of the frames' own pace would come through evenly.
  EXPECT_LT(unevenness_m_per_s(0.1), 1e-9);
}

TEST(PointerPath, SetsOutAnewAfterARestWithoutCreepingThroughIt) {
  PointerPath path(aim_at(0, 0));
  path.put(aim_at(1, 0));
  for (int k = 0; k < 100; ++k) path.advance(dt_s);
  path.put(aim_at(60, 0.1));
  int ticks = 0;
  while (path.advance(dt_s).finger.p_WQ.x() < 0.1 && ticks < 1000) ++ticks;
  EXPECT_LT(ticks, 20);
}

TEST(PointerPath, PressesAndLiftsInTheOrderOfTheEventsAndForgetsNone) {
  PointerPath path(aim_at(0, 0));
  path.put(press_at(1, 0.01));
  path.put(aim_at(1.002, 0.01));  // a click within one frame
  int pressed = 0;
  for (int k = 0; k < 100; ++k) pressed += path.advance(dt_s).finger.push_W_n.z() < 0 ? 1 : 0;
  EXPECT_GE(pressed, 1);
  EXPECT_LE(pressed, 3);
}

// At 50 Hz a tick is longer than a click, and than the time between two; and a loop that comes late leaps.
TEST(PointerPath, ShowsEachPressAndItsEndHoweverShort) {
  for (const double tick_s : {1e-3, 0.02, 0.1}) {
    for (const double rests_at_s : {1.5, 60.0}) {
      PointerPath path(aim_at(0, 0));
      for (int click = 0; click < 3; ++click) {
        path.put(press_at(1 + 0.016 * click, 0.01));
        path.put(aim_at(1.008 + 0.016 * click, 0.01));
      }
      path.put(aim_at(rests_at_s, 0.02));
      int begun = 0, ended = 0;
      bool was_pressed = false;
      for (int k = 0; k < 3000; ++k) {
        const bool is_pressed = path.advance(tick_s).presses();
        begun += is_pressed && !was_pressed ? 1 : 0;
        ended += was_pressed && !is_pressed ? 1 : 0;
        was_pressed = is_pressed;
      }
      EXPECT_EQ(begun, 3) << tick_s << " " << rests_at_s;
      EXPECT_EQ(ended, 3) << tick_s << " " << rests_at_s;
    }
  }
}

TEST(PointerPath, APressStaysWhereItIsUntilTheEventThatEndsIt) {
  PointerPath path(aim_at(0, 0));
  path.put(press_at(1, 0.01));
  path.put(aim_at(1.05, 0.03));
  for (int k = 0; k < 200; ++k) {
    const PointerAim& shown = path.advance(dt_s);
    if (shown.presses()) {
      ASSERT_EQ(shown.finger.p_WQ.x(), 0.01);
    }
  }
  EXPECT_EQ(path.advance(dt_s).finger.p_WQ.x(), 0.03);
}

TEST(PointerPath, TakesTimesThatGoBackAndMoreEventsThanItHolds) {
  PointerPath path(aim_at(0, 0));
  for (int k = 0; k < 5000; ++k) path.put(aim_at(10 - k, k));
  double farthest_m = 0;
  for (int k = 0; k < 2000; ++k) farthest_m = std::max(farthest_m, path.advance(dt_s).finger.p_WQ.x());
  EXPECT_GE(farthest_m, 1000) << "as many events as it has places for are played";
  EXPECT_LT(farthest_m, 1024);
  path.put(aim_at(5, 0.5));
  for (int k = 0; k < 100; ++k) path.advance(dt_s);
  EXPECT_EQ(path.advance(dt_s).finger.p_WQ.x(), 0.5);
}

TEST(PointerPath, KeepsTheEndOfAPressWhenItIsFull) {
  for (const int before : {500, 1019, 1020, 1021, 1022, 1023, 1024, 2000}) {
    PointerPath path(aim_at(0, 0));
    int event = 0;
    const auto put = [&](double push_n) {
      PointerAim aim = aim_at(1 + 1e-3 * ++event, 0);
      aim.finger.push_W_n = Vec3(0, 0, -push_n);
      path.put(aim);
    };
    for (int k = 0; k < before; ++k) put(0);
    for (int press = 0; press < 3; ++press) {
      for (int k = 0; k < 7; ++k) put(1);
      put(0);
    }
    for (int k = 0; k < 5000; ++k) path.advance(dt_s);
    EXPECT_EQ(path.advance(dt_s).finger.push_W_n, Vec3::Zero()) << before;
  }
}

TEST(PointerPath, DoesNotWaitForAClockThatHasLeapt) {
  PointerPath path(aim_at(0, 0));
  const double times_s[] = {1000, 0, 1000.016, 1000.024, 9000};
  for (int k = 0; k < 5; ++k) path.put(aim_at(times_s[k], 0.1 * k));
  int ticks = 0;
  while (path.advance(dt_s).finger.p_WQ.x() < 0.4 && ticks < 3000) ++ticks;
  EXPECT_LT(ticks, 200);
}

}  // namespace
}  // namespace fingerpad::pointer_path_test
