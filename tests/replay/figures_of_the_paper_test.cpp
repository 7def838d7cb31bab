#include <gtest/gtest.h>

#include <cmath>

#include "replay/run_job.hpp"
#include "scene/scene_file.hpp"
#include "support/paths.hpp"
#include "touch/closed_loop.hpp"
#include "trace/motion_source.hpp"

// The paper's flat-plane runs as scenes: what figs. 2 and 12 show, as numbers.

namespace fingerpad::figures_of_the_paper_test {
namespace {

std::vector<TickRecord> rows_of(const Scene& scene) {
  ClosedLoop loop(load_world(scene), scene, load_finger_path(scene));
  std::vector<TickRecord> rows;
  for (long k = 0; k < loop.tick_count(); ++k) rows.push_back(loop.next());
  return rows;
}

Scene scene_named(const std::string& name) {
  return read_scene_file((test::source_dir() / "scenes" / (name + ".toml")).string()).scene;
}

class PaperFigure : public testing::TestWithParam<const char*> {};

TEST_P(PaperFigure, SlipsAtTheDynamicCoefficientAndNeverPassesTheStatic) {
  const auto rows = rows_of(scene_named(GetParam()));
  long slip = 0, stick = 0;
  for (const TickRecord& row : rows) {
    ASSERT_LE(row.mu, 0.3 * (1 + 1e-9)) << row.t_s;
    if (row.phase == Phase::slip) {
      ASSERT_NEAR(row.mu, 0.2, 1e-9) << row.t_s;
    }
    slip += row.phase == Phase::slip ? 1 : 0;
    stick += row.phase == Phase::stick ? 1 : 0;
  }
  EXPECT_GT(slip, 100) << "plateaux in slip";
  EXPECT_GT(stick, 50) << "transients in stick";
}

TEST_P(PaperFigure, ForceIsContinuousIntoStickAndJumpsOutOfIt) {
  Scene scene = scene_named(GetParam());
  scene.friction.settings.events = Events::tick;  // so that the tick of a rupture itself shows mu_d
  const auto rows = rows_of(scene);
  long into = 0, out = 0;
  double highest = 0;
  for (std::size_t k = 1; k < rows.size(); ++k) {
    if (rows[k - 1].phase == Phase::slip && rows[k].phase == Phase::stick) {
      ++into;
      EXPECT_NEAR(rows[k].mu, 0.2, 1e-9) << rows[k].t_s;
      EXPECT_NEAR(rows[k].friction_W_n.normalized().dot(rows[k - 1].friction_W_n.normalized()), 1, 1e-9);
    }
    if (rows[k - 1].phase == Phase::stick && rows[k].phase == Phase::slip) {
      ++out;
      highest = std::max(highest, rows[k - 1].mu);
      EXPECT_NEAR(rows[k].mu, 0.2, 1e-9) << rows[k].t_s;
    }
  }
  EXPECT_GE(into, 2);
  EXPECT_GE(out, 2);
  EXPECT_GT(highest, 0.27) << "the spring is stretched almost to 0.3 before it breaks, to a tick's motion";
}

INSTANTIATE_TEST_SUITE_P(Scenes, PaperFigure, testing::Values("figure2", "figure12"));

TEST(PaperFigure12, IsRecordedAtFiveHundredHertzWithTheKnownCoefficients) {
  const Scene scene = scene_named("figure12");
  EXPECT_EQ(scene.motion.rate_hz, 500);
  ASSERT_EQ(scene.planes.size(), 1u);
  EXPECT_EQ(scene.planes[0].surface.mu_static, 0.3);
  EXPECT_EQ(scene.planes[0].surface.mu_dynamic, 0.2);
}

TEST(PaperFigure2, TheSpringRisesAfterStickBeginsFallsAndBreaksAtTheOtherSide) {
  // Fig. 2: after point a the position still rises a little, the spring with it; then the stroke turns, the
  // spring relaxes, pulls the other way and breaks at mu_s.
  const auto rows = rows_of(scene_named("figure2"));
  long strokes = 0;
  for (std::size_t k = 1; k + 1 < rows.size(); ++k) {
    if (rows[k - 1].phase != Phase::slip || rows[k].phase != Phase::stick) continue;
    const double start = rows[k].mu;
    const Vec3 first = rows[k].friction_W_n;
    double peak = start;
    bool reversed = false;
    for (; k < rows.size() && rows[k].phase == Phase::stick; ++k) {
      peak = std::max(peak, rows[k].friction_W_n.dot(first.normalized()) / rows[k].normal_force_n);
      reversed |= rows[k].friction_W_n.dot(first) < 0;
    }
    if (!reversed) continue;
    ++strokes;
    EXPECT_GT(peak, start + 0.001);
  }
  EXPECT_GE(strokes, 2);
}

}  // namespace
}  // namespace fingerpad::figures_of_the_paper_test
