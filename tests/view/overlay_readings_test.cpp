#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
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

/// The words of a legend; all within it.
std::vector<std::string> legend_of(const OverlayFacts& facts) {
  constexpr double em = 15;
  const ViewState state;
  const Vec2 size = legend_size(facts, state, em);
  Drawing drawing;
  paint_legend(drawing, facts, state, {0, 0, size.x(), size.y()}, em);
  std::vector<std::string> words;
  for (const Drawing::Mark& mark : drawing.marks())
    if (const auto* const text = std::get_if<Drawing::Text>(&mark)) {
      words.push_back(text->words);
      EXPECT_LE(text->at.x() + text_width(text->words, em), size.x()) << text->words;
      EXPECT_GT(text->at.y(), 0) << text->words;
    }
  return words;
}

TEST(OverlayLegend, SaysWhatTheLettersInTheSceneMeanWhereTheyStandThere) {
  OverlayFacts facts;
  facts.row = TickRecord{};
  facts.row->phase = Phase::slip;
  using ::testing::Contains;
  EXPECT_THAT(legend_of(facts), Contains("n, Cx, Cy: normal, tangents"));
  facts.row->phase = Phase::free;
  EXPECT_THAT(legend_of(facts), ::testing::Not(Contains("n, Cx, Cy: normal, tangents")));
}

TEST(OverlayLegend, OfSeveralWallsSaysOnWhichTheStickCentreStands) {
  OverlayFacts facts;
  facts.row = TickRecord{};
  facts.row->phase = Phase::stick;
  facts.row->walls = 2;
  facts.row->triangle = 1234567;
  facts.row->stick_centre_W = Vec3::Zero();
  facts.surface_name = "bracket_fi.....stl";
  using ::testing::Contains;
  using ::testing::HasSubstr;
  EXPECT_THAT(legend_of(facts), Contains("on the deepest of 2 walls: bracket_fi.....stl, triangle 1234567"));
  facts.row->triangle = -1;
  EXPECT_THAT(legend_of(facts), Contains("on the deepest of 2 walls: bracket_fi.....stl"));
  facts.row->walls = 1;
  const std::vector<std::string> alone = legend_of(facts);
  EXPECT_THAT(alone, Contains("stick centre"));
  EXPECT_THAT(alone, testing::Not(Contains(HasSubstr("walls"))));
}

}  // namespace
}  // namespace fingerpad::overlay_readings_test
