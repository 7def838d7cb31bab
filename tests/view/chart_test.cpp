#include "view/chart.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "view/axis.hpp"
#include "view/svg.hpp"

namespace fingerpad::test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr Box page{0, 0, 400, 300};

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
      EXPECT_GE(axis.marks.size(), 1u) << span;
    }
  }
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

TEST(Chart, KeepsPeaksOfCurvesWithManyPoints) {
  Chart chart;
  chart.x_label = "t";
  Curve curve{"c", colours::blue, CurveStyle::solid, {}};
  for (int i = 0; i < 100'000; ++i) {
    chart.x.push_back(i);
    curve.y.push_back(i == 54'321 ? 10 : 0.5 * std::sin(i * 0.1));
  }
  chart.panels.push_back({"y", "", {curve}, {}});
  Drawing drawing;
  const ChartPlace place = draw_chart(drawing, chart, page, 10);
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
  Chart chart;
  chart.x = {0, 1, 2, 3, 4, 5};
  chart.panels.push_back({"y", "", {{"", colours::blue, CurveStyle::solid, {0, 1, nan, nan, 1, 0}}}, {}});
  Drawing drawing;
  draw_chart(drawing, chart, page, 10);
  int runs = 0;
  for (const auto& mark : drawing.marks()) {
    const auto* line = std::get_if<Drawing::Line>(&mark);
    runs += line != nullptr && line->stroke.colour.blue == colours::blue.blue ? 1 : 0;
  }
  EXPECT_EQ(runs, 2);
}

TEST(Chart, StaysOnItsPageWhateverTheValues) {
  Chart chart;
  chart.x = {0, 1, 2};
  const double huge = 1e300;
  for (const std::vector<double>& y :
       {std::vector<double>{nan, nan, nan}, {0, 0, 0}, {-huge, huge, 0}, {HUGE_VAL, 1, -HUGE_VAL}, {}}) {
    chart.panels.push_back({"y", "", {{"curve", colours::blue, CurveStyle::dotted, y}}, {}});
    chart.panels.push_back(chart.panels.back());
    chart.panels.back().logarithmic = true;
  }
  Drawing drawing;
  draw_chart(drawing, chart, {0, 0, 400, 2000}, 10);
  for (const Vec2& p : all_points(drawing)) {
    ASSERT_TRUE(p.allFinite());
    EXPECT_TRUE(p.x() >= 0 && p.x() <= 400.1 && p.y() >= 0 && p.y() <= 2000) << p.transpose();
  }
}

TEST(Chart, PlacesTimeBothWays) {
  Chart chart;
  chart.x = {2, 3, 6};
  chart.panels.push_back({"y", "", {{"", colours::blue, CurveStyle::solid, {0, 1, 2}}}, {}});
  Drawing drawing;
  const ChartPlace place = draw_chart(drawing, chart, page, 10);
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
  Chart chart;
  chart.x = {0, 1, 2, 3};
  chart.panels.push_back({"y", "", {{"", colours::blue, CurveStyle::rings, {nan, 1, nan, 2}}}, {}});
  Drawing drawing;
  draw_chart(drawing, chart, page, 10);
  const auto rings = std::count_if(drawing.marks().begin(), drawing.marks().end(), [](const auto& mark) {
    const auto* line = std::get_if<Drawing::Line>(&mark);
    return line != nullptr && line->points.size() > 8 && line->points.front() == line->points.back();
  });
  EXPECT_EQ(rings, 2);
}

}  // namespace
}  // namespace fingerpad::test
