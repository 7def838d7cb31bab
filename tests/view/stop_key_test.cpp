#include <gtest/gtest.h>

#include <set>
#include <string>

#include "view/rub.hpp"
#include "view/screen.hpp"
#include "view/touch_window.hpp"

namespace fingerpad::stop_key_test {
namespace {

using Kind = WindowEvent::Kind;

/// What the keys of the emergency stop did in a window where x, x, g and x are typed.
std::vector<bool> stops_heard(bool has_motors, bool pointer_leads, std::set<std::string>& alarms) {
  const VirtualScreen screen;
  TouchWindowInput input;
  input.view = test::torus_rub(0.0);
  input.view.rows.clear();
  input.set_target = [](const FingerSample&) {};
  input.latest = [] { return TickRecord{}; };
  input.recent = [](double) { return std::vector<TickRecord>{}; };
  std::vector<bool> stops;
  input.pointer_leads = pointer_leads;
  if (has_motors) {
    input.set_stop = [&](bool on) { stops.push_back(on); };
    input.is_stopped = [&] { return !stops.empty() && stops.back(); };
  }
  WindowOptions options;
  options.width = 600;
  options.height = 400;
  options.events = {{0.1, Kind::key, "x"},
                    {0.2, Kind::key, "x"},
                    {0.3, Kind::key, "g"},
                    {0.4, Kind::key, "x"},
                    {0.6, Kind::key, "q"}};
  options.on_frame = [&](const WindowReport& report) { alarms.insert(report.alarm); };
  run_touch_window(input, options);
  return stops;
}

TEST(StopKey, AlwaysStopsAndAnotherKeyGivesTheForceBackWhateverLeadsTheFinger) {
  const std::set<std::string> in_red = {"", "STOPPED: no force until g, and the device, release it"};
  for (const bool pointer_leads : {true, false}) {
    std::set<std::string> alarms;
    EXPECT_EQ(stops_heard(true, pointer_leads, alarms), (std::vector<bool>{true, true, false, true}));
    EXPECT_EQ(alarms, in_red) << pointer_leads;
  }
  std::set<std::string> alarms;
  EXPECT_TRUE(stops_heard(false, true, alarms).empty()) << "a device without motors has nothing to stop";
  EXPECT_EQ(alarms, std::set<std::string>{""});
}

/// A window of a touch that is over after so many frames, and is not closed by hand.
TEST(TouchWindowEnd, ComesWithTheTouchs) {
  const VirtualScreen screen;
  TouchWindowInput input;
  input.view = test::torus_rub(0.0);
  input.view.rows.clear();
  input.set_target = [](const FingerSample&) {};
  input.latest = [] { return TickRecord{}; };
  input.recent = [](double) { return std::vector<TickRecord>{}; };
  int asked = 0;
  input.is_over = [&] { return ++asked >= 5; };
  WindowOptions options;
  options.width = 300;
  options.height = 200;
  options.events = {{20, Kind::key, "q"}};
  run_touch_window(input, options);
  EXPECT_EQ(asked, 5);
}

}  // namespace
}  // namespace fingerpad::stop_key_test
