#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <variant>

#include "support/paths.hpp"
#include "support/shell.hpp"
#include "view/key_table.hpp"
#include "view/overlay.hpp"
#include "view/touch_chart.hpp"

namespace fingerpad::window_keys_test {
namespace {

constexpr unsigned by_mouse = windows::touch | windows::led, by_device = windows::touch | windows::watched;

TEST(KeyTable, NoKeyMeansTwoThingsInOneWindow) {
  for (const unsigned window :
       {windows::still, windows::trace, by_mouse, by_device, by_device | windows::motors}) {
    std::set<std::string_view> seen;
    for (const KeyRow& row : key_table()) {
      if ((row.in & window) == 0) continue;
      for (const BoundKey& key : row.keys) EXPECT_TRUE(seen.insert(key.symbol).second) << key.symbol;
    }
  }
}

TEST(KeyTable, TheHelpPageAndTheKeysAreItsRows) {
  EXPECT_EQ(action_of("space", windows::trace), KeyAction::play);
  EXPECT_EQ(action_of("space", by_mouse), KeyAction::press);
  EXPECT_EQ(action_of("space", windows::still), std::nullopt);
  EXPECT_EQ(action_of("x", by_mouse), std::nullopt) << "without motors there is nothing to stop";
  EXPECT_EQ(action_of("x", by_device | windows::motors), KeyAction::stop);
  EXPECT_EQ(action_of("X", by_device | windows::motors), KeyAction::give_back);
  const auto lines = help_lines(by_mouse);
  EXPECT_THAT(lines, testing::Contains("hold left button: press on the part; a click taps it"));
  EXPECT_THAT(lines, testing::Not(testing::Contains(testing::HasSubstr("emergency"))));
  for (const KeyRow& row : key_table()) EXPECT_FALSE(row.does.empty());
}

TEST(KeyTable, OfAWindowThatADeviceLeadsLeavesTheMouseToTheView) {
  for (const char* key : {"space", "Prior", "Next", "Left", "Right", "Up", "Down"}) {
    EXPECT_EQ(action_of(key, by_device), std::nullopt) << key;
    EXPECT_NE(action_of(key, by_mouse), std::nullopt) << key;
  }
  EXPECT_EQ(action_of("m", by_device), KeyAction::materials);
  const auto lines = help_lines(by_device);
  EXPECT_THAT(lines, testing::Contains("left drag: turn the view"));
  EXPECT_THAT(lines, testing::Each(testing::Not(testing::HasSubstr("press "))));
  EXPECT_THAT(lines, testing::Each(testing::Not(testing::HasSubstr("move the mouse"))));
}

std::vector<Drawing::Text> texts_of(const Drawing& drawing) {
  std::vector<Drawing::Text> texts;
  for (const Drawing::Mark& mark : drawing.marks()) {
    if (const auto* const text = std::get_if<Drawing::Text>(&mark)) texts.push_back(*text);
  }
  return texts;
}

TEST(HelpPage, IsReadWholeInTheSmallestWindowOfATouch) {
  ViewState state;
  state.help = true;
  OverlayFacts facts;
  facts.help = help_lines(by_mouse | windows::motors);
  for (const char* alarm : {"",
                            "STOPPED: no force until g, and the device, release it; no packet on "
                            "127.0.0.1:47110 (UDP) for 20 ms: finger lifted"}) {
    facts.alarm = alarm;
    for (const auto& [width, height] : {std::pair(1280, 800), std::pair(520, 340), std::pair(400, 300)}) {
      const Layout layout = layout_for(width, height, true, false);
      const std::vector<Drawing::Text> texts = texts_of(overlay_drawing(facts, state, layout));
      for (const Drawing::Text& text : texts) {
        EXPECT_THAT(text.words, testing::Not(testing::EndsWith("..."))) << width;
        EXPECT_TRUE(layout.window.holds(text.at.x(), text.at.y())) << text.words;
      }
      EXPECT_GT(texts.size(), 2 * facts.help.size());
    }
  }
}

TEST(HelpPage, TellsAMessageWholeBelowAnAlarm) {
  ViewState state;
  state.help = true;
  OverlayFacts facts;
  facts.help = help_lines(by_mouse | windows::motors);
  facts.invitation = "hold the left button, or space, to press";
  facts.message = "stiffness: 1250 N/m; motors shake over 990 N/m at 1000 Hz, and more than one line holds";
  facts.alarm = "STOPPED";
  for (const auto& [width, height] : {std::pair(1280, 800), std::pair(640, 480), std::pair(400, 300)}) {
    const Layout layout = layout_for(width, height, true, false);
    std::string told;
    for (const Drawing::Text& text : texts_of(overlay_drawing(facts, state, layout))) {
      EXPECT_NE(text.words, facts.invitation) << "which the page would lie over";
      if (text.words == facts.alarm) continue;
      const bool is_key = text.words.size() < 3;
      if (is_key || facts.message.find(text.words) == std::string::npos) continue;
      told += (told.empty() ? "" : " ") + text.words;
      EXPECT_LT(text.at.y() + 0.5 * layout.em, layout.window.top() - alarm_line(facts.alarm, layout).height)
          << width;
    }
    EXPECT_EQ(told, facts.message) << width;
  }
}

// Charts and readings lie beneath it.
TEST(HelpPage, LetsNothingShineThrough) {
  ViewState state;
  state.help = true;
  OverlayFacts facts;
  facts.help = help_lines(by_mouse);
  const Drawing page = overlay_drawing(facts, state, layout_for(1280, 800, true, false));
  const auto texts = texts_of(page);
  const auto title = std::find_if(texts.begin(), texts.end(),
                                  [](const Drawing::Text& text) { return text.words == "keys and mouse"; });
  ASSERT_NE(title, texts.end());
  const Drawing::Area* ground = nullptr;  // the one that the page's first and last words stand on
  for (const Drawing::Mark& mark : page.marks()) {
    const auto* const area = std::get_if<Drawing::Area>(&mark);
    if (area == nullptr || area->points.size() != 4) continue;
    const auto [low, high] = std::minmax_element(area->points.begin(), area->points.end(),
                                                 [](const Vec2& a, const Vec2& b) { return a.y() < b.y(); });
    if (low->y() < texts.back().at.y() && high->y() > title->at.y()) ground = area;
  }
  ASSERT_NE(ground, nullptr);
  EXPECT_EQ(ground->fill.opacity, 1);
}

TEST(Readings, CallTheSpeedOfAFreeFingerThatOfOneInTheAir) {
  OverlayFacts facts;
  const auto says = [&](const char* name) {
    const auto texts = texts_of(readings_drawing(facts, ViewState{}, layout_for(1280, 800, true, false)));
    return std::any_of(texts.begin(), texts.end(),
                       [&](const Drawing::Text& text) { return text.words == name; });
  };
  facts.hud = {0, 0, 200, 400};
  facts.row = TickRecord{};
  EXPECT_TRUE(says("speed in air"));
  EXPECT_FALSE(says("speed"));
  facts.row->phase = Phase::slip;
  EXPECT_TRUE(says("speed"));
  EXPECT_FALSE(says("speed in air"));
  EXPECT_EQ(live_chart(std::vector<TickRecord>(3), {}).panels[1].curves[0].name, "in touch, over 20 ms");
}

TEST(KeyTable, StandsInTheReadme) {
  const std::string readme = test::bytes_of(test::source_dir() / "README.md");
  EXPECT_NE(readme.find("\n" + key_table_text()), std::string::npos) << "put this there:\n"
                                                                     << key_table_text();
}

}  // namespace
}  // namespace fingerpad::window_keys_test
