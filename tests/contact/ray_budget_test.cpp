#include "contact/ray_budget.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/shapes.hpp"

namespace fingerpad::ray_budget_test {
namespace {

/// A closed cone of needles that all meet in its tip, and again in the middle of its base.
Part needles(int count) {
  TriangleSoup soup;
  soup.vertices_P.resize(3, count + 2);
  soup.triangles.resize(3, Eigen::Index{2} * count);
  for (int i = 0; i < count; ++i) {
    const double turn = 2 * M_PI * i / count;
    soup.vertices_P.col(i) = Vec3(0.1 * std::cos(turn), 0.1 * std::sin(turn), 0);
    soup.triangles.col(2 * i) << count, (i + 1) % count, i;
    soup.triangles.col(2 * i + 1) << count + 1, i, (i + 1) % count;
  }
  soup.vertices_P.col(count) = Vec3::Zero();
  soup.vertices_P.col(count + 1) = Vec3(0, 0, 0.05);
  return make_part(soup, 0.5);
}

TEST(RayBudget, OnAPartOfOrdinaryTrianglesIsMoreThanAnyoneSends) {
  constexpr int most_that_anyone_sends = 200000;
  EXPECT_GT(affordable_rays(make_part(test::sphere_soup(0.1, 6), 0.5)), most_that_anyone_sends);
  EXPECT_GT(affordable_rays(make_part(test::torus_soup(1, 0.4, 300, 100), 0.5)), most_that_anyone_sends);
  EXPECT_GT(affordable_rays(make_part(test::box_soup({1, 2, 3}), 0.5)), most_that_anyone_sends);
}

TEST(RayBudget, FallsAsTheNeedlesGrowInNumberSoThatTheirProductDoesNot) {
  const int few = affordable_rays(needles(20000)), many = affordable_rays(needles(80000));
  EXPECT_GE(many, 1);
  // Four times as many needles: a ray passes four times as many boxes, more or less.
  EXPECT_NEAR(static_cast<double>(few) / many, 4, 1);
  EXPECT_LT(many, 80000);
}

}  // namespace
}  // namespace fingerpad::ray_budget_test
