#include "view/touch_window.hpp"

#include <gtest/gtest.h>

#include "device/pointer_finger.hpp"
#include "touch/resting_finger.hpp"
#include "touch/servo_loop.hpp"
#include "view/layout.hpp"
#include "view/rub.hpp"
#include "view/screen.hpp"
#include "view/touch_target.hpp"

namespace fingerpad::test {
namespace {

using Kind = WindowEvent::Kind;

double distance_to_torus_m(const Vec3& p) {
  return std::hypot(std::hypot(p.x(), p.y()) - 0.05, p.z()) - 0.02;
}

/// A live touch of the torus by the true tick, and what its window reported.
struct LiveTouch {
  ViewInput view = torus_rub(0.0);
  std::vector<WindowReport> reports;
  std::vector<TickRecord> latest;  ///< one a report
  ServoLoop::Timing timing;

  void play(std::vector<WindowEvent> events, double end_s) {
    const VirtualScreen screen;
    view.rows.clear();
    constexpr double rate_hz = 500;
    Scene scene = *view.scene;
    scene.motion.rate_hz = rate_hz;
    PointerFinger finger({scene, view.world, resting_finger(*view.world, scene)});
    ServoLoop servo(
        Touch(view.world, scene), rate_hz,
        [&](double t_s) {
          FingerSample sample = finger.advance(1 / rate_hz);
          sample.t_s = t_s;
          return sample;
        },
        [&](const TickRecord& record) { finger.feel(record); });
    TouchWindowInput input;
    input.view = view;
    input.set_target = [&](const FingerSample& target) { finger.set_target(target); };
    input.look_from = [&](const Vec3& towards_eye_W) { finger.look_from(towards_eye_W); };
    input.latest = [&] { return servo.latest(); };
    input.recent = [&](double seconds) { return servo.recent(seconds); };
    WindowOptions options;
    options.width = 600;
    options.height = 400;
    events.push_back({end_s, Kind::key, "q"});
    options.events = std::move(events);
    options.on_frame = [&](const WindowReport& report) {
      reports.push_back(report);
      latest.push_back(servo.latest());
    };
    run_touch_window(input, options);
    servo.stop();
    timing = servo.timing();
  }
};

// The near side of the torus's ring, in a window of 600 x 400.
constexpr int ring_x = 189, ring_y = 90;

TEST(TouchWindow, TheFingerHoversUnderTheMouseAndPressesWhileTheButtonIsHeld) {
  LiveTouch touch;
  touch.play({{0.1, Kind::move, "", ring_x, ring_y},
              {0.8, Kind::press, "", ring_x, ring_y},
              {2.4, Kind::release, "", ring_x, ring_y}},
             3.6);
  ASSERT_FALSE(touch.reports.empty());
  double hovered_m = 0, pressed_m = 0, most_n = 0;
  for (std::size_t i = 0; i < touch.reports.size(); ++i) {
    const WindowReport& report = touch.reports[i];
    const double distance_m = distance_to_torus_m(report.target_W);
    if (report.since_open_s > 0.3 && !report.pressing) hovered_m = distance_m;
    if (report.pressing) pressed_m = distance_m;
    most_n = std::max(most_n, touch.latest[i].normal_force_n);
  }
  // Facets of a 64 x 32 torus lie up to 0.2 mm inside it; 1 N at 1000 N/m is 1 mm deep.
  EXPECT_NEAR(pressed_m, -1e-3, 3e-4);
  EXPECT_GT(hovered_m, 1e-3);
  EXPECT_NEAR(most_n, 1.0, 0.3);
  EXPECT_FALSE(touch.reports.back().pressing);
  EXPECT_EQ(touch.latest.back().phase, Phase::free);
  EXPECT_GT(touch.reports.back().t_s, 1.0);  // the window kept up with the servo's time
}

// In the middle of the ring the eye's line meets nothing: a finger that does not fit through rests on it.
TEST(TouchWindow, APressOverAHoleThatIsTooNarrowLandsOnItsRim) {
  const Layout layout = layout_for(600, 400, true, false);
  const int x = static_cast<int>(layout.scene.centre().x()), y = static_cast<int>(layout.scene.centre().y());
  for (const double radius_m : {0.035, 0.007}) {
    SCOPED_TRACE(radius_m);
    LiveTouch touch;
    touch.view.scene->finger.radius_m = radius_m;
    touch.play({{0.1, Kind::move, "", ring_x, ring_y},
                {0.4, Kind::move, "", x, y},
                {1.0, Kind::press, "", x, y},
                {1.5, Kind::move, "", x + 2, y}},
               3);
    ASSERT_FALSE(touch.reports.empty());
    const bool is_too_narrow = radius_m > 0.03;
    EXPECT_EQ(touch.reports.back().pressing, is_too_narrow);
    EXPECT_EQ(touch.latest.back().walls > 0, is_too_narrow);
    const Vec3 before = touch.reports.front().towards_eye_W, after = touch.reports.back().towards_eye_W;
    EXPECT_EQ(before == after, is_too_narrow) << "else the button is the view's";
    if (is_too_narrow) {
      EXPECT_NEAR(touch.latest.back().normal_force_n, 1, 0.2);
    }
  }
}

TEST(TouchWindow, FeelsThePointerThatItOpensUnder) {
  const auto target_after = [](std::vector<WindowEvent> events) {
    LiveTouch touch;
    touch.play(std::move(events), 0.5);
    return touch.reports.empty() ? Vec3(Vec3::Zero()) : touch.reports.back().target_W;
  };
  const Vec3 pointed = target_after({{0.1, Kind::move, "", ring_x, ring_y}});
  // The eye's line is reckoned between planes that clip what is drawn, with the finger wherever it is by
  // then.
  constexpr double rounding_m = 1e-6;
  EXPECT_LT((target_after({{0.1, Kind::enter, "", ring_x, ring_y}}) - pointed).norm(), rounding_m);
  EXPECT_GT((target_after({}) - pointed).norm(), 0.01);
}

TEST(TouchWindow, SaysThatMarksAreGoneWhereThereWereAny) {
  const auto message_after = [](int first_x, int first_y) {
    LiveTouch touch;
    touch.play({{0.1, Kind::move, "", first_x, first_y},
                {0.2, Kind::key, "k"},
                {0.3, Kind::move, "", 5, 30},
                {0.4, Kind::key, "k"}},
               0.6);
    return touch.reports.empty() ? "" : touch.reports.back().message;
  };
  EXPECT_EQ(message_after(ring_x, ring_y), "no part under the mouse: marks are gone");
  EXPECT_EQ(message_after(5, 30), "no part under the mouse");
}

TEST(TouchWindow, WheelAndKeysChangeTheForceAndSpaceHolds) {
  LiveTouch touch;
  touch.play({{0.1, Kind::move, "", ring_x, ring_y},
              {0.2, Kind::key, "space"},
              {0.3, Kind::wheel_up, "", ring_x, ring_y},
              {0.3, Kind::key, "Prior"},
              {0.3, Kind::wheel_down, "", ring_x, ring_y}},
             0.8);
  ASSERT_FALSE(touch.reports.empty());
  EXPECT_TRUE(touch.reports.back().pressing);
  EXPECT_NEAR(touch.reports.back().press_n, 1.25, 1e-9);
}

TEST(TouchWindow, AHeldFingerLiftsWhereThePointerLeavesThePartAndLandsWhereItIsBack) {
  LiveTouch touch;
  touch.play({{0.1, Kind::move, "", ring_x, ring_y},
              {0.5, Kind::press, "", ring_x, ring_y},
              {1.5, Kind::move, "", 5, 30},
              {2.3, Kind::move, "", ring_x, ring_y}},
             3.2);
  ASSERT_FALSE(touch.reports.empty());
  bool pressed = false, lifted = false;
  for (std::size_t i = 0; i < touch.reports.size(); ++i) {
    const bool presses = touch.reports[i].pressing, touches = touch.latest[i].phase != Phase::free;
    if (presses && touches) pressed = true;
    if (pressed && !presses && !touches) lifted = true;
  }
  EXPECT_TRUE(pressed);
  EXPECT_TRUE(lifted);
  EXPECT_TRUE(touch.reports.back().pressing) << "the button is held still";
}

TEST(TouchWindow, DrawingDoesNotHoldTheServoUp) {
  LiveTouch touch;
  touch.play({}, 1.5);
  const double open_s = touch.reports.back().since_open_s;
  // Every tick happened: at 500 Hz over the time that the window was open, but for a tenth for starting.
  EXPECT_GT(static_cast<double>(touch.timing.ticks), 0.9 * 500 * open_s);
}

TEST(TouchWindow, ItsRunningChartsZoomMoveAlongAndTellValues) {
  const Layout layout = layout_for(600, 400, true, false);
  const int x = static_cast<int>(layout.charts.left + 0.75 * layout.charts.width);
  const int low_y = static_cast<int>(layout.charts.bottom + 0.17 * layout.charts.height);
  std::vector<WindowEvent> events = {
      {0, Kind::move, "", ring_x, ring_y},  {0.3, Kind::key, "space"},
      {1.0, Kind::wheel_up, "", x, low_y},  {1.0, Kind::wheel_up, "", x, low_y},
      {1.0, Kind::wheel_up, "", x, low_y},  {1.2, Kind::press, "", x, low_y},
      {1.2, Kind::move, "", x + 40, low_y}, {1.2, Kind::release, "", x + 40, low_y}};
  // Somewhere on this way up through a panel it meets a curve; there it stays.
  for (int i = 0; i < 40; ++i) events.push_back({1.4 + 0.03 * i, Kind::move, "", x, low_y - 30 + 3 * i});
  LiveTouch touch;
  touch.play(events, 2.8);
  double least_s = 1;  // of all
  bool told = false, moved = false;
  double from_before = -1;
  for (const WindowReport& report : touch.reports) {
    const double span_s = report.chart_to - report.chart_from;
    least_s = std::min(least_s, span_s / report.t_s);
    told |= !report.chart_tells.empty();
    if (span_s > 0.8 * report.t_s) continue;
    moved |= report.chart_from < from_before - 0.01;
    from_before = report.chart_from;
  }
  EXPECT_LT(least_s, 0.7) << "three steps of the wheel";
  EXPECT_TRUE(moved) << "dragged to the right: earlier times come into sight";
  EXPECT_TRUE(told);
  EXPECT_EQ(touch.reports.back().press_n, 1) << "the wheel was not the force's";
}

/// A touch of which two seconds go by whenever somebody asks for the newest tick.
struct HastyTouch {
  double now_s = 0;
  TickRecord row_at(double t_s) const {
    TickRecord row;
    row.t_s = t_s;
    row.p_WQ = Vec3(0.01 * std::sin(t_s), 0, 0.1);
    return row;
  }
  TouchWindowInput input() {
    TouchWindowInput input;
    input.view = torus_rub(0.0);
    input.view.rows.clear();
    input.set_target = [](const FingerSample&) {};
    input.latest = [this] { return row_at(now_s += 2); };
    input.recent = [this](double seconds) {
      std::vector<TickRecord> rows;
      for (double t_s = now_s - seconds; t_s <= now_s; t_s += 0.01) rows.push_back(row_at(t_s));
      return rows;
    };
    return input;
  }
};

TEST(TouchWindow, ChartsThatAreZoomedIntoAreHeldHoweverOldTheyGet) {
  const VirtualScreen screen;
  const Layout layout = layout_for(600, 400, true, false);
  const int x = static_cast<int>(layout.charts.left + 0.7 * layout.charts.width);
  const int y = static_cast<int>(layout.charts.bottom + 0.17 * layout.charts.height);
  HastyTouch touch;
  const TouchWindowInput input = touch.input();
  WindowOptions options;
  options.width = 600;
  options.height = 400;
  std::vector<WindowReport> held, after;
  bool asked = false;
  double zoomed_at_s = 0;
  options.events = {{0.5, Kind::wheel_up, "", x, y}, {0.5, Kind::wheel_up, "", x, y}};
  options.events.push_back({2.5, Kind::key, "r"});
  options.events.push_back({3.0, Kind::key, "q"});
  options.on_frame = [&](const WindowReport& report) {
    const double span_s = report.chart_to - report.chart_from;
    if (!asked && span_s > 0 && span_s < 3.5 && report.since_open_s >= 0.5) {
      asked = true;
      zoomed_at_s = touch.now_s;
    }
    if (asked) (report.since_open_s < 2.5 ? held : after).push_back(report);
  };
  run_touch_window(input, options);
  ASSERT_TRUE(asked);
  ASSERT_FALSE(held.empty() || after.empty());
  ASSERT_GT(held.back().t_s - zoomed_at_s, 4) << "longer than the charts are";
  EXPECT_EQ(held.back().chart_from, held.front().chart_from);
  EXPECT_EQ(held.back().chart_to, held.front().chart_to);
  EXPECT_GT(after.back().chart_to, held.back().chart_to) << "let go, they run on";
}

TEST(TouchTarget, ArrowKeysKeepTheFingerOnTheSurface) {
  const ViewInput view = torus_rub(0.0);
  TouchTarget target(view.world, *view.scene, 0.002, FingerSample{});
  target.point_at({0.05, 0, 0.02}, Vec3::UnitZ(), 0);
  target.press(true);
  for (int i = 0; i < 40; ++i) target.move_by({0.001, 0, 0}, Vec3::UnitZ(), Vec3::Zero());
  EXPECT_GT(target.sample().p_WQ.x(), 0.06);  // over the bend and on
  EXPECT_LT(target.sample().p_WQ.z(), 0.015);
  EXPECT_NEAR(target.sample().push_W_n.norm(), 1, 1e-12);
  // 1 mm deep, and the facets' own error of up to 0.2 mm.
  EXPECT_NEAR(distance_to_torus_m(target.pressed_W()), -1e-3, 3e-4);
  EXPECT_NEAR(distance_to_torus_m(target.sample().p_WQ), 0, 3e-4);
}

TEST(TouchTarget, ForceStaysWithinReasonAndTheScenesGreatest) {
  const ViewInput view = torus_rub(0.0);
  struct Case {
    double greatest_n, at_first_n, most_n, least_n;
  };
  for (const Case& one :
       {Case{100, 1, 20, 0.05}, {10, 1, 10, 0.05}, {0.5, 0.5, 0.5, 0.05}, {0.02, 0.02, 0.02, 0.02}}) {
    Scene scene = *view.scene;
    scene.contact.greatest_force_n = one.greatest_n;
    TouchTarget target(view.world, scene, 0.002, FingerSample{});
    EXPECT_EQ(target.press_n(), one.at_first_n);
    target.change_force(1000);
    EXPECT_EQ(target.press_n(), one.most_n);
    target.change_force(-1000);
    EXPECT_EQ(target.press_n(), one.least_n);
  }
}

}  // namespace
}  // namespace fingerpad::test
