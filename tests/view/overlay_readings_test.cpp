#include <gtest/gtest.h>

#include <vector>

#include "view/overlay.hpp"
#include "view/overlay_hud.hpp"

namespace fingerpad::overlay_readings_test {
namespace {

TEST(OverlayReadings, NoneRunsIntoItsNameAndTheWallsHaveARow) {
  TickRecord row;
  row.phase = Phase::slip;
  row.normal_force_n = 12.345;
  row.walls = 3;
  OverlayFacts facts;
  facts.row = row;
  facts.surface_name = "bracket_fine.stl";
  constexpr double em = 15;
  const Vec2 size = readings_size(facts, em);
  Drawing drawing;
  paint_readings(drawing, facts, {0, 0, size.x(), size.y()}, em);
  std::vector<Drawing::Text> texts;
  for (const Drawing::Mark& mark : drawing.marks())
    if (const auto* const text = std::get_if<Drawing::Text>(&mark)) texts.push_back(*text);
  bool tells_walls = false;
  ASSERT_EQ(texts.size() % 2, 0u);
  for (std::size_t i = 0; i < texts.size(); i += 2) {
    const Drawing::Text &name = texts[i], &value = texts[i + 1];
    ASSERT_EQ(name.at.y(), value.at.y());
    EXPECT_LT(name.at.x() + text_width(name.words, em),
              value.at.x() - text_width(value.words, em, value.style.bold))
        << name.words;
    tells_walls = tells_walls || (name.words == "walls" && value.words == "3");
  }
  EXPECT_TRUE(tells_walls);
}

}  // namespace
}  // namespace fingerpad::overlay_readings_test
