#include <gtest/gtest.h>

#include "view/rub.hpp"
#include "view/screen.hpp"
#include "view/touch_window.hpp"

namespace fingerpad::stop_key_test {
namespace {

using Kind = WindowEvent::Kind;

/// How often the key of the emergency stop was heard in a window where x is typed twice.
int stops_heard(bool has_motors) {
  const VirtualScreen screen;
  TouchWindowInput input;
  input.view = test::torus_rub(0.0);
  input.view.rows.clear();
  input.set_target = [](const FingerSample&) {};
  input.latest = [] { return TickRecord{}; };
  input.recent = [](double) { return std::vector<TickRecord>{}; };
  int stops = 0;
  if (has_motors) {
    input.toggle_stop = [&] { ++stops; };
    input.is_stopped = [&] { return stops % 2 == 1; };
  }
  WindowOptions options;
  options.width = 600;
  options.height = 400;
  options.events = {
      {0.1, Kind::key, "x"}, {0.15, Kind::key, "x"}, {0.2, Kind::key, "X"}, {0.4, Kind::key, "q"}};
  run_touch_window(input, options);
  return stops;
}

TEST(StopKey, OfTheWindowReachesADeviceWithMotorsAlone) {
  EXPECT_EQ(stops_heard(true), 2);
  EXPECT_EQ(stops_heard(false), 0);
}

}  // namespace
}  // namespace fingerpad::stop_key_test
