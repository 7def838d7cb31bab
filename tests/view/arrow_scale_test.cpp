#include "view/arrow_scale.hpp"

#include <gtest/gtest.h>

#include "view/chart_layout.hpp"
#include "view/rub.hpp"
#include "view/touch_chart.hpp"

namespace fingerpad::arrow_scale_test {
namespace {

TickRecord pressed(double t_s, double force_n) {
  TickRecord row;
  row.t_s = t_s;
  row.phase = Phase::slip;
  row.force_W_n = Vec3(0, 0, force_n);
  return row;
}

TEST(ArrowScale, RecoversAfterASpikeWhileItIsTouched) {
  ArrowScale scale({});
  scale.see(pressed(0, 1));
  EXPECT_EQ(scale.force_n(), 1.5);
  scale.see(pressed(0.01, 60));
  EXPECT_EQ(scale.force_n(), 60) << "the spike's arrow fits";
  double t_s = 0.01;
  for (; t_s < 0.5; t_s += 0.01) scale.see(pressed(t_s, 1));
  EXPECT_GT(scale.force_n(), 30) << "it does not jump back";
  for (; t_s < 10; t_s += 0.01) scale.see(pressed(t_s, 1));
  EXPECT_EQ(scale.force_n(), 1.5);
  scale.see(pressed(11, TickRecord::nan));
  EXPECT_EQ(scale.force_n(), 1.5);
}

TEST(ArrowScale, OfATraceIsTheSameWhereverOneComesFrom) {
  std::vector<TickRecord> rows;
  for (int i = 0; i < 20000; ++i) rows.push_back(pressed(1e-3 * i, i == 5000 ? 80 : 2));
  ArrowScale scale(rows);
  scale.see(rows[5000]);
  EXPECT_EQ(scale.force_n(), 80);
  scale.see(rows[19999]);
  EXPECT_EQ(scale.force_n(), 2) << "recovered";
  scale.see(rows[6000]);
  const double after_n = scale.force_n();
  scale.see(rows[100]);
  EXPECT_EQ(scale.force_n(), 2);
  scale.see(rows[6000]);
  EXPECT_EQ(scale.force_n(), after_n);
}

TEST(TouchChart, RoundingDoesNotFillAnAxis) {
  ViewInput input = test::torus_rub(0.2);
  for (TickRecord& row : input.rows) {
    row.normal_force_n *= 6e-5;
    row.p_WQ = row.contact_W = Vec3(1e-9 * row.t_s, 0, 0);
  }
  for (const Chart& chart : {touch_chart(input.rows, Vec3::UnitX(), {}), live_chart(input.rows, {})}) {
    const ChartLayout layout = stacked_layout(chart, {0, 0, 400, 600}, 12);
    const auto span = [&](std::size_t panel) {
      return layout.panels[panel].y.max - layout.panels[panel].y.min;
    };
    EXPECT_GE(span(0), 0.1) << "mm";
    EXPECT_GE(span(1), 1) << "mm/s";
    EXPECT_GE(span(2), 0.05) << "N";
  }
}

}  // namespace
}  // namespace fingerpad::arrow_scale_test
