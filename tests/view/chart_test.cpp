#include "view/chart.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "view/axis.hpp"
#include "view/svg.hpp"

namespace fingerpad::test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr Box page{0, 0, 400, 300};

CurveStyle blue_line(Dash dash = Dash::solid) {
  return {palette::blue, dash, Marker::none, 1};
}

ChartPanel panel_of(ChartCurve curve, bool logarithmic = false) {
  return {"", "t", "y", false, logarithmic, {std::move(curve)}};
}

Chart stacked(std::vector<ChartPanel> panels) {
  Chart chart;
  chart.stacked = true;
  chart.panels = std::move(panels);
  return chart;
}

std::vector<Vec2> all_points(const Drawing& drawing) {
  std::vector<Vec2> points;
  for (const auto& mark : drawing.marks()) {
    if (const auto* line = std::get_if<Drawing::Line>(&mark)) {
      points.insert(points.end(), line->points.begin(), line->points.end());
    }
  }
  return points;
}

TEST(Axis, MarksAreRoundNumbersWithinIt) {
  const Axis axis = linear_axis(-0.013, 0.044, 5);
  EXPECT_EQ(axis.labels, (std::vector<std::string>{"0", "0.02", "0.04"}));
  EXPECT_DOUBLE_EQ(axis.share(-0.013), 0);
  EXPECT_DOUBLE_EQ(axis.share(0.044), 1);
}

TEST(Axis, NeverHoldsMoreMarksThanFit) {
  for (double span = 1e-6; span < 1e7; span *= 1.37) {
    for (const int most : {2, 5, 9}) {
      const Axis axis = linear_axis(0.3 * span, 1.3 * span, most);
      EXPECT_LE(axis.marks.size(), static_cast<std::size_t>(most) + 1) << span;
      EXPECT_GE(axis.marks.size(), 2u) << span << ": a single number tells no scale";
    }
  }
}

TEST(Axis, HasAMarkAtZeroWhereThatIsWithinHoweverFewMarksFit) {
  // Friction of a rub to one side and back, in a low panel.
  EXPECT_EQ(linear_axis(-0.47, 0.23, 1).labels, (std::vector<std::string>{"-0.4", "0"}));
  EXPECT_EQ(linear_axis(-0.23, 0.47, 1).labels, (std::vector<std::string>{"0", "0.4"}));
  for (double low = -0.95; low < -0.02; low += 0.031) {
    for (const int most : {1, 2, 5}) {
      const Axis axis = linear_axis(low, low + 1, most);
      EXPECT_THAT(axis.labels, testing::Contains("0")) << low << ", at most " << most;
      EXPECT_GE(axis.marks.size(), 2u) << low;
    }
  }
}

TEST(Axis, HasMarksOnBothSidesOfZeroWhereTheyFit) {
  // Friction of a rub to and fro, in a strip: a half is too coarse, and steps of a fifth make three marks.
  EXPECT_EQ(linear_axis(1710170000, 1710170001, 3).labels,
            (std::vector<std::string>{"1710170000.0", "1710170000.5", "1710170001.0"}));
  EXPECT_EQ(linear_axis(250000, 250002, 2).labels, (std::vector<std::string>{"250000", "250001", "250002"}));
  EXPECT_EQ(linear_axis(-0.34, 0.33, 3).labels, (std::vector<std::string>{"-0.2", "0", "0.2"}));
  EXPECT_EQ(linear_axis(-0.34, 0.33, 2).labels, (std::vector<std::string>{"0", "0.2"}));
}

TEST(Axis, OfOneValueHasAWidth) {
  const Axis axis = linear_axis(2, 2, 4);
  EXPECT_LT(axis.min, 2);
  EXPECT_GT(axis.max, 2);
}

TEST(Axis, DecadesCoverTheValues) {
  const Axis axis = decade_axis(3e-7, 0.2, 4);
  EXPECT_DOUBLE_EQ(axis.min, 1e-7);
  EXPECT_DOUBLE_EQ(axis.max, 1);
  EXPECT_LE(axis.marks.size(), 5u);
}

TEST(Chart, LeavesMarksOutOfALegendThatIsTooNarrowBeforeLevels) {
  const auto legend_in = [](double width) {
    ChartPanel panel = panel_of({"mu", blue_line(), {0, 1}, {0, 1}});
    panel.curves.push_back({"end of slip", {palette::vermillion, Dash::none, Marker::ring, 1}, {0}, {0}});
    panel.levels = {{"mu_s", 0.3}, {"mu_d", 0.2}};
    Drawing drawing;
    draw_chart(drawing, stacked({panel}), {0, 0, width, 200}, 10);
    std::vector<std::string> names;
    for (const auto& mark : drawing.marks()) {
      const auto* const text = std::get_if<Drawing::Text>(&mark);
      if (text != nullptr && (text->words.starts_with("mu") || text->words.starts_with("end")))
        names.push_back(text->words);
    }
    return names;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(legend_in(400), (Names{"mu", "end of slip", "mu_s", "mu_d"}));
  const Names narrow = legend_in(190);
  ASSERT_GE(narrow.size(), 3u);
  EXPECT_EQ(Names(narrow.begin(), narrow.begin() + 3), (Names{"mu", "mu_s", "mu_d"}));
}

TEST(Chart, KeepsPeaksOfCurvesWithManyPoints) {
  ChartCurve curve{"c", blue_line(), {}, {}};
  for (int i = 0; i < 100'000; ++i) {
    curve.x.push_back(i);
    curve.y.push_back(i == 54'321 ? 10 : 0.5 * std::sin(i * 0.1));
  }
  Drawing drawing;
  const ChartPlace place = draw_chart(drawing, stacked({panel_of(curve)}), page, 10);
  ASSERT_EQ(place.panels.size(), 1u);
  const Box& panel = place.panels[0];
  double highest = 0;
  std::size_t points = 0;
  for (const auto& mark : drawing.marks()) {
    const auto* line = std::get_if<Drawing::Line>(&mark);
    if (line == nullptr || line->points.size() < 100) continue;
    points += line->points.size();
    for (const Vec2& p : line->points) highest = std::max(highest, p.y());
  }
  EXPECT_GT(highest, panel.bottom + 0.9 * panel.height);
  EXPECT_LT(points, 4 * 400u + 8);  // four a column of the page
}

TEST(Chart, LeavesGapsWhereValuesAreNone) {
  const ChartCurve curve{"", blue_line(), {0, 1, 2, 3, 4, 5}, {0, 1, nan, nan, 1, 0}};
  Drawing drawing;
  draw_chart(drawing, stacked({panel_of(curve)}), page, 10);
  int runs = 0;
  for (const auto& mark : drawing.marks()) {
    const auto* line = std::get_if<Drawing::Line>(&mark);
    runs += line != nullptr && line->stroke.colour.blue == colours::blue.blue ? 1 : 0;
  }
  EXPECT_EQ(runs, 2);
}

TEST(Chart, StaysOnItsPageWhateverTheValues) {
  Chart chart = stacked({});
  const double huge = 1e300;
  for (const std::vector<double>& y :
       {std::vector<double>{nan, nan, nan}, {0, 0, 0}, {-huge, huge, 0}, {HUGE_VAL, 1, -HUGE_VAL}, {}}) {
    const ChartCurve curve{"curve", blue_line(Dash::dotted), {0, 1, 2}, y};
    chart.panels.push_back(panel_of(curve));
    chart.panels.push_back(panel_of(curve, true));
  }
  Drawing drawing;
  draw_chart(drawing, chart, {0, 0, 400, 2000}, 10);
  for (const Vec2& p : all_points(drawing)) {
    ASSERT_TRUE(p.allFinite());
    EXPECT_TRUE(p.x() >= 0 && p.x() <= 400.1 && p.y() >= 0 && p.y() <= 2000) << p.transpose();
  }
}

/// What the legend above a panel of so many curves says.
std::vector<std::string> legend_of_curves(int count, int rows = 1) {
  ChartPanel panel;
  for (int i = 0; i < count; ++i) {
    const std::string name =
        "law stick-slip, place " + std::to_string(i) + ", handle.stl: RMS 0.0" + std::to_string(i);
    panel.curves.push_back({name, blue_line(), {0, 1}, {0, 1}});
  }
  Drawing drawing;
  Chart chart = stacked({panel});
  chart.legend_rows = rows;
  draw_chart(drawing, chart, {0, 0, 600, 300}, 10);
  std::vector<std::string> words;
  for (const auto& mark : drawing.marks()) {
    const auto* const text = std::get_if<Drawing::Text>(&mark);
    if (text != nullptr && (text->words.starts_with("law") || text->words.ends_with(" more")))
      words.push_back(text->words);
  }
  return words;
}

TEST(Chart, NamesEachCurveThoughShortenedAndCountsThoseForWhichThereIsNoRoom) {
  EXPECT_THAT(legend_of_curves(1), testing::ElementsAre("law stick-slip, place 0, handle.stl: RMS 0.00"));
  const auto five = legend_of_curves(5);
  ASSERT_EQ(five.size(), 5u);
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(five[i].ends_with(std::to_string(i))) << five[i];
  const auto forty = legend_of_curves(40);
  ASSERT_GT(forty.size(), 3u);
  EXPECT_EQ(forty.back(), "and " + std::to_string(41 - forty.size()) + " more");
}

TEST(Chart, GoesOnInFurtherLinesWhereALegendMayHaveThem) {
  const auto eight = legend_of_curves(8, 4);
  ASSERT_EQ(eight.size(), 8u);
  for (int i = 0; i < 8; ++i) {
    const std::string number = std::to_string(i);
    EXPECT_EQ(eight[i], "law stick-slip, place " + number + ", handle.stl: RMS 0.0" + number) << "whole";
  }
  EXPECT_EQ(legend_of_curves(12, 4).size(), 12u) << "cut, but each there";
}

TEST(Chart, GivesFurtherLinesOfALegendTheirRoomAboveTheFrame) {
  const auto frame_top = [](int count, int rows) {
    ChartPanel panel;
    for (int i = 0; i < count; ++i)
      panel.curves.push_back(
          {"a curve with a name of its own, " + std::to_string(i), blue_line(), {0, 1}, {0, 1}});
    Chart chart = stacked({panel});
    chart.legend_rows = rows;
    return stacked_layout(chart, {0, 0, 600, 300}, 10).panels[0].frame.top();
  };
  EXPECT_LT(frame_top(8, 4), frame_top(8, 1) - 2 * legend_line_ems * 10);
  EXPECT_EQ(frame_top(1, 4), frame_top(1, 1)) << "one line is enough";
}

TEST(Chart, PutsItsPanelsEvenlyApartWhateverLinesTheirLegendsHave) {
  Chart chart = stacked({});
  chart.legend_rows = 8;
  for (const int count : {12, 1, 8}) {
    ChartPanel panel;
    for (int i = 0; i < count; ++i)
      panel.curves.push_back(
          {"a curve with a name of its own, " + std::to_string(i), blue_line(), {0, 1}, {0, 1}});
    chart.panels.push_back(panel);
  }
  const ChartLayout layout = stacked_layout(chart, {0, 0, 600, 900}, 10);
  ASSERT_EQ(layout.panels.size(), 3u);
  for (std::size_t i = 0; i + 1 < 3; ++i) {
    const Box &above = layout.panels[i].frame, &below = layout.panels[i + 1].frame;
    EXPECT_NEAR(above.bottom - below.top(), layout.gutter_y, 1e-9) << "as VTK puts them";
    EXPECT_EQ(above.height, below.height);
    EXPECT_GT(above.bottom - below.top(), legend_line_ems * 10 * layout.panels[i + 1].legend_rows);
  }
  EXPECT_GT(layout.panels[0].legend_rows, layout.panels[2].legend_rows);
  EXPECT_GT(layout.panels[2].legend_rows, 1);
  EXPECT_GE(layout.panels[2].frame.bottom, 0);
  EXPECT_EQ(further_legend_lines_px(chart, 600, 10),
            legend_line_ems * 10 * (layout.panels[0].legend_rows + 2 * layout.panels[2].legend_rows - 3));
}

TEST(Chart, PlacesTimeBothWays) {
  const ChartCurve curve{"", blue_line(), {2, 3, 6}, {0, 1, 2}};
  Drawing drawing;
  const ChartPlace place = draw_chart(drawing, stacked({panel_of(curve)}), page, 10);
  EXPECT_NEAR(place.x_at(place.drawing_x_at(3.7)), 3.7, 1e-9);
  EXPECT_EQ(place.x_at(-1000), 2);
  EXPECT_EQ(place.x_at(1000), 6);
}

TEST(Svg, TurnsTheUprightAxis) {
  Drawing drawing;
  drawing.line({{0, 0}, {10, 30}}, {colours::black, 1});
  const std::string page_text = svg_page(drawing, 100, 50, "t");
  EXPECT_NE(page_text.find("0.0,50.0 10.0,20.0"), std::string::npos);
}

TEST(Svg, LeavesOutPointsThatNobodySeesAndKeepsPeaks) {
  std::vector<Vec2> points;
  for (int i = 0; i <= 1000; ++i) points.emplace_back(0.1 * i, i == 400 ? 30 : 10 + 0.05 * (i % 2));
  Drawing drawing;
  drawing.line(points, {colours::black, 1});
  const std::string page_text = svg_page(drawing, 100, 50, "t");
  EXPECT_NE(page_text.find("40.0,20.0"), std::string::npos) << "the peak";
  EXPECT_LT(page_text.size(), 600u) << "a thousand points take 10 kB";
}

TEST(Chart, DrawsRingsOnlyWhereThereIsAValue) {
  const CurveStyle rings_alone{palette::blue, Dash::none, Marker::ring, 1};
  const ChartCurve curve{"", rings_alone, {0, 1, 2, 3}, {nan, 1, nan, 2}};
  Drawing drawing;
  draw_chart(drawing, stacked({panel_of(curve)}), page, 10);
  const auto rings = std::count_if(drawing.marks().begin(), drawing.marks().end(), [](const auto& mark) {
    const auto* line = std::get_if<Drawing::Line>(&mark);
    return line != nullptr && line->points.size() > 8 && line->points.front() == line->points.back();
  });
  EXPECT_EQ(rings, 2);
}

TEST(Axis, LogarithmicOneHasMinorMarksBetweenItsMarks) {
  const Axis axis = log_axis(0.5, 2000, 5);
  EXPECT_EQ(axis.labels, (std::vector<std::string>{"1", "10", "100", "1000"}));
  EXPECT_EQ(axis.minor_marks.size(), 5u + 8 + 8 + 8 + 1);  // 0.5 to 0.9, 2 to 9 of three decades, 2000
  EXPECT_EQ(log_axis(1, 9, 9).labels, (std::vector<std::string>{"1", "2", "5"}));
  EXPECT_DOUBLE_EQ(axis.value_at(axis.share(37)), 37);
}

/// Where a text stands and ends, as it was measured.
struct Extent {
  double left, right;
};

std::vector<Extent> extents_of_texts(const Drawing& drawing) {
  std::vector<Extent> extents;
  for (const auto& mark : drawing.marks()) {
    const auto* text = std::get_if<Drawing::Text>(&mark);
    if (text == nullptr || text->style.turned) continue;
    const double width = text_width(text->words, text->style.size, text->style.bold);
    const double share = text->style.across == Across::left     ? 0
                         : text->style.across == Across::centre ? 0.5
                                                                : 1;
    extents.push_back({text->at.x() - share * width, text->at.x() + (1 - share) * width});
  }
  return extents;
}

TEST(Chart, NumbersAlongALogarithmicAxisKeepApart) {
  Chart chart{"", "a title", {}, 2, {}};
  ChartPanel panel{"title", "triangles", "time [ns]", true, true, {}};
  panel.curves.push_back({"a curve", {}, {1280, 20480, 1310720}, {110, 130, 250}});
  chart.panels = {panel, panel};
  const ChartPage drawn = chart_page(chart);
  std::map<double, std::vector<Extent>> rows;
  for (const auto& mark : drawn.drawing.marks()) {
    const auto* text = std::get_if<Drawing::Text>(&mark);
    if (text == nullptr || text->style.across != Across::centre || text->style.upright != Upright::top)
      continue;
    const double half = 0.5 * text_width(text->words, text->style.size);
    rows[text->at.y()].push_back({text->at.x() - half, text->at.x() + half});
  }
  ASSERT_FALSE(rows.empty());
  for (auto& [y, row] : rows) {
    ASSERT_GE(row.size(), 4u) << "powers of ten at the least";
    std::sort(row.begin(), row.end(), [](const Extent& a, const Extent& b) { return a.left < b.left; });
    for (std::size_t i = 1; i < row.size(); ++i) EXPECT_GT(row[i].left, row[i - 1].right) << "at " << y;
  }
}

TEST(Chart, PageHasRoomForAllItsTexts) {
  Chart chart{"", "a title", {std::string(160, 'M')}, 2, {}};
  ChartPanel panel{"title", "size [mm]", "error [um]", true, true, {}};
  panel.curves.push_back({"a curve with quite a long name", {}, {1, 10, 100}, {1e-6, 3e-3, 1}});
  chart.panels = {panel, panel, panel};
  const ChartPage drawn = chart_page(chart);
  const auto extents = extents_of_texts(drawn.drawing);
  EXPECT_GT(extents.size(), 20u);
  for (const Extent& extent : extents) {
    EXPECT_GE(extent.left, 0);
    EXPECT_LE(extent.right, drawn.width);
  }
}

TEST(Chart, LegendNamesEachCurveOnceAndTheFront) {
  ChartPanel panel{"", "x", "y", false, false, {{"one", {}, {0, 1}, {1, 2}}}, {{0, 2}, {1, 1}}};
  const ChartPage drawn = chart_page({"", "", {}, 1, {panel, panel}});
  const auto times = [&](const std::string& words) {
    return std::count_if(drawn.drawing.marks().begin(), drawn.drawing.marks().end(), [&](const auto& mark) {
      const auto* text = std::get_if<Drawing::Text>(&mark);
      return text != nullptr && text->words == words;
    });
  };
  EXPECT_EQ(times("one"), 1);
  EXPECT_EQ(times("Pareto front"), 1);
}

TEST(Text, IsMeasuredNotGuessed) {
  EXPECT_EQ(text_width("", 16), 0);
  EXPECT_GT(text_width("WWWW", 16), 2.5 * text_width("iiii", 16));
  EXPECT_NEAR(text_width("force [N]", 32), 2 * text_width("force [N]", 16),
              4);  // whole pixels of each letter
  EXPECT_GT(text_width("force", 16, true), text_width("force", 16));
}

}  // namespace
}  // namespace fingerpad::test
