#include <gtest/gtest.h>

#include <algorithm>
#include <variant>

#include "view/event_clock.hpp"
#include "view/png_vtk.hpp"
#include "view/rub.hpp"
#include "view/screen.hpp"
#include "view/stage_vtk.hpp"

namespace fingerpad::alarm_test {
namespace {

long red_pixels(const Pixels& pixels) {
  long count = 0;
  for (std::size_t i = 0; i + 2 < pixels.rgb.size(); i += 3)
    count += pixels.rgb[i] > 150 && pixels.rgb[i + 1] < 60 && pixels.rgb[i + 2] < 60 ? 1 : 0;
  return count;
}

TEST(Alarm, IsALineInRedAcrossTheScene) {
  const VirtualScreen screen;
  const ViewInput input = test::torus_rub(0.2);
  Stage stage(input, 900, 600, true, true);
  stage.show(input.rows.front(), 0);
  stage.render();
  const long before = red_pixels(pixels_of(stage.window()));
  stage.words().alarm = "NOT RECORDED any longer: run.h5: cannot be written: No space left on device";
  stage.render();
  const Box scene = stage.layout().scene;
  // Nearly two lines high, but for its letters.
  EXPECT_GT(red_pixels(pixels_of(stage.window())) - before, scene.width * stage.layout().em);
  stage.words().alarm.clear();
  stage.render();
  EXPECT_EQ(red_pixels(pixels_of(stage.window())), before);
}

TEST(Alarm, IsToldWholeInASmallWindowToo) {
  OverlayFacts facts;
  facts.alarm =
      "STOPPED: no force until g, and the device, release it; no packet on 127.0.0.1:47110 (UDP) for 20 ms: "
      "finger lifted";
  for (const auto& [width, height] : {std::pair(1280, 800), std::pair(640, 480), std::pair(400, 300)}) {
    const Layout layout = layout_for(width, height, true, false);
    const Box red = alarm_line(facts.alarm, layout);
    std::string told;
    const Drawing drawing = overlay_drawing(facts, {}, layout);
    for (const Drawing::Mark& mark : drawing.marks()) {
      const auto* const text = std::get_if<Drawing::Text>(&mark);
      if (text == nullptr || !red.holds(text->at.x(), text->at.y())) continue;
      told += (told.empty() ? "" : " ") + text->words;
      EXPECT_LE(text->at.x() + text_width(text->words, text->style.size, text->style.bold), red.right());
      EXPECT_GE(text->at.y() - 0.6 * text->style.size, red.bottom) << width;
    }
    EXPECT_EQ(told, facts.alarm) << width;
  }
}

TEST(Alarm, HasListsBelowIt) {
  const VirtualScreen screen;
  const ViewInput input = test::torus_rub(0.2);
  Stage stage(input, 640, 480, true, true);
  stage.panels().show({"material", "material", {{PanelRow::Kind::value, "mu static", "0.3"}}});
  const auto list = [&] { return stage.panels().boxes(stage.panel_layout()).front(); };
  const double top = list().top();
  stage.words().alarm = "NOT RECORDED any longer: run.h5: cannot be written: No space left on device";
  EXPECT_LT(list().top(), alarm_line(stage.words().alarm, stage.layout()).bottom);
  EXPECT_EQ(stage.pointed().panels.front().top(), list().top()) << "where the mouse finds it";
  stage.words().alarm.clear();
  EXPECT_EQ(list().top(), top);
}

TEST(EventClock, KeepsTheServersOwnSteps) {
  EventClock clock;
  EXPECT_EQ(clock.time_s(5000, 100), 100);
  EXPECT_NEAR(clock.time_s(5008, 100.1), 100.008, 1e-9) << "it waited for a slow frame";
  EXPECT_NEAR(clock.time_s(5900, 100.9), 100.9, 1e-9);
}

TEST(EventClock, TakesTheArrivalForATimeThatMakesNoSense) {
  EventClock clock;
  EXPECT_EQ(clock.time_s(5000, 100), 100);
  EXPECT_EQ(clock.time_s(0, 101), 101);
  EXPECT_EQ(clock.time_s(17, 101.1), 101.1) << "made up, or long ago";
  EXPECT_NEAR(clock.time_s(6200, 101.3), 101.2, 1e-9);
  EXPECT_EQ(clock.time_s(90'000, 102), 102) << "the server's clock has leapt ...";
  EXPECT_NEAR(clock.time_s(90'010, 102.05), 102.01, 1e-9) << "... and goes on from there";
}

TEST(EventClock, GoesRoundAfter49Days) {
  EventClock clock;
  EXPECT_EQ(clock.time_s(0xffffffffUL, 7), 7);
  EXPECT_NEAR(clock.time_s(9, 7.02), 7.01, 1e-9);
}

}  // namespace
}  // namespace fingerpad::alarm_test
