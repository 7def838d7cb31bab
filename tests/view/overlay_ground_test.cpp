#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <variant>

#include "view/overlay.hpp"
#include "view/overlay_room.hpp"
#include "view/overlay_words.hpp"
#include "view/rub.hpp"
#include "view/stage_words.hpp"

// What belongs to places of a scene, and what is said in the middle of it.

namespace fingerpad::overlay_ground_test {
namespace {

/// The smallest box that holds a shape's points.
Box around(const std::vector<Vec2>& points) {
  Vec2 low = points.front(), high = points.front();
  for (const Vec2& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  return {low.x(), low.y(), high.x() - low.x(), high.y() - low.y()};
}

/// What is painted behind a text, as the last area that holds all of it; none: nothing.
std::optional<Drawing::Area> plate_of(const Drawing& drawing, const std::string& words) {
  std::optional<Drawing::Area> plate;
  std::vector<Drawing::Area> before;
  for (const Drawing::Mark& mark : drawing.marks()) {
    if (const auto* const area = std::get_if<Drawing::Area>(&mark)) before.push_back(*area);
    const auto* const text = std::get_if<Drawing::Text>(&mark);
    if (text == nullptr || text->words != words) continue;
    const double half = text_width(words, text->style.size, text->style.bold) / 2;
    for (const Drawing::Area& area : before) {
      const Box box = around(area.points);
      if (box.holds(text->at.x() - half, text->at.y()) && box.holds(text->at.x() + half, text->at.y()))
        plate = area;
    }
  }
  return plate;
}

TEST(Axes, HaveTheirLettersOnPlates) {
  OverlayFacts facts;
  facts.axes_px << 0.9, -0.4, 0, 0, 0.3, 0.9, 0.4, 0.8, -0.4;
  const Drawing drawing = ground_drawing(facts, {}, layout_for(800, 600, false, false));
  for (const char* name : {"x", "y", "z"}) {
    const auto plate = plate_of(drawing, name);
    ASSERT_TRUE(plate) << name;
    EXPECT_GT(plate->fill.opacity, 0.8) << "grey letters on a grey part";
    EXPECT_EQ(plate->fill.red, 255);
  }
}

TEST(ScaleBar, HasItsLengthOnAPlate) {
  OverlayFacts facts;
  facts.px_per_mm = 5;
  const Drawing drawing = ground_drawing(facts, {}, layout_for(640, 480, false, false));
  const auto plate = plate_of(drawing, "10 mm");
  ASSERT_TRUE(plate);
  EXPECT_GT(plate->fill.opacity, 0.8) << "pale letters on a pale plane";
}

TEST(CloseUp, HasTheLengthOfItsScaleWithinItsFrame) {
  OverlayFacts facts;
  facts.row = TickRecord{};
  facts.row->phase = Phase::stick;
  facts.px_per_mm = 1;
  for (const auto& [width, height] : {std::pair(400, 300), std::pair(1280, 800)}) {
    const Layout layout = layout_for(width, height, true, true);
    facts.inset = layout.inset;
    for (facts.inset_px_per_mm = 2; facts.inset_px_per_mm < 500; facts.inset_px_per_mm *= 1.1) {
      const Drawing drawing = ground_drawing(facts, {}, layout);
      bool is_there = false;
      for (const Drawing::Mark& mark : drawing.marks()) {
        const auto* const text = std::get_if<Drawing::Text>(&mark);
        if (text == nullptr || !text->words.ends_with(" mm") ||
            !facts.inset.holds(text->at.x(), text->at.y()))
          continue;
        is_there = true;
        const double half = text_width(text->words, text->style.size, text->style.bold) / 2;
        EXPECT_LT(text->at.x() + half, facts.inset.right()) << width << ": " << text->words;
        EXPECT_GT(text->at.x() - half, facts.inset.left) << width << ": " << text->words;
      }
      EXPECT_TRUE(is_there) << width << ", " << facts.inset_px_per_mm;
    }
  }
}

TEST(CloseUp, HasAHeadThatFitsItsFrame) {
  OverlayFacts facts;
  facts.row = TickRecord{};
  facts.row->phase = Phase::stick;
  facts.row->walls = 2;
  facts.px_per_mm = 1;
  facts.inset_px_per_mm = 7.2;
  for (const auto& [width, height, head] :
       {std::tuple(400, 300, "2 walls, 7.2x"), std::tuple(1280, 800, "contact, 2 walls, 7.2x")}) {
    const Layout layout = layout_for(width, height, true, false);
    facts.inset = layout.inset;
    bool is_there = false;
    const Drawing drawing = ground_drawing(facts, {}, layout);
    for (const Drawing::Mark& mark : drawing.marks()) {
      const auto* const text = std::get_if<Drawing::Text>(&mark);
      if (text == nullptr || !text->words.ends_with("7.2x")) continue;
      is_there = true;
      EXPECT_EQ(text->words, head);
      EXPECT_LT(text_width(text->words, text->style.size, text->style.bold), facts.inset.width);
    }
    EXPECT_TRUE(is_there);
  }
}

TEST(CloseUp, LeavesOutWhichWayIsUpWhereItsScaleNeedsTheRoom) {
  OverlayFacts facts;
  facts.row = TickRecord{};
  facts.row->phase = Phase::stick;
  facts.px_per_mm = 1;
  facts.inset_px_per_mm = 17;
  for (const auto& [width, height, is_told] : {std::tuple(400, 300, false), std::tuple(1280, 800, true)}) {
    const Layout layout = layout_for(width, height, true, true);
    facts.inset = layout.inset;
    const Drawing drawing = ground_drawing(facts, {}, layout);
    const auto is_up = [](const Drawing::Mark& mark) {
      const auto* const text = std::get_if<Drawing::Text>(&mark);
      return text != nullptr && text->words == "up: finger";
    };
    EXPECT_EQ(std::ranges::any_of(drawing.marks(), is_up), is_told) << width;
  }
}

/// Where lists of a material and of parts stand in a small window.
std::vector<Box> lists_in(const Layout& layout) {
  const double em = layout.em, left = layout.scene.right() - 21.7 * em;
  return {{left, layout.scene.top() - 20.8 * em, 21 * em, 20.1 * em},
          {left, layout.scene.top() - 27.4 * em, 21 * em, 5.9 * em}};
}

TEST(Words, AreWholeAndLieOverNoListInTheSmallestWindow) {
  const std::string message = "stiffness: 1250 N/m; motors shake over 990 N/m at 1000 Hz";
  for (const auto& [width, height] : {std::pair(1280, 800), std::pair(600, 420), std::pair(400, 300)}) {
    const Layout layout = layout_for(width, height, true, false);
    OverlayFacts facts;
    facts.invitation = "hold the left button, or space, to press";
    facts.message = message;
    facts.panels = lists_in(layout);
    std::string told;
    const Drawing drawing = overlay_drawing(facts, {}, layout);
    for (const Drawing::Mark& mark : drawing.marks()) {
      const auto* const text = std::get_if<Drawing::Text>(&mark);
      if (text == nullptr) continue;
      told += text->words + " ";
      const double half = text_width(text->words, layout.em, true) / 2;
      for (const Box& list : facts.panels) {
        EXPECT_FALSE(list.holds(text->at.x() + half, text->at.y())) << width << ": " << text->words;
        EXPECT_FALSE(list.holds(text->at.x() - half, text->at.y())) << width << ": " << text->words;
      }
    }
    EXPECT_THAT(told, testing::AllOf(testing::HasSubstr(facts.invitation), testing::HasSubstr(message)))
        << width;
  }
}

TEST(Words, SayHowToFindAFingerThatIsOutOfSight) {
  const Layout layout = layout_for(1280, 800, true, false);
  OverlayFacts facts;
  const auto told = [&](const std::optional<Vec2>& finger_px, const std::string& invitation) {
    facts.finger_px = finger_px;
    facts.invitation = invitation;
    tell_lost_finger(facts, layout);
    return facts.invitation;
  };
  const std::string words = "the finger is out of sight: 0 shows all";
  EXPECT_EQ(told(std::nullopt, ""), "") << "nothing moves";
  EXPECT_EQ(told(layout.scene.centre(), ""), "");
  EXPECT_EQ(told(Vec2(-3, 400), ""), words);
  EXPECT_EQ(told(layout.charts.centre(), ""), words) << "behind the charts";
  EXPECT_EQ(told(Vec2(-3, 400), "hold the left button"), "hold the left button") << "which brings it there";
}

TEST(Subtitle, OfAThinnedTraceSaysWhyThereAreNoRings) {
  ViewInput input = test::torus_rub(0.1);
  const auto subtitle = [&] { return facts_to_tell(input, input, {}, std::nullopt).subtitle; };
  EXPECT_THAT(subtitle(), testing::Not(testing::HasSubstr("rings")));
  input.every = 10;
  EXPECT_THAT(subtitle(), testing::StartsWith("1 tick in 10: no rings where slip ended; "));
}

}  // namespace
}  // namespace fingerpad::overlay_ground_test
