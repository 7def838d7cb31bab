// The help page in windows of all sizes.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "view/key_table.hpp"
#include "view/overlay.hpp"

namespace fingerpad::overlay_help_test {
namespace {

struct Words {
  std::string words;
  Box box;
};

/// The texts of the help page of a live touch in a window of this size, but for its head.
std::vector<Words> help_page(int width, int height) {
  OverlayFacts facts;
  facts.help = help_lines(windows::touch | windows::led);
  ViewState state;
  state.help = true;
  const Layout layout = layout_for(width, height, true, false);
  const Drawing drawing = overlay_drawing(facts, state, layout);
  std::vector<Words> page;
  for (const auto& mark : drawing.marks()) {
    const auto* const text = std::get_if<Drawing::Text>(&mark);
    if (text == nullptr || text->style.across != Across::left || text->words.empty()) continue;
    if (layout.title.holds(text->at.x(), text->at.y())) continue;
    const double size = text->style.size;
    page.push_back({text->words,
                    {text->at.x(), text->at.y() - 0.4 * size, text_width(text->words, size, text->style.bold),
                     0.8 * size}});
  }
  return page;
}

bool overlap(const Box& a, const Box& b) {
  return a.left < b.right() && b.left < a.right() && a.bottom < b.top() && b.bottom < a.top();
}

TEST(OverlayHelp, PrintsNothingOverOtherWordsAndNothingBesideTheWindow) {
  for (const auto& [width, height] :
       {std::pair(1280, 800), std::pair(640, 480), std::pair(400, 300), std::pair(200, 200)}) {
    SCOPED_TRACE(testing::Message() << width << " x " << height);
    const auto page = help_page(width, height);
    EXPECT_GT(page.size(), 10u);
    for (std::size_t i = 0; i < page.size(); ++i) {
      const Box& box = page[i].box;
      EXPECT_TRUE(box.left >= 0 && box.right() <= width && box.bottom >= 0 && box.top() <= height)
          << page[i].words;
      for (std::size_t k = 0; k < i; ++k)
        EXPECT_FALSE(overlap(box, page[k].box)) << page[i].words << " and " << page[k].words;
    }
  }
}

TEST(OverlayHelp, SaysHowMuchItLeavesOutOfASmallWindow) {
  const auto says_more = [](int width, int height) {
    const auto page = help_page(width, height);
    return std::ranges::any_of(page, [](const Words& of) { return of.words == "enlarge this"; });
  };
  EXPECT_TRUE(says_more(200, 200));
  EXPECT_FALSE(says_more(640, 480));
  EXPECT_FALSE(says_more(1280, 800));
}

// Words were cut there without a word of why.
TEST(OverlayHelp, SaysInItsHeadThatTheWindowIsTooSmall) {
  const auto has = [](int width, int height, const std::string& words) {
    OverlayFacts facts;
    facts.help = help_lines(windows::touch | windows::led);
    ViewState state;
    state.help = true;
    const Drawing drawing = overlay_drawing(facts, state, layout_for(width, height, true, false));
    return std::ranges::any_of(drawing.marks(), [&](const auto& mark) {
      const auto* const text = std::get_if<Drawing::Text>(&mark);
      return text != nullptr && text->words == words;
    });
  };
  EXPECT_TRUE(has(200, 200, "too small: enlarge it"));
  EXPECT_FALSE(has(200, 200, "keys and mouse"));
  EXPECT_TRUE(has(1280, 800, "keys and mouse"));
  // Elsewhere every line has room, but not all of its words.
  std::vector<std::string> whole;
  for (const std::string& line : help_lines(windows::touch | windows::led)) {
    const std::size_t colon = line.find(": ");
    whole.push_back(line.substr(0, colon));
    if (colon != std::string::npos) whole.push_back(line.substr(colon + 2));
  }
  for (const int width : {200, 300, 400, 500, 640, 800, 1280}) {
    for (const int height : {200, 300, 480, 600, 800}) {
      std::vector<std::string> told;
      for (const Words& of : help_page(width, height)) told.push_back(of.words);
      EXPECT_EQ(has(width, height, "keys and mouse"), told == whole) << width << " x " << height;
    }
  }
}

}  // namespace
}  // namespace fingerpad::overlay_help_test
