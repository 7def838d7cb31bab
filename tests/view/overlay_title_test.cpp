// What a window's title line has room for.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "view/overlay.hpp"
#include "view/overlay_words.hpp"

namespace fingerpad::overlay_title_test {
namespace {

/// Whether these words stand in the title line, whole.
bool is_told(const OverlayFacts& facts, const std::string& words) {
  const Drawing drawing = overlay_drawing(facts, ViewState{}, layout_for(1280, 800, true, false));
  return std::ranges::any_of(drawing.marks(), [&](const auto& mark) {
    const auto* const text = std::get_if<Drawing::Text>(&mark);
    return text != nullptr && text->words == words;
  });
}

// With a doubt and held charts it was cut before the recording, while what describes the scene stood whole.
TEST(OverlayTitle, TellsAllOfTheHintBeforeWhatDescribesTheScene) {
  OverlayFacts facts;
  facts.title = "bracket";
  facts.subtitle = "bracket_fine.stl, finger-pad, mu 0.3/0.2, proxy smooth";
  facts.hint = "press 1.00 N (pressing)   h help";
  EXPECT_TRUE(is_told(facts, facts.hint));
  EXPECT_TRUE(is_told(facts, facts.subtitle));
  facts.hint =
      "press 1.00 N (pressing)   the finger is too large for what is under the pointer   charts held: r lets "
      "them run on   h help   recording /tmp/run.csv";
  EXPECT_TRUE(is_told(facts, facts.hint));
  EXPECT_TRUE(is_told(facts, facts.title));
  EXPECT_FALSE(is_told(facts, facts.subtitle));
  facts.title = std::string(300, 'x');
  EXPECT_FALSE(is_told(facts, facts.title)) << "a name does not take all of it";
  EXPECT_FALSE(is_told(facts, ""));
}

}  // namespace
}  // namespace fingerpad::overlay_title_test
