#include "view/small_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/shapes.hpp"
#include "view/small_shape.hpp"

namespace fingerpad::small_run_test {
namespace {

/// Ticks along x, 1 ms each, touching from tick 100 on; one of them is struck.
std::vector<TickRecord> struck_run(std::size_t ticks, std::size_t struck) {
  std::vector<TickRecord> rows(ticks);
  for (std::size_t i = 0; i < ticks; ++i) {
    rows[i].t_s = 1e-3 * static_cast<double>(i);
    rows[i].p_WQ = Vec3(1e-4 * static_cast<double>(i), 0, 0);
    if (i < 100) continue;
    rows[i].phase = i == struck ? Phase::slip : Phase::stick;
    rows[i].contact_W = rows[i].p_WQ - Vec3(0, 0, 1e-3);
    rows[i].normal_force_n = i == struck ? 9 : 1;
    rows[i].force_W_n = Vec3(0, 0, rows[i].normal_force_n);
  }
  return rows;
}

TEST(SmallPath, KeepsItsEndsAndTheGreatestForce) {
  const auto rows = struck_run(5000, 1777);
  const SmallPath path = small_path(rows, 240);
  ASSERT_LE(path.points_W.size(), 240u);
  ASSERT_GE(path.points_W.size(), 230u);
  EXPECT_EQ(path.points_W.front(), rows.front().p_WQ);
  EXPECT_EQ(path.points_W.back(), rows.back().contact_W);
  const auto most = std::max_element(path.force_n.begin(), path.force_n.end());
  EXPECT_EQ(*most, 9);
  EXPECT_EQ(path.phases[static_cast<std::size_t>(most - path.force_n.begin())], Phase::slip);
}

TEST(SmallPath, OfARestIsThereAllTheSame) {
  std::vector<TickRecord> rows(1000);
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].t_s = 1e-3 * static_cast<double>(i);
  EXPECT_GE(small_path(rows, 50).points_W.size(), 2u);
  EXPECT_TRUE(small_path({}, 50).points_W.empty());
}

TEST(SmallSeries, LosesNoPeak) {
  const auto rows = struck_run(5000, 1777);
  const SmallSeries series = small_series(rows, 240);
  ASSERT_EQ(series.curves[0].values.size(), 240u);
  ASSERT_EQ(series.curves[0].name, "normal force");
  EXPECT_EQ(*std::max_element(series.curves[0].values.begin(), series.curves[0].values.end()), 9);
  EXPECT_EQ(*std::min_element(series.curves[0].values.begin(), series.curves[0].values.end()), 0);
  EXPECT_NEAR(series.begin_s + 120 * series.step_s, rows.back().t_s, 1e-12);
}

/// A bucket in which one tick of many slips is no slip: a rub that sticks nearly always must look so.
TEST(SmallSeries, TellsWhatShareOfItsTicksSlipsAndSticks) {
  auto rows = struck_run(4800, 1777);  // 40 ticks a bucket
  for (std::size_t i = 2400; i < rows.size(); ++i) rows[i].phase = i % 40 < 30 ? Phase::slip : Phase::stick;
  rows[1777].ruptures = 3;
  const SmallSeries series = small_series(rows, 240);
  ASSERT_EQ(series.slip_share.size(), 120u);
  ASSERT_EQ(series.stick_share.size(), 120u);
  EXPECT_EQ(series.stick_share[0] + series.slip_share[0], 0) << "free";
  EXPECT_EQ(series.stick_share[2], 128) << "half of it touches";
  EXPECT_EQ(series.slip_share[44], 6) << "one tick of 40, which is in bucket 1777 / 40";
  EXPECT_EQ(series.stick_share[44], 249);
  EXPECT_EQ(series.slip_share[45], 0);
  EXPECT_EQ(series.slip_share[100], 191) << "30 of 40";
  EXPECT_EQ(series.ruptures[44], 3);
  EXPECT_EQ(std::count(series.ruptures.begin(), series.ruptures.end(), 0), 119);
  const SmallSeries long_run = small_series(struck_run(120'000, 1777), 240);
  EXPECT_EQ(long_run.slip_share[1], 1) << "one tick of a thousand is not lost";
}

TEST(SmallSeries, PutsEachSampleAtItsOwnTimeSoThatARampIsStraight) {
  auto rows = struck_run(5000, 1777);
  for (TickRecord& row : rows) row.normal_force_n = std::min(row.t_s, 4.0);
  const SmallSeries series = small_series(rows, 240);
  const StripCurve& force = series.curves[0];
  ASSERT_EQ(force.places.size(), 240u);
  for (std::size_t i = 0; i < force.values.size(); ++i) {
    const double at_s =
        series.begin_s + (static_cast<double>(i / 2) + force.places[i] / 255.0) * series.bucket_s;
    // A byte is a 255th of a bucket; a tick may stand at the end of the bucket before.
    EXPECT_NEAR(force.values[i], std::min(at_s, 4.0), series.bucket_s / 255 + 1e-3) << i;
    if (i == 239) {
      EXPECT_NEAR(at_s, rows.back().t_s, 2e-3) << "it goes on to the end";
    }
  }
}

TEST(SmallSeries, OfFewTicksIsTheRun) {
  const auto rows = struck_run(200, 150);
  const SmallSeries series = small_series(rows, 240);
  ASSERT_EQ(series.curves[0].values.size(), 200u);
  EXPECT_EQ(series.curves[0].values[150], 9);
  EXPECT_NEAR(series.step_s, 1e-3, 1e-12);
  EXPECT_EQ(series.bucket_s, 0);
  EXPECT_EQ(series.slip_share[150], 255) << "of one tick it is all or nothing";
  EXPECT_EQ(series.stick_share[149], 255);
  EXPECT_NEAR(series.curves.back().values[0], 0.1, 1e-9) << "the speed's first sample is no 0";
  EXPECT_TRUE(series.curves[0].places.empty());
}

TEST(SmallShape, KeepsTheSizeOfAPartWithFewTriangles) {
  Surface surface;
  surface.part = std::make_shared<const Part>(make_part(test::sphere_soup(0.01, 6), 0.5));
  ASSERT_GT(surface.part->triangle_count(), 10'000);
  surface.p_WP = Vec3(1, 2, 3);
  const SmallShape shape = small_shape(std::span(&surface, 1), 600, {});
  EXPECT_LE(shape.triangles.size(), 660u);
  EXPECT_GE(shape.triangles.size(), 300u);
  for (const Vec3& point_W : shape.points_W) EXPECT_NEAR((point_W - surface.p_WP).norm(), 0.01, 5e-4);
  for (const auto& triangle : shape.triangles)
    for (const int corner : triangle) EXPECT_LT(corner, static_cast<int>(shape.points_W.size()));
}

}  // namespace
}  // namespace fingerpad::small_run_test
