#include "view/window.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "view/layout.hpp"
#include "view/overlay.hpp"
#include "view/rub.hpp"
#include "view/screen.hpp"

namespace fingerpad::test {
namespace {

using Kind = WindowEvent::Kind;

/// Plays events at a window of 600 x 400 and closes it with q `end_s` after its opening. Every report is
/// kept.
std::vector<WindowReport> play(const ViewInput& input, std::vector<WindowEvent> events, double end_s) {
  const VirtualScreen screen;
  std::vector<WindowReport> reports;
  WindowOptions options;
  options.width = 600;
  options.height = 400;
  events.push_back({end_s, Kind::key, "q"});
  options.events = std::move(events);
  options.on_frame = [&](const WindowReport& report) { reports.push_back(report); };
  run_view_window(input, options);
  return reports;
}

TEST(Window, OpensAndClosesByKey) {
  const auto start = std::chrono::steady_clock::now();
  const auto reports = play(torus_rub(0.2), {}, 0.3);
  ASSERT_FALSE(reports.empty());
  EXPECT_GE(reports.back().frames, 1);
  EXPECT_EQ(reports.back().t_s, 0);
  // Half a minute is far beyond opening it on any machine: it closed by itself.
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
}

TEST(Window, PlaysAndPauses) {
  const auto reports = play(torus_rub(60), {{0.1, Kind::key, "space"}, {1.1, Kind::key, "space"}}, 1.6);
  ASSERT_FALSE(reports.empty());
  double played_s = 0;
  bool played = false;
  for (const WindowReport& report : reports) {
    played |= report.state.playing;
    played_s = std::max(played_s, report.t_s);
  }
  EXPECT_TRUE(played);
  EXPECT_FALSE(reports.back().state.playing);
  // At the clock's pace for one second; events wait for a frame, which may take long without a graphics card.
  EXPECT_GT(played_s, 0.3);
  EXPECT_LT(played_s, 10);
}

TEST(Window, TheTimeLineMovesTime) {
  const ViewInput input = torus_rub(1.0);
  const Box slider = time_slider(layout_for(600, 400, true, true));
  const int y = static_cast<int>(slider.centre().y());
  const auto x_at = [&](double share) { return static_cast<int>(slider.left + share * slider.width); };
  const auto reports = play(input,
                            {{0.1, Kind::press, "", x_at(0.25), y},
                             {0.2, Kind::move, "", x_at(0.75), y},
                             {0.3, Kind::release, "", x_at(0.75), y},
                             {0.4, Kind::move, "", x_at(0.1), y}},
                            0.8);
  ASSERT_FALSE(reports.empty());
  // A pixel of the slider is a few milliseconds.
  EXPECT_NEAR(reports.back().t_s, 0.75 * input.rows.back().t_s, 0.01);
}

TEST(Window, KeysStepAndToggle) {
  const ViewInput input = torus_rub(0.2);
  const auto reports = play(input,
                            {{0.05, Kind::key, "Right"},
                             {0.05, Kind::key, "Right"},
                             {0.05, Kind::key, "Left"},
                             {0.1, Kind::key, "h"},
                             {0.1, Kind::key, "c"},
                             {0.1, Kind::key, "f"},
                             {0.1, Kind::key, "r"},
                             {0.1, Kind::wheel_up, "", 200, 200},
                             {0.1, Kind::key, "no such key"}},
                            0.4);
  ASSERT_FALSE(reports.empty());
  const WindowReport& last = reports.back();
  EXPECT_NEAR(last.t_s, input.rows[1].t_s, 1e-12);
  EXPECT_TRUE(last.state.help);
  EXPECT_FALSE(last.state.finger);
  EXPECT_EQ(last.state.colouring, PathColouring::force);
}

TEST(Window, EscapeClosesTheHelpFirst) {
  const auto reports = play(
      torus_rub(0.1), {{0.05, Kind::key, "h"}, {0.2, Kind::key, "Escape"}, {0.5, Kind::key, "Escape"}}, 20);
  ASSERT_FALSE(reports.empty());
  EXPECT_FALSE(reports.back().state.help);
  EXPECT_LT(reports.back().since_open_s, 15);  // not by the q at 20 s
}

TEST(Window, GoesOnWhileTheViewIsTurned) {
  const auto reports = play(torus_rub(60),
                            {{0.1, Kind::key, "space"},
                             {0.2, Kind::press, "", 150, 200},
                             {0.3, Kind::move, "", 190, 220}},  // held to the end
                            1.2);
  ASSERT_FALSE(reports.empty());
  EXPECT_GT(reports.back().t_s, 0.2);  // playing went on, and q was heard
}

TEST(Window, ShowsAMeshAlone) {
  ViewInput mesh = torus_rub(0.1);
  mesh.rows.clear();
  const auto reports = play(mesh, {{0.05, Kind::key, "space"}, {0.1, Kind::press, "", 300, 5}}, 0.3);
  ASSERT_FALSE(reports.empty());
  EXPECT_FALSE(reports.back().state.playing);
}

/// In the middle of the lowest chart of the window that play opens.
std::pair<int, int> on_chart(double share) {
  const Layout layout = layout_for(600, 400, true, true);
  const Box& charts = layout.charts;
  return {static_cast<int>(charts.left + share * charts.width),
          static_cast<int>(charts.bottom + 0.17 * charts.height)};
}

TEST(Window, WheelZoomsTheChartsAndADragMovesThemAlong) {
  const auto [x, y] = on_chart(0.6);
  const ViewInput input = torus_rub(1);
  const double whole_s = input.rows.back().t_s - input.rows.front().t_s;
  const auto reports = play(input,
                            {{0.1, Kind::wheel_up, "", x, y},
                             {0.1, Kind::wheel_up, "", x, y},
                             {0.1, Kind::wheel_up, "", x, y},
                             {0.3, Kind::press, "", x, y},
                             {0.3, Kind::move, "", x - 30, y},
                             {0.3, Kind::release, "", x - 30, y},
                             {0.6, Kind::key, "r"}},
                            0.9);
  ASSERT_FALSE(reports.empty());
  double least_s = 10, earliest_s = 10, latest_s = 0;
  for (const WindowReport& report : reports) {
    const double span_s = report.chart_to - report.chart_from;
    least_s = std::min(least_s, span_s);
    if (span_s > 0.6 * whole_s) continue;
    earliest_s = std::min(earliest_s, report.chart_from);
    latest_s = std::max(latest_s, report.chart_from);
  }
  EXPECT_NEAR(least_s, whole_s / std::pow(1.25, 3), 1e-6);
  EXPECT_GT(latest_s, earliest_s + 0.01) << "dragged to the left: later times come into sight";
  EXPECT_NEAR(reports.back().chart_to - reports.back().chart_from, whole_s, 1e-9) << "r shows all";
}

TEST(Window, MouseOverACurveTellsItsValue) {
  const ViewInput input = torus_rub(1);
  const Layout layout = layout_for(600, 400, true, true);
  std::vector<WindowEvent> events;
  // Somewhere on this way up through the lowest panel it meets the coefficient of friction.
  for (int i = 0; i < 60; ++i) {
    events.push_back({0.1 + 0.02 * i, Kind::move, "", on_chart(0.6).first,
                      static_cast<int>(layout.charts.bottom) + 20 + 2 * i});
  }
  bool told = false;
  for (const WindowReport& report : play(input, std::move(events), 1.6)) {
    told |= report.chart_tells.find("mu: ") == 0 && report.chart_tells.find(" at ") != std::string::npos;
  }
  EXPECT_TRUE(told);
}

}  // namespace
}  // namespace fingerpad::test
