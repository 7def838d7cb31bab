#include "study/force_comparison.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/scene.hpp"

namespace fingerpad::force_comparison_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Ticks of a normal force along z and of friction along x.
StretchRun run_of(double rate_hz, const std::vector<double>& normal_n, double mu) {
  StretchRun run;
  run.rate_hz = rate_hz;
  for (const double n : normal_n) {
    run.friction_W_n.emplace_back(-mu * n, 0, 0);
    run.force_W_n.emplace_back(-mu * n, 0, n);
    run.normal_n.push_back(static_cast<float>(n));
  }
  return run;
}

const Promises promises{ContactSettings()};  // 3 %, 10 %, 10 N

TEST(ForceComparison, ComparesAtTheRunsOwnTicks) {
  ForceComparison comparison(promises);
  comparison.add(run_of(1000, {2, 2, 4}, 0), run_of(2000, {2, 9, 2, 9, 2, 9}, 0));
  const ForceFigures figures = comparison.figures();
  EXPECT_EQ(figures.ticks, 3);
  EXPECT_DOUBLE_EQ(figures.force_rms_share, std::sqrt(4.0 / 12));  // off by 0, 0, 2 of 2, 2, 2
  EXPECT_DOUBLE_EQ(figures.force_largest_share, 1);
  EXPECT_DOUBLE_EQ(figures.step_beyond_n, 2);  // the model's step is 0 between these ticks
}

TEST(ForceComparison, TakesSmallForcesForATenthOfTheGreatest) {
  ForceComparison comparison(promises);
  comparison.add(run_of(1000, {0.11}, 0), run_of(1000, {0.01}, 0));
  EXPECT_NEAR(comparison.figures().contact_largest_share, 0.1, 1e-12);  // of 1 N
}

TEST(ForceComparison, LeavesFrictionOutOfTheContactsForce) {
  ForceComparison comparison(promises);
  comparison.add(run_of(1000, {2, 3}, 0.3), run_of(1000, {2, 3}, 0.2));
  const ForceFigures figures = comparison.figures();
  EXPECT_EQ(figures.contact_largest_share, 0);
  EXPECT_NEAR(figures.force_rms_share, 0.1 / std::hypot(1, 0.2), 1e-12);
  EXPECT_NEAR(figures.mean_mu, 0.3, 1e-12);
  EXPECT_NEAR(figures.mu_error_share, 0.5, 1e-12);
}

TEST(ForceComparison, PassesOverOneTickInAHundred) {
  std::vector<double> model(200, 2), off = model;
  off[7] = off[8] = off[150] = 4;
  ForceComparison three(promises);
  three.add(run_of(1000, off, 0), run_of(1000, model, 0));
  EXPECT_EQ(three.figures().contact_99_share, 1);
  off[150] = 2;
  ForceComparison two(promises);
  two.add(run_of(1000, off, 0), run_of(1000, model, 0));
  EXPECT_EQ(two.figures().contact_99_share, 0);
}

TEST(ForceComparison, AddsStretchesUp) {
  StretchRun run = run_of(1000, {2}, 0), model = run_of(1000, {2}, 0);
  run.ruptures = 3;
  model.ruptures = 5;
  run.pop_throughs = 1;
  ForceComparison comparison(promises);
  comparison.add(run, model);
  comparison.add(run, model);
  EXPECT_EQ(comparison.figures().ticks, 2);
  EXPECT_EQ(comparison.figures().ruptures_missed, 4);
  EXPECT_EQ(comparison.figures().pop_throughs, 2);
}

TEST(BrokenPromises, SayWhatIsNotKept) {
  ForceFigures figures;
  figures.contact_99_share = 0.03;
  figures.mu_error_share = 0.1;
  EXPECT_THAT(broken_promises(figures, promises), IsEmpty());
  figures.contact_99_share = 0.052;
  figures.mu_error_share = 0.2;
  figures.pop_throughs = 1;
  EXPECT_THAT(broken_promises(figures, promises),
              ElementsAre("1 pop-through", HasSubstr("5.2 % or more, where 3 % is asked for"),
                          HasSubstr("friction is off by 20 %, where 10 %")));
}

}  // namespace
}  // namespace fingerpad::force_comparison_test
