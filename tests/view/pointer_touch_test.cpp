// The pointer of a live touch: what it means, and that it waits for no frame. The second with a mouse and
// keys that X itself moves (xdotool); skipped where no X server can be started.
#include "view/pointer_touch.hpp"

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <condition_variable>

#include "base/error.hpp"
#include "support/shell.hpp"
#include "support/worlds.hpp"
#include "view/rub.hpp"
#include "view/screen.hpp"

namespace fingerpad::pointer_touch_test {
namespace {

using Kind = InputEvent::Kind;

/// A pointer over a floor at z = 0, seen from above: a pixel is a millimetre; to the right of x = 100 there
/// is nothing, and a panel hides a corner.
struct OverFloor {
  std::vector<FingerSample> told;
  std::vector<bool> stops;
  TouchWindowInput input;
  PointerTouch pointer;

  OverFloor()
      : pointer(input, TouchTarget(test::plane_world(), Scene{}, 0.002, FingerSample{}),
                [](const Vec3& from_mm, const Vec3& to_mm) -> std::optional<SurfaceHit> {
                  EXPECT_LT(to_mm.z(), from_mm.z());
                  if (from_mm.x() > 100) return std::nullopt;
                  return SurfaceHit{Vec3(1e-3 * from_mm.x(), 1e-3 * from_mm.y(), 0), Vec3::UnitZ(), 0, 0.5};
                }) {
    input.set_target = [this](const FingerSample& target) { told.push_back(target); };
    input.set_stop = [this](bool on) { stops.push_back(on); };
    PointedScene shown;
    shown.scene = {0, 0, 200, 200};
    shown.panels = {{0, 150, 50, 50}};
    shown.lines = {Vec3(0, 0, 10), Vec3(0, 0, -10), Vec3::UnitX(), Vec3::UnitY()};
    pointer.show(shown, 0);
  }
  bool take(Kind kind, double x, double y, double t_s) { return pointer.take({kind, x, y, "", t_s}); }
  bool key(const char* name, double t_s) { return pointer.take({Kind::key, 0, 0, name, t_s}); }
};

TEST(PointerTouch, HoversPressesAndLiftsWhereNothingIsUnderIt) {
  OverFloor over;
  EXPECT_FALSE(over.take(Kind::move, 150, 20, 0.5)) << "nothing there: the camera's";
  EXPECT_TRUE(over.told.empty());
  EXPECT_TRUE(over.take(Kind::move, 20, 30, 1));
  ASSERT_EQ(over.told.size(), 1u);
  EXPECT_LT((over.told[0].p_WQ - Vec3(0.02, 0.03, 0.002)).norm(), 1e-12);
  EXPECT_EQ(over.told[0].push_W_n, Vec3(Vec3::Zero()));
  EXPECT_FALSE(over.pointer.has_pressed());
  EXPECT_TRUE(over.take(Kind::press, 20, 30, 2));
  EXPECT_LT((over.told.back().push_W_n - Vec3(0, 0, -1)).norm(), 1e-12);
  EXPECT_TRUE(over.take(Kind::move, 150, 30, 3)) << "held";
  EXPECT_FALSE(over.pointer.pressing());
  EXPECT_TRUE(over.take(Kind::move, 90, 30, 4));
  EXPECT_TRUE(over.pointer.pressing());
  EXPECT_TRUE(over.take(Kind::release, 90, 30, 5));
  EXPECT_FALSE(over.pointer.pressing());
  EXPECT_TRUE(over.pointer.has_pressed());
  EXPECT_EQ(over.told.back().t_s, 5);
}

// A window that grows tells where the pointer is in it before it has drawn a frame of that size; there is no
// other event while the pointer rests.
TEST(PointerTouch, AHeldFingerPressesOnInAWindowThatIsMadeLargerAgain) {
  OverFloor over;
  PointedScene large{{0, 0, 200, 200}, {}, {Vec3(0, 0, 10), Vec3(0, 0, -10), {0.5, 0, 0}, {0, 0.5, 0}}};
  const PointedScene small{{0, 0, 60, 60}, {}, {Vec3(0, 0, 10), Vec3(0, 0, -10), {2, 0, 0}, {0, 2, 0}}};
  over.pointer.show(large, 2.5);
  EXPECT_TRUE(over.take(Kind::press, 120, 30, 1));
  over.pointer.show(small, 2.5);
  EXPECT_TRUE(over.pointer.pressing()) << "no event, no change";
  EXPECT_TRUE(over.take(Kind::move, 120, 40, 2));
  EXPECT_FALSE(over.pointer.pressing()) << "beside the small window";
  over.pointer.show(small, 2.5);
  EXPECT_FALSE(over.pointer.pressing());
  large.panels = {{100, 0, 100, 100}};  // which takes no pointer that was pressed beside it
  over.pointer.show(large, 2.5);
  EXPECT_TRUE(over.pointer.pressing());
  EXPECT_LT((over.told.back().p_WQ - Vec3(0.06, 0.02, 0)).norm(), 1e-12);
  EXPECT_EQ(over.told.back().t_s, 2.5);
  EXPECT_TRUE(over.take(Kind::release, 120, 40, 3));
  over.pointer.show(small, 2.5);
  over.pointer.show(large, 2.5);
  EXPECT_FALSE(over.pointer.pressing()) << "let go";
}

/// The floor moved aside under a pointer that rests, as a key turns the view.
struct TurnedFloor : OverFloor {
  double frame_s = 100;
  void look_from_x(double x_mm) {
    frame_s += 1;
    pointer.show({{0, 0, 200, 200},
                  {{0, 150, 50, 50}},
                  {Vec3(x_mm, 0, 10), Vec3(x_mm, 0, -10), Vec3::UnitX(), Vec3::UnitY()}},
                 frame_s);
  }
  double finger_x_m() const { return told.back().p_WQ.x(); }
};

// The finger stayed where it was until the mouse moved.
TEST(PointerTouch, AHoveringFingerStaysUnderThePointerWhereTheViewTurns) {
  TurnedFloor over;
  over.look_from_x(10);
  EXPECT_TRUE(over.told.empty()) << "there was no pointer yet";
  over.take(Kind::move, 20, 30, 1);
  EXPECT_NEAR(over.finger_x_m(), 0.03, 1e-12);
  over.look_from_x(40);
  EXPECT_NEAR(over.finger_x_m(), 0.06, 1e-12);
  EXPECT_EQ(over.told.back().t_s, over.frame_s) << "no leap in no time";
  const std::size_t told = over.told.size();
  over.look_from_x(40);
  EXPECT_EQ(over.told.size(), told) << "no other view";
  over.take(Kind::move, 20, 160, 200);
  over.look_from_x(10);
  EXPECT_NEAR(over.finger_x_m(), 0.06, 1e-12) << "on a panel";
}

TEST(PointerTouch, AFingerThatPressesStaysWhereTheViewTurnsUntilItIsLetGo) {
  TurnedFloor latched;
  latched.take(Kind::move, 20, 30, 1);
  latched.key("space", 2);
  latched.look_from_x(40);
  EXPECT_NEAR(latched.finger_x_m(), 0.02, 1e-12);
  latched.key("space", 200);
  latched.look_from_x(40);
  EXPECT_NEAR(latched.finger_x_m(), 0.06, 1e-12) << "with the next frame";
  EXPECT_FALSE(latched.pointer.pressing());
  TurnedFloor held;
  held.take(Kind::press, 20, 30, 1);
  held.look_from_x(40);
  EXPECT_NEAR(held.finger_x_m(), 0.02, 1e-12);
  EXPECT_TRUE(held.pointer.pressing());
  held.take(Kind::release, 20, 30, 200);
  held.look_from_x(40);
  EXPECT_NEAR(held.finger_x_m(), 0.06, 1e-12);
}

TEST(PointerTouch, AFingerThatThePointerDoesNotLeadStaysWhereTheViewTurns) {
  TurnedFloor by_keys;
  by_keys.take(Kind::move, 20, 30, 1);
  by_keys.key("Right", 2);
  const double led_m = by_keys.finger_x_m();
  by_keys.look_from_x(40);
  EXPECT_EQ(by_keys.finger_x_m(), led_m);
  TurnedFloor by_panel;
  by_panel.take(Kind::move, 20, 30, 1);
  by_panel.take(Kind::press, 20, 160, 2);
  by_panel.take(Kind::move, 20, 30, 3);
  by_panel.look_from_x(40);
  EXPECT_NEAR(by_panel.finger_x_m(), 0.02, 1e-12) << "the button is the panel's";
  TurnedFloor by_view;
  by_view.take(Kind::move, 20, 30, 1);
  by_view.take(Kind::press, 150, 30, 2);
  by_view.take(Kind::move, 60, 30, 3);
  by_view.look_from_x(10);
  EXPECT_NEAR(by_view.finger_x_m(), 0.02, 1e-12) << "the button turns the view";
  by_view.take(Kind::release, 60, 30, 200);
  by_view.look_from_x(10);
  EXPECT_NEAR(by_view.finger_x_m(), 0.07, 1e-12);
}

TEST(PointerTouch, AButtonPressedBesideThePartIsTheViewsUntilItIsLetGo) {
  OverFloor over;
  EXPECT_FALSE(over.take(Kind::press, 150, 30, 1));
  EXPECT_TRUE(over.pointer.turns_view());
  EXPECT_FALSE(over.take(Kind::move, 90, 30, 2)) << "over the part it goes on to turn the view";
  EXPECT_TRUE(over.pointer.turns_view());
  EXPECT_FALSE(over.pointer.pressing());
  EXPECT_FALSE(over.take(Kind::release, 90, 30, 3));
  EXPECT_FALSE(over.pointer.turns_view());
  EXPECT_TRUE(over.take(Kind::press, 90, 30, 4));
  EXPECT_FALSE(over.pointer.turns_view());
  EXPECT_TRUE(over.pointer.pressing());
  OverFloor beside;
  EXPECT_FALSE(beside.take(Kind::press, 20, 160, 1)) << "on a panel";
  EXPECT_FALSE(beside.pointer.turns_view());
}

TEST(PointerTouch, APanelKeepsWhatIsPressedOnItAndNotWhatWasPressedBesideIt) {
  OverFloor over;
  EXPECT_FALSE(over.take(Kind::press, 20, 160, 1));
  EXPECT_FALSE(over.take(Kind::move, 20, 30, 2)) << "dragged off the panel, it stays the panel's";
  EXPECT_FALSE(over.take(Kind::release, 20, 30, 3));
  EXPECT_TRUE(over.told.empty());
  EXPECT_TRUE(over.take(Kind::press, 20, 30, 4));
  EXPECT_TRUE(over.take(Kind::move, 20, 160, 5));
  EXPECT_TRUE(over.pointer.pressing());
}

TEST(PointerTouch, KeysLatchStopAndMoveAndTimesNeverGoBack) {
  OverFloor over;
  over.take(Kind::move, 20, 30, 7);
  EXPECT_TRUE(over.key("space", 6.5)) << "late";
  EXPECT_EQ(over.told.back().t_s, 7);
  EXPECT_TRUE(over.pointer.pressing());
  EXPECT_TRUE(over.key("Right", 8));
  EXPECT_GT(over.told.back().p_WQ.x(), 0.0201);
  EXPECT_TRUE(over.key("x", 9));
  EXPECT_TRUE(over.key("g", 9));
  EXPECT_EQ(over.stops, (std::vector<bool>{true, false}));
  EXPECT_FALSE(over.key("h", 10)) << "the window's own";
  over.pointer.change_force(1, 11);
  EXPECT_NEAR(over.told.back().push_W_n.norm(), 1.25, 1e-12);
}

TEST(PointerTouch, OfAFingerThatADeviceLeadsIsTheViews) {
  OverFloor over;
  over.input.pointer_leads = false;
  EXPECT_FALSE(over.take(Kind::move, 20, 30, 1));
  EXPECT_FALSE(over.take(Kind::press, 20, 30, 2));
  EXPECT_FALSE(over.key("space", 3));
  EXPECT_FALSE(over.pointer.has_pressed());
  EXPECT_TRUE(over.told.empty());
  EXPECT_TRUE(over.key("x", 4)) << "it is stopped all the same";
}

/// How the calling thread stands with the system.
struct Standing {
  int nice = -1;
  cpu_set_t cores{};

  static Standing now() {
    Standing standing;
    standing.nice = getpriority(PRIO_PROCESS, static_cast<id_t>(gettid()));
    CPU_ZERO(&standing.cores);
    sched_getaffinity(0, sizeof(standing.cores), &standing.cores);
    return standing;
  }
};

/// A window that is held up in a frame until what a person does meanwhile was heard of.
struct HeldUpWindow {
  std::mutex mutex;
  std::condition_variable changed;
  bool pressing = false, stopped = false;
  std::vector<double> pressed_at_s;
  Standing heard_by, drawn_by;

  template <typename Is>
  bool wait(const Is& is) {
    std::unique_lock lock(mutex);
    return changed.wait_for(lock, std::chrono::seconds(30), is);
  }
};

/// A touch of a ring in the air.
TouchWindowInput over_ring() {
  TouchWindowInput input;
  input.view = test::torus_rub(0.0);
  input.view.rows.clear();
  input.latest = [] { return TickRecord(); };
  input.recent = [](double) { return std::vector<TickRecord>(); };
  return input;
}

WindowOptions small_window() {
  WindowOptions options;
  options.width = 600;
  options.height = 400;
  return options;
}

/// None where the machine has none; why not is in `why_none`.
std::unique_ptr<VirtualScreen> virtual_screen(std::string& why_none) {
  try {
    return std::make_unique<VirtualScreen>();
  } catch (const Error& error) {
    why_none = error.what();
    return nullptr;
  }
}

TEST(PointerTouch, IsAnsweredWhileTheWindowIsHeldUpByAFrame) {
  std::string why_none;
  const auto screen = virtual_screen(why_none);
  if (!screen) GTEST_SKIP() << why_none;
  HeldUpWindow held;
  TouchWindowInput input = over_ring();
  input.set_target = [&](const FingerSample& target) {
    const std::lock_guard lock(held.mutex);
    held.pressing = target.push_W_n != Vec3::Zero();
    held.heard_by = Standing::now();
    if (held.pressing) held.pressed_at_s.push_back(target.t_s);
    held.changed.notify_all();
  };
  input.set_stop = [&](bool on) {
    const std::lock_guard lock(held.mutex);
    held.stopped = on;
    held.changed.notify_all();
  };
  WindowOptions options = small_window();
  int heard = 0;
  options.on_frame = [&](const WindowReport& report) {
    if (report.frames < 2 || heard > 0) return;
    held.drawn_by = Standing::now();
    const std::string hand = "export DISPLAY=" + screen->display() + "; xdotool ";
    // From the upper left corner, as X counts; the near side of the ring.
    test::shell(hand + "mousemove 185 310 mousedown 1 mousemove 187 310", ".");
    heard += held.wait([&] { return held.pressing && held.pressed_at_s.size() > 1; }) ? 1 : 0;
    test::shell(hand + "key x", ".");
    heard += held.wait([&] { return held.stopped; }) ? 1 : 0;
    test::shell(hand + "mouseup 1", ".");
    heard += held.wait([&] { return !held.pressing; }) ? 1 : 0;
    test::shell(hand + "key q", ".");
  };
  const Standing usual = Standing::now();
  run_touch_window(input, options);
  EXPECT_EQ(held.heard_by.nice, usual.nice) << "who hears of a press does not stand back";
  EXPECT_TRUE(CPU_EQUAL(&held.heard_by.cores, &usual.cores));
  EXPECT_GE(held.drawn_by.nice, 10) << "who draws does";
  cpu_set_t left;
  CPU_XOR(&left, &usual.cores, &held.drawn_by.cores);
  EXPECT_EQ(CPU_COUNT(&left), CPU_COUNT(&usual.cores) > 1 ? 1 : 0)
      << "and leaves a core, where there are more";
  EXPECT_EQ(heard, 3) << "pressed, stopped and let go, all within one frame";
}

// VTK asks X for hints: of moves that follow one another X told the first alone until the next frame looked
// where the pointer was, and the finger stayed where it had been then, as long as the pointer rested.
TEST(PointerTouch, HearsOfTheLastMoveThoughNoFrameIsDrawnAfterTheFirst) {
  std::string why_none;
  const auto screen = virtual_screen(why_none);
  if (!screen) GTEST_SKIP() << why_none;
  HeldUpWindow held;
  std::vector<Vec3> places_W;
  TouchWindowInput input = over_ring();
  input.set_target = [&](const FingerSample& target) {
    const std::lock_guard lock(held.mutex);
    if (places_W.empty() || places_W.back() != target.p_WQ) places_W.push_back(target.p_WQ);
    held.changed.notify_all();
  };
  WindowOptions options = small_window();
  bool heard_all = false, is_done = false;
  options.on_frame = [&](const WindowReport& report) {
    if (report.frames < 2 || is_done) return;
    const std::string hand = "export DISPLAY=" + screen->display() + "; xdotool ";
    test::shell(hand + "mousemove 185 310 sleep .01 mousemove 187 310 sleep .01 mousemove 189 310", ".");
    heard_all = held.wait([&] { return places_W.size() >= 3; });
    is_done = true;
    test::shell(hand + "key q", ".");
  };
  run_touch_window(input, options);
  EXPECT_TRUE(heard_all) << "of three moves " << places_W.size() << " are told";
}

}  // namespace
}  // namespace fingerpad::pointer_touch_test
