#include <gtest/gtest.h>

#include "view/rub.hpp"
#include "view/screen.hpp"
#include "view/touch_window.hpp"

namespace fingerpad::help_page_test {
namespace {

using Kind = WindowEvent::Kind;

/// What a touch's window of 600 x 400 did with its mouse: the help page is opened, the button is pressed at
/// a place, dragged and let go, and then held on the part.
struct Played {
  std::vector<FingerSample> targets;
  std::vector<WindowReport> reports;

  Played(int x, int y) {
    const VirtualScreen screen;
    TouchWindowInput input;
    input.view = test::torus_rub(0.0);
    input.view.rows.clear();
    input.latest = [] { return TickRecord(); };
    input.recent = [](double) { return std::vector<TickRecord>(); };
    input.set_target = [this](const FingerSample& target) { targets.push_back(target); };
    WindowOptions options;
    options.width = 600;
    options.height = 400;
    options.events = {{0.1, Kind::key, "h"},
                      {0.6, Kind::move, "", x, y},
                      {0.7, Kind::wheel_up, "", x, y},
                      {0.8, Kind::press, "", x, y},
                      {1.0, Kind::move, "", x + 20, y + 5},
                      {1.2, Kind::release, "", x + 20, y + 5},
                      {pressed_again_s, Kind::press, "", 189, 90},  // the near side of the ring
                      {2.2, Kind::key, "q"}};
    options.on_frame = [this](const WindowReport& report) { reports.push_back(report); };
    run_touch_window(input, options);
  }
  static constexpr double pressed_again_s = 1.7;
};

// Else a press on the page goes through it, onto the part that it hides, and into the recording.
TEST(HelpPage, IsClosedByAPressThatNeitherTouchesNorTurnsTheView) {
  for (const auto& [x, y] : {std::pair(189, 90), std::pair(20, 60)}) {
    const Played played(x, y);
    ASSERT_FALSE(played.reports.empty());
    const WindowReport& first = played.reports.front();
    bool opened = false, closed = false;
    for (const WindowReport& report : played.reports) {
      opened |= report.state.help;
      closed |= opened && !report.state.help;
      EXPECT_EQ(report.towards_eye_W, first.towards_eye_W) << x << ": " << report.since_open_s;
      if (report.since_open_s > Played::pressed_again_s) continue;
      EXPECT_FALSE(report.pressing) << x << ": " << report.since_open_s;
      EXPECT_EQ(report.press_n, first.press_n) << x << ": " << report.since_open_s;
    }
    EXPECT_TRUE(opened && closed) << x;
    EXPECT_TRUE(played.reports.back().pressing) << "the next press touches";
    // The one press that was told, and nothing of what went before.
    ASSERT_EQ(played.targets.size(), 1u) << x;
    EXPECT_GT(played.targets.front().push_W_n.norm(), 0);
  }
}

}  // namespace
}  // namespace fingerpad::help_page_test
