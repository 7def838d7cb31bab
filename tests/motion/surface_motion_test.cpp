// Rubs laid on parts, held against what a finger's centre must do: brute-force distances, and a sheet's own
// geometry.
#include "motion/surface_motion.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "contact/surface_point.hpp"
#include "contact/triangle_tree.hpp"
#include "support/shapes.hpp"

namespace fingerpad::surface_motion_test {
namespace {

using Shape = SurfaceMotion::Shape;

TriangleTree tree_of(const TriangleSoup& soup) {
  return TriangleTree(std::make_shared<const Part>(make_part(soup, 0.5)));
}

SurfaceMotion rub_of(Shape shape, double size_m, double turns = 1, std::int64_t place = 1) {
  SurfaceMotion rub;
  rub.shape = shape;
  rub.size_m = size_m;
  rub.turns = turns;
  rub.place = place;
  return rub;
}

/// The points of the rub itself, without the way there and back.
Points rubbed(const Motion& motion) {
  return motion.p_WQ.middleCols(1, motion.p_WQ.cols() - 2);
}

/// A torus has hollow and bulging sides, a box has edges.
TEST(SurfaceMotion, KeepsItsDistanceFromEveryPartOfTheSurface) {
  const double radius_m = 0.004, depth_m = 0.001;
  for (const TriangleSoup& soup : {test::sphere_soup(0.03, 4), test::box_soup({0.04, 0.03, 0.02}),
                                   test::torus_soup(0.03, 0.01, 60, 30)}) {
    const TriangleTree tree = tree_of(soup);
    for (const Shape shape : {Shape::line, Shape::circle, Shape::spiral}) {
      for (std::int64_t place = 0; place < 3; ++place) {
        const Points way =
            rubbed(lay_on_surface(tree, rub_of(shape, 0.02, 1, place), radius_m, depth_m).motion);
        for (Eigen::Index i = 0; i < way.cols(); ++i) {
          const SurfacePoint nearest = nearest_surface_point(tree, way.col(i), Normals::facet, -1, HUGE_VAL);
          // The walk's tolerance is a millionth of the figure.
          ASSERT_NEAR(nearest.signed_distance_m, radius_m - depth_m, 3e-8) << "sample " << i;
        }
      }
    }
  }
}

TEST(SurfaceMotion, GoesAtAnEvenSpeedAndTakesItsTime) {
  const TriangleTree tree = tree_of(test::sphere_soup(0.03, 4));
  SurfaceMotion rub = rub_of(Shape::circle, 0.01, 2);
  rub.speed_m_per_s = 0.05;
  const Motion motion = lay_on_surface(tree, rub, 0.004, 0.001).motion;
  EXPECT_DOUBLE_EQ(motion.t_s.back(), duration_s(rub, 0.001));
  for (std::size_t i = 1; i < motion.t_s.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const double gone_m = (motion.p_WQ.col(k) - motion.p_WQ.col(k - 1)).norm();
    // Steps are taken along tangents and put back on the surface: of second order in 1/100 of a radius.
    EXPECT_NEAR(gone_m / (motion.t_s[i] - motion.t_s[i - 1]), 0.05, 0.001) << i;
  }
}

TEST(SurfaceMotion, DrawsItsFigureOnAFlatSheetAsOnPaper) {
  const TriangleTree tree = tree_of(test::square_soup(0.2, 4));
  const Points circle = rubbed(lay_on_surface(tree, rub_of(Shape::circle, 0.02), 0.001, 0).motion);
  const Vec3 middle = circle.leftCols(circle.cols() - 1).rowwise().mean();
  for (Eigen::Index i = 0; i < circle.cols(); ++i) EXPECT_NEAR((circle.col(i) - middle).norm(), 0.02, 2e-5);
  EXPECT_LT((circle.col(0) - circle.rightCols(1)).norm(), 2e-5) << "it closes";

  const LaidMotion spiral = lay_on_surface(tree, rub_of(Shape::spiral, 0.02, 3), 0.001, 0);
  const Points turns = rubbed(spiral.motion);
  const auto from_place = [&](Eigen::Index i) { return (turns.col(i) - turns.col(0)).norm(); };
  EXPECT_NEAR(from_place(turns.cols() - 1), 0.02, 2e-4);
  // Archimedes': the way grows with the square of the radius.
  EXPECT_NEAR(from_place(turns.cols() / 4), 0.01, 4e-4);

  const Points line = rubbed(lay_on_surface(tree, rub_of(Shape::line, 0.03, 2), 0.001, 0).motion);
  EXPECT_LT((line.col(0) - line.rightCols(1)).norm(), 1e-9) << "two strokes end where they began";
  EXPECT_NEAR((line.col(0) - line.col(line.cols() / 2)).norm(), 0.03, 1e-9);
}

TEST(SurfaceMotion, StaysOnAnOpenSheet) {
  const TriangleTree tree = tree_of(test::square_soup(0.1, 4));
  for (std::int64_t place = 0; place < 200; ++place) {
    const LaidMotion laid = lay_on_surface(tree, rub_of(Shape::line, 0.02, 1, place), 0.002, 0.0005);
    EXPECT_LT(rubbed(laid.motion).topRows(2).cwiseAbs().maxCoeff(), 0.05) << place;
    EXPECT_LT(std::abs(laid.place_P.z()), 1e-12);
  }
}

TEST(SurfaceMotion, ComesFromOutsideAndGoesThere) {
  const TriangleTree tree = tree_of(test::box_soup({0.04, 0.03, 0.02}));
  const double radius_m = 0.003;
  const Motion motion = lay_on_surface(tree, rub_of(Shape::line, 0.01), radius_m, 0.001).motion;
  for (const Eigen::Index end : {Eigen::Index{0}, motion.p_WQ.cols() - 1}) {
    const SurfacePoint nearest =
        nearest_surface_point(tree, motion.p_WQ.col(end), Normals::facet, -1, HUGE_VAL);
    EXPECT_GT(nearest.signed_distance_m, radius_m);
  }
}

TEST(SurfaceMotion, ClimbsTheOtherWallOfACornerWithoutBeingPressedDeeper) {
  const TriangleTree tree = tree_of(test::roof_soup(0.1, -std::numbers::pi / 2));
  const double distance_m = 0.003;
  int corners = 0;
  for (std::int64_t place = 0; place < 10; ++place) {
    const Points way = rubbed(lay_on_surface(tree, rub_of(Shape::line, 0.06, 1, place), 0.004, 0.001).motion);
    double least_m = 1, most_turn = 0;
    Vec3 first = Vec3::Zero();
    for (Eigen::Index i = 0; i < way.cols(); ++i) {
      const SurfacePoint nearest = nearest_surface_point(tree, way.col(i), Normals::facet, -1, HUGE_VAL);
      least_m = std::min(least_m, nearest.signed_distance_m);
      if (i == 0) first = nearest.normal_P;
      most_turn = std::max(most_turn, (nearest.normal_P - first).norm());
    }
    EXPECT_NEAR(least_m, distance_m, 1e-7);
    corners += static_cast<int>(most_turn > 1);
  }
  EXPECT_GT(corners, 0) << "none of them met the corner";
}

TEST(SurfaceMotion, DependsOnItsPlaceAlone) {
  const TriangleTree tree = tree_of(test::sphere_soup(0.03, 3));
  const auto way = [&](std::int64_t place) {
    return lay_on_surface(tree, rub_of(Shape::circle, 0.01, 1, place), 0.004, 0.001).motion.p_WQ;
  };
  EXPECT_EQ(way(1), way(1));
  EXPECT_GT((way(1).col(1) - way(2).col(1)).norm(), 1e-3);
}

TEST(SurfaceMotion, AFigureThatNoPlaceHoldsIsRefused) {
  const TriangleTree sheet = tree_of(test::square_soup(0.1, 4));
  try {
    lay_on_surface(sheet, rub_of(Shape::line, 0.3), 0.002, 0.001);
    ADD_FAILURE() << "no place holds it";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("the part is 141 mm across: is its unit right?"));
  }
  // A wall of 2 mm cannot be pressed in by 1.5 mm: its other side is nearer.
  const TriangleTree plate = tree_of(test::box_soup({0.05, 0.05, 0.002}));
  EXPECT_THROW(lay_on_surface(plate, rub_of(Shape::line, 0.01), 0, 0.0015), Error);
  EXPECT_NO_THROW(lay_on_surface(plate, rub_of(Shape::line, 0.01), 0, 0.0005));
}

}  // namespace
}  // namespace fingerpad::surface_motion_test
