#include "view/chart_board_vtk.hpp"

#include <gtest/gtest.h>
#include <vtkContextScene.h>

#include "view/drawing_device_vtk.hpp"

namespace fingerpad::test {
namespace {

/// Two panels over one axis of time that ends at `last_s`.
Chart until(double last_s) {
  ChartCurve curve{"c", {palette::blue, Dash::solid, Marker::none, 1}, {}, {}};
  for (int i = 0; i <= 100; ++i) {
    curve.x.push_back(last_s - 4 + 0.04 * i);
    curve.y.push_back(i % 7);
  }
  Chart chart;
  chart.stacked = true;
  chart.panels = {{"", "time [s]", "a [N]", false, false, {curve}},
                  {"", "time [s]", "b [mm]", false, false, {curve}}};
  return chart;
}

class ChartBoardTest : public ::testing::Test {
 protected:
  ChartBoardTest() {
    board_.add_to(scene_);
    scene_->SetGeometry(400, 300);
  }
  void show(double last_s) {
    const Chart chart = until(last_s);
    board_.show(chart, stacked_layout(chart, {0, 0, 400, 300}, 10), 400, 300);
    drawing_ = recorded(scene_);
  }
  Vec2 in_upper_panel(double share) const {
    const Box box = board_.place().panels.front();
    return {box.left + share * box.width, box.centre().y()};
  }
  void wheel(double share, int steps) {
    const Vec2 at = in_upper_panel(share);
    board_.wheel(static_cast<int>(at.x()), static_cast<int>(at.y()), steps);
  }

  vtkNew<vtkContextScene> scene_;
  ChartBoard board_;
  Drawing drawing_;  ///< as last shown
};

TEST_F(ChartBoardTest, WheelKeepsWhatIsUnderTheMouseAndMovesAllPanels) {
  show(10);
  const ChartPlace before = board_.place();
  const double at_s = before.x_at(static_cast<int>(in_upper_panel(0.25).x()));
  wheel(0.25, 2);
  const ChartPlace after = board_.place();  // of the lowest panel
  EXPECT_NEAR(after.x_max - after.x_min, 4 / 1.25 / 1.25, 1e-9);
  EXPECT_NEAR(after.x_at(static_cast<int>(in_upper_panel(0.25).x())), at_s, 1e-9);
  wheel(0.9, -9);
  EXPECT_FALSE(board_.zoomed());
  EXPECT_EQ(board_.place().x_min, before.x_min);
  EXPECT_EQ(board_.place().x_max, before.x_max);
}

TEST_F(ChartBoardTest, AZoomIsHeldHoweverFarTheCurvesHaveGoneOn) {
  show(10);
  wheel(0.5, 2);
  const ChartPlace zoomed = board_.place();
  show(18);
  EXPECT_EQ(board_.place().x_min, zoomed.x_min);
  EXPECT_EQ(board_.place().x_max, zoomed.x_max) << "not cut off where the curves begin now";
  wheel(0.5, 1);
  const ChartPlace again = board_.place();
  EXPECT_GE(again.x_min, 14) << "a wheel then means what there is";
  EXPECT_LT(again.x_min, again.x_max);
}

TEST_F(ChartBoardTest, AZoomedCurveKeepsToItsFrame) {
  show(10);
  wheel(0.5, 6);
  const Box frame = board_.place().panels.front();
  std::size_t lines = 0;
  for (const Drawing& drawing : {drawing_, recorded(scene_)}) {
    for (const auto& mark : drawing.marks()) {
      const auto* line = std::get_if<Drawing::Line>(&mark);
      if (line == nullptr || line->stroke.colour.blue != colours::blue.blue) continue;
      if (line->points.front().y() < frame.bottom - 1) continue;  // of the lower panel
      lines += line->points.size() > 2 ? 1 : 0;
      for (const Vec2& p : line->points) {
        if (p.y() > frame.top() + 1) continue;  // of the legend
        EXPECT_TRUE(p.x() > frame.left - 1e-6 && p.x() < frame.right() + 1e-6) << p.transpose();
      }
    }
  }
  EXPECT_EQ(lines, 2u) << "one before, one after";
}

TEST_F(ChartBoardTest, NobodyZoomsBeyondWhatCanBeSeen) {
  show(10);
  for (int i = 0; i < 200; ++i) wheel(0.5, 1);
  const ChartPlace place = board_.place();
  EXPECT_GT(place.x_max, place.x_min);
  EXPECT_FALSE(board_.wheel(1, 1, 1)) << "beside the frames it is not the chart's";
}

TEST_F(ChartBoardTest, AZoomedChartFollowsTheNewestValuesFromItsEnd) {
  show(10);
  wheel(1, 3);
  const double span_s = board_.place().x_max - board_.place().x_min;
  show(10.5);
  EXPECT_NEAR(board_.place().x_max, 10.5, 1e-9);
  EXPECT_NEAR(board_.place().x_max - board_.place().x_min, span_s, 1e-9);
  board_.show_all();
  EXPECT_NEAR(board_.place().x_min, 6.5, 1e-9);
}

TEST_F(ChartBoardTest, ADragMovesAZoomedChartWithinItsValues) {
  show(10);
  wheel(0.5, 4);
  const ChartPlace before = board_.place();
  const Vec2 from = in_upper_panel(0.5);
  const int x = static_cast<int>(from.x()), y = static_cast<int>(from.y());
  ASSERT_TRUE(board_.press(x, y));
  board_.move(x - 20, y);
  EXPECT_NEAR(board_.place().x_min - before.x_min,
              20 * (before.x_max - before.x_min) / before.panels[0].width, 1e-3);
  board_.move(x - 4000, y);
  board_.release(x - 4000, y);
  EXPECT_LE(board_.place().x_max, 10 + 1e-9);
  EXPECT_FALSE(board_.release(x, y));
}

}  // namespace
}  // namespace fingerpad::test
