#include "contact/part_measures.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <bit>
#include <numbers>

#include "contact/triangle_tree.hpp"
#include "part/import.hpp"
#include "support/paths.hpp"
#include "support/shapes.hpp"

namespace fingerpad::part_measures_test {
namespace {

constexpr double degree = std::numbers::pi / 180;

PartMeasures measures_of(const TriangleSoup& soup) {
  const auto part = std::make_shared<const Part>(make_part(soup, 30 * degree));
  return measure_part(*part, TriangleTree(part));
}

/// A prism of length 3 over a rhombus with sides of 1 and this sharp angle.
TriangleSoup rhombus_soup(double angle_rad) {
  TriangleSoup soup = test::box_soup({1, 1, 3});
  for (int i = 0; i < soup.vertices_P.cols(); ++i) {
    const double x = soup.vertices_P(0, i), y = soup.vertices_P(1, i);
    soup.vertices_P.col(i).head<2>() = Vec2(x + y * std::cos(angle_rad), y * std::sin(angle_rad));
  }
  return soup;
}

TEST(PartMeasures, OfABoxAreItsRightAnglesAndItsSides) {
  const PartMeasures box = measures_of(test::box_soup({0.1, 0.2, 0.003}));
  EXPECT_EQ(box.open_edges, 0);
  EXPECT_EQ(box.contradicting_edges, 0);
  EXPECT_NEAR(box.volume_m3, 6e-5, 1e-18);  // rounding of a dozen products
  EXPECT_NEAR(box.sharpest_ridge_rad, 90 * degree, 1e-12);
  EXPECT_EQ(box.sharpest_valley_rad, 0);
  EXPECT_EQ(box.largest_smooth_turn_rad, 0) << "the diagonals of its faces are flat";
  EXPECT_EQ(box.largest_sag_m, 0);
  EXPECT_EQ(box.tightest_hollow_m, PartMeasures::inf);
  EXPECT_NEAR(box.thinnest_m, 0.003, 1e-15);
  EXPECT_NEAR(box.median_m, 0.003, 1e-15) << "nearly all of its surface";
}

TEST(PartMeasures, OfARoofTellRidgesFromValleys) {
  const PartMeasures ridge = measures_of(test::roof_soup(0.1, 70 * degree));
  EXPECT_NEAR(ridge.sharpest_ridge_rad, 70 * degree, 1e-9);
  EXPECT_EQ(ridge.sharpest_valley_rad, 0);
  EXPECT_GT(ridge.open_edges, 0) << "it is an open sheet";
  const PartMeasures valley = measures_of(test::roof_soup(0.1, -70 * degree));
  EXPECT_NEAR(valley.sharpest_valley_rad, 70 * degree, 1e-9);
  EXPECT_EQ(valley.sharpest_ridge_rad, 0);
}

TEST(PartMeasures, OfATorusAreItsSmoothTurnsSagAndHollow) {
  // Tube radius 10, ring radius 40, 64 x 32 quads. Facets turn by 2 pi/32 across the tube; the ring adds
  // less.
  const PartMeasures torus = measures_of(test::torus_soup(0.04, 0.01, 64, 32));
  EXPECT_NEAR(torus.largest_smooth_turn_rad, 2 * std::numbers::pi / 32, 0.01);
  EXPECT_EQ(torus.sharpest_valley_rad, 0) << "no crease";
  // The longest chords lie along the outer equator: 50 mm (1 - cos(pi/64)) = 6.02e-5. Triangles are lower
  // than quads are wide by what the tube's curvature takes: 1 %.
  EXPECT_NEAR(torus.largest_sag_m, 6.02e-5, 0.06e-5);
  // The ring's inner equator is hollow: R - r = 30 along the ring, seen across its edges.
  EXPECT_NEAR(torus.tightest_hollow_m, 0.03, 0.01);
  EXPECT_NEAR(torus.thinnest_m, 0.02, 0.0005) << "the tube, and its facets' sag";
}

TEST(PartMeasures, OnlySidesThatFaceOppositeWaysAreWalls) {
  const PartMeasures blunt = measures_of(rhombus_soup(70 * degree));
  EXPECT_NEAR(blunt.sharpest_ridge_rad, 110 * degree, 1e-9);
  // Sides that meet at 70 degrees do not: walls are between parallel ones alone.
  EXPECT_NEAR(blunt.thinnest_m, std::sin(70 * degree), 1e-12);
  EXPECT_NEAR(measures_of(rhombus_soup(20 * degree)).sharpest_ridge_rad, 160 * degree, 1e-9);
}

TEST(PartMeasures, OfAWedgeAreTheDiametersOfBallsBetweenItsSides) {
  // A sheet from 0.95 to 1.05 m off the apex and a wide one at 30 degrees over it. Balls between them touch
  // both at one distance d from the apex: diameter 2 d tan(15). The nearest ball starts on the wide sheet,
  // where a ray still meets the small one: at 0.95 cos(30).
  const TriangleSoup small = test::moved(test::reversed(test::square_soup(0.1, 10)), {1, 0, 0});
  TriangleSoup wide = test::moved(test::square_soup(1.8, 10), {1, 0, 0});
  const double angle = 30 * degree;
  for (int i = 0; i < wide.vertices_P.cols(); ++i)
    wide.vertices_P.col(i) = Vec3(std::cos(angle) * wide.vertices_P(0, i), wide.vertices_P(1, i),
                                  std::sin(angle) * wide.vertices_P(0, i));
  const double nearest_m = 2 * 0.95 * std::cos(angle) * std::tan(angle / 2);
  const PartMeasures wedge = measures_of(test::joined(small, wide));
  EXPECT_GE(wedge.thinnest_m, nearest_m * (1 - 1e-12));
  EXPECT_LT(wedge.thinnest_m, nearest_m + 0.012) << "rays start every 0.0225 m";
}

TEST(PartMeasures, SeeWhatHasNoInside) {
  EXPECT_GT(measures_of(test::square_soup(0.1, 3)).open_edges, 0);
  EXPECT_LT(measures_of(test::reversed(test::box_soup({1, 1, 1}))).volume_m3, 0);
  TriangleSoup torn = test::box_soup({1, 1, 1});
  std::swap(torn.triangles(0, 3), torn.triangles(1, 3));
  const PartMeasures wound = measures_of(torn);
  EXPECT_GT(wound.contradicting_edges + wound.open_edges, 0);
}

TEST(PartMeasures, SeeBodiesThatTakeTheSameRoom) {
  const TriangleSoup box = test::box_soup({0.03, 0.03, 0.03});
  EXPECT_EQ(measures_of(box).overlap_count, 0);
  const auto beside = [&](double x_m) { return test::joined(box, test::moved(box, {x_m, 0.011, 0.012})); };
  EXPECT_GT(measures_of(beside(0.02)).overlap_count, 0) << "a third of a box within the other";
  EXPECT_GT(measures_of(beside(0.03)).overlap_count, 0) << "they share a wall";
  EXPECT_EQ(measures_of(beside(0.0301)).overlap_count, 0) << "a gap of 0.1 mm";
  const TriangleSoup ball = test::sphere_soup(0.05, 3), pit = test::sphere_soup(0.03, 3);
  EXPECT_GT(measures_of(test::joined(ball, pit)).overlap_count, 0) << "a solid within a solid";
  EXPECT_EQ(measures_of(test::joined(ball, test::reversed(pit))).overlap_count, 0) << "a hollow ball";
}

TEST(PartMeasures, SeeASurfaceThatPassesThroughItself) {
  // A torus whose tube is wider than its ring: around the axis it runs through itself.
  EXPECT_GT(measures_of(test::torus_soup(0.03, 0.04, 48, 48)).overlap_count, 0);
  EXPECT_EQ(measures_of(test::torus_soup(0.04, 0.03, 48, 48)).overlap_count, 0);
}

TEST(PartMeasures, SeeNoOverlapWhereARayGrazesSlantedOrHollowFacets) {
  for (const double angle : {15.0, 40.0, 90.0, 140.0})
    EXPECT_EQ(measures_of(rhombus_soup(angle * degree)).overlap_count, 0) << angle;
  EXPECT_EQ(measures_of(test::moved(test::torus_soup(4, 1, 200, 60), {1e3, 2e3, -5e3})).overlap_count, 0);
  TriangleSoup flat_torus = test::torus_soup(4, 1, 300, 7);  // slivers
  flat_torus.vertices_P.row(2) *= 0.01;
  EXPECT_EQ(measures_of(flat_torus).overlap_count, 0);
}

TEST(PartMeasures, OfRealPartsTellWhichOverlap) {
  const auto data = test::real_data();
  if (!data) GTEST_SKIP() << "no real parts here";
  const auto overlaps = [&](const char* file) {
    const auto part = import_part((*data / file).string(), 1e-3, 30 * degree).part;
    return measure_part(*part, TriangleTree(part)).overlap_count > 0;
  };
  // What the manifest says of them: bodies that share room or walls, a surface through itself.
  for (const char* file : {"malformed/d_interpenetrating_boxes.stl", "malformed/self_intersectA.obj",
                           "parts/barkour_handle.stl", "parts/trimesh_cycloidal.ply"})
    EXPECT_TRUE(overlaps(file)) << file;
  for (const char* file : {"malformed/d_gap_0.2mm_two_plates.stl", "malformed/cube_with_hole.obj",
                           "parts/trimesh_torus.stl", "parts/axom_boxedSphere.stl", "parts/wingnut.obj",
                           "parts/so101_waveshare_plate.stl", "parts/trimesh_plate_holes.stl"})
    EXPECT_FALSE(overlaps(file)) << file << ": winding numbers of 3000 points in wingnut are 0 and 1 too";
}

TEST(PartMeasures, ScaleWithTheUnitAndDoNotMoveWithTheOrigin) {
  const TriangleSoup soup = test::torus_soup(4, 1, 24, 12);
  const PartMeasures metres = measures_of(soup);
  TriangleSoup small = soup;
  small.vertices_P *= 0.001953125;  // 2^-9: no rounding
  const PartMeasures millimetres = measures_of(small);
  EXPECT_EQ(millimetres.thinnest_m, metres.thinnest_m * 0.001953125);
  EXPECT_EQ(millimetres.largest_sag_m, metres.largest_sag_m * 0.001953125);
  EXPECT_EQ(millimetres.largest_smooth_turn_rad, metres.largest_smooth_turn_rad);
  const PartMeasures moved = measures_of(test::moved(soup, {1e3, 2e3, -5e3}));
  EXPECT_NEAR(moved.thinnest_m, metres.thinnest_m, 1e-9);  // coordinates of 5e3 carry 1e-12
  EXPECT_NEAR(moved.largest_smooth_turn_rad, metres.largest_smooth_turn_rad, 1e-9);
}

TEST(PartMeasures, AreTheSameOnAnyNumberOfThreads) {
  const auto part = std::make_shared<const Part>(make_part(test::torus_soup(4, 1, 200, 60), 30 * degree));
  const TriangleTree tree(part);
  const PartMeasures many = measure_part(*part, tree);
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const PartMeasures one = measure_part(*part, tree);
  EXPECT_EQ(std::bit_cast<std::uint64_t>(one.volume_m3), std::bit_cast<std::uint64_t>(many.volume_m3));
  EXPECT_EQ(one.thinnest_m, many.thinnest_m);
  EXPECT_EQ(one.median_m, many.median_m);
  EXPECT_EQ(one.largest_sag_m, many.largest_sag_m);
  EXPECT_EQ(one.tightest_hollow_m, many.tightest_hollow_m);
  EXPECT_EQ(one.sharpest_ridge_rad, many.sharpest_ridge_rad);
  EXPECT_EQ(one.overlap_count, many.overlap_count);
}

TEST(PartMeasures, OfRealPartsAreSaneAndTakeABoundedNumberOfRays) {
  const auto files = test::real_parts();
  if (files.empty()) GTEST_SKIP() << "no real parts here";
  for (const auto& file : files) {
    const auto part = import_part(file.string(), 1e-3, 30 * degree).part;
    if (!part) continue;
    const TriangleTree tree(part);
    const PartMeasures m = measure_part(*part, tree);
    EXPECT_LE(m.ray_count, 64 * 60000);
    EXPECT_GE(m.thinnest_m, 0) << file;
    EXPECT_LE(m.thinnest_m, m.median_m) << file;
    EXPECT_TRUE(std::isfinite(m.volume_m3)) << file;
    for (const double turn : {m.sharpest_ridge_rad, m.sharpest_valley_rad}) {
      EXPECT_GE(turn, 0) << file;
      EXPECT_LE(turn, std::numbers::pi) << file;
    }
    EXPECT_LE(m.largest_smooth_turn_rad, 30.1 * degree) << file << ": sharper edges are creases";
    EXPECT_GE(m.tightest_hollow_m, 0) << file;
  }
}

}  // namespace
}  // namespace fingerpad::part_measures_test
