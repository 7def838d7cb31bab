#include "part/part.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "part/build_part.hpp"
#include "support/shapes.hpp"

namespace fingerpad::make_part_test {
namespace {

using namespace test;

constexpr double degree = std::numbers::pi / 180;
constexpr double crease_rad = 30 * degree;

int crease_count(const Part& part) {
  int count = 0;
  for (const std::uint8_t bits : part.creases) count += (bits & 1) + (bits >> 1 & 1) + (bits >> 2 & 1);
  return count;
}

void expect_units(const Points& normals) {
  for (Eigen::Index i = 0; i < normals.cols(); ++i) {
    ASSERT_NEAR(normals.col(i).norm(), 1, 1e-12) << i;  // a few roundings of a square root
  }
}

void expect_sound(const Part& part) {
  expect_units(part.facet_normals);
  expect_units(part.edge_pseudonormals);
  expect_units(part.vertex_pseudonormals);
  expect_units(part.corner_normals);
  EXPECT_EQ(part.welded.maxCoeff() + 1, part.welded_count);
  EXPECT_EQ(part.file_triangle.size(), static_cast<std::size_t>(part.triangle_count()));
  for (int t = 0; t < part.triangle_count(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int other = part.neighbours(k, t);
      if (other < 0) continue;
      EXPECT_TRUE((part.neighbours.col(other).array() == t).any()) << "neighbours are mutual";
    }
  }
}

TEST(MakePart, CentresAPartOnItsBoundingBoxAndKeepsItsPlace) {
  const Vec3 offset(10, -20, 30);
  const Part part = make_part(moved(box_soup({1, 2, 3}), offset), crease_rad);
  // Halves and small integers: every number here is exact in binary.
  EXPECT_EQ(part.centre_P, offset);
  EXPECT_EQ(part.half_extent, Vec3(0.5, 1, 1.5));
  EXPECT_EQ(bounds_P(part).min, Vec3(9.5, -21, 28.5));
  EXPECT_EQ(bounds_P(part).max, Vec3(10.5, -19, 31.5));
  EXPECT_DOUBLE_EQ(part.size_m(), std::sqrt(14.0));
}

TEST(MakePart, UnusedVerticesCountForNothing) {
  TriangleSoup soup = box_soup({1, 1, 1});
  soup.vertices_P.conservativeResize(3, 9);
  soup.vertices_P.col(8) = Vec3::Constant(std::nan(""));
  const Part part = make_part(soup, crease_rad);
  EXPECT_EQ(part.vertices.cols(), 8);
  EXPECT_EQ(part.half_extent, Vec3(0.5, 0.5, 0.5));
}

TEST(MakePart, ABoxHasTwelveCreasedEdgesAndAxisNormals) {
  for (const TriangleSoup& soup : {box_soup({1, 2, 3}), unshared(box_soup({1, 2, 3}))}) {
    const Part part = make_part(soup, crease_rad);
    expect_sound(part);
    EXPECT_EQ(part.welded_count, 8);
    EXPECT_TRUE((part.neighbours.array() >= 0).all());
    EXPECT_EQ(crease_count(part), 2 * 12);
    for (int t = 0; t < 12; ++t) {
      for (int k = 0; k < 3; ++k) {
        // A crease splits the corner normals, so each is its side's normal; 1e-15: rounding of one
        // normalisation.
        EXPECT_TRUE(part.corner_normals.col(3 * t + k).isApprox(part.facet_normals.col(t), 1e-15));
      }
    }
  }
}

TEST(MakePart, ABoxHasDiagonalPseudonormalsAtEdgesAndVertices) {
  const Part part = make_part(box_soup({1, 1, 1}), crease_rad);
  for (int t = 0; t < 12; ++t) {
    for (int k = 0; k < 3; ++k) {
      const Vec3 corner = part.vertices.col(part.triangles(k, t));
      const Vec3 at_vertex = part.vertex_pseudonormals.col(part.welded(k, t));
      // Every side meets a vertex with 90 degrees, however its diagonal lies: that is what the angles are
      // for.
      EXPECT_NEAR((at_vertex - corner.normalized()).norm(), 0, 1e-14);
      const Vec3 middle = corner + part.vertices.col(part.triangles((k + 1) % 3, t));
      EXPECT_NEAR((part.edge_pseudonormals.col(3 * t + k) - middle.normalized()).norm(), 0, 1e-14);
    }
  }
}

TEST(MakePart, CornerNormalsOfASphereAreRadialWhereItsFacetsAreSymmetricAndApproachThatElsewhere) {
  double last = 0;
  for (const int level : {3, 4}) {
    const Part part = make_part(sphere_soup(0.02, level), crease_rad);
    expect_sound(part);
    EXPECT_EQ(crease_count(part), 0);
    double worst = 0;
    for (int t = 0; t < part.triangle_count(); ++t) {
      for (int k = 0; k < 3; ++k) {
        const Vec3 radial = part.vertices.col(part.triangles(k, t)).normalized();
        const double error = (part.corner_normals.col(3 * t + k) - radial).norm();
        worst = std::max(worst, error);
        // The octahedron's own six vertices have four mirror planes each; 1e-14: rounding of four facets'
        // sum.
        if (radial.cwiseAbs().maxCoeff() > 1 - 1e-12) {
          EXPECT_LT(error, 1e-14);
        }
      }
    }
    // Angle weights are first order where the facets around a vertex differ: half the size, half the error.
    if (last > 0) {
      EXPECT_NEAR(last / worst, 2, 0.1);
    }
    EXPECT_LT(worst, 0.025);
    last = worst;
  }
}

TEST(MakePart, CornerNormalsOfATorusApproachItsOwn) {
  double last = 0;
  for (const int n : {24, 48}) {
    const Part part = make_part(torus_soup(0.03, 0.01, 2 * n, n), 60 * degree);
    expect_sound(part);
    double worst = 0;
    for (int t = 0; t < part.triangle_count(); ++t) {
      for (int k = 0; k < 3; ++k) {
        const Vec3 p = part.centre_P + part.vertices.col(part.triangles(k, t));
        const Vec3 ring = 0.03 * Vec3(p.x(), p.y(), 0).normalized();
        worst = std::max(worst, (part.corner_normals.col(3 * t + k) - (p - ring).normalized()).norm());
      }
    }
    EXPECT_LT(worst, 0.02);
    if (last > 0) {
      EXPECT_GT(last / worst, 3);  // second order gives 4, first order 2
    }
    last = worst;
  }
}

TEST(MakePart, TheCreaseAngleDecidesWhereARidgeIsSmooth) {
  for (const double turn : {20 * degree, -20 * degree, 29.999 * degree, 30 * degree}) {
    EXPECT_EQ(crease_count(make_part(roof_soup(1, turn), crease_rad)), 6)
        << turn;  // the six outer edges alone
  }
  for (const double turn : {30.001 * degree, -40 * degree, 170 * degree}) {
    EXPECT_EQ(crease_count(make_part(roof_soup(1, turn), crease_rad)), 8) << turn;
  }
}

TEST(MakePart, CornerNormalsAreSharedOverASmoothRidgeAndSplitAtACrease) {
  const Part smooth = make_part(roof_soup(1, 20 * degree), crease_rad);
  const Part sharp = make_part(roof_soup(1, 40 * degree), crease_rad);
  // Corner 0 of triangle 0 lies on the ridge, where both sides together hold 90 degrees each.
  EXPECT_NEAR((smooth.corner_normals.col(0) - Vec3::UnitZ()).norm(), 0, 1e-15);
  EXPECT_NEAR((sharp.corner_normals.col(0) - sharp.facet_normals.col(0)).norm(), 0, 1e-15);
}

TEST(MakePart, CracksBelowTheWeldReachCloseAndWiderOnesStayOpen) {
  TriangleSoup soup = unshared(box_soup({1, 1, 1}));
  const TriangleSoup whole = soup;
  const double diagonal = std::sqrt(3.0);
  for (Eigen::Index i = 0; i < soup.vertices_P.cols(); ++i) {
    soup.vertices_P.col(i).x() += (i % 2 == 0 ? 0.4e-7 : -0.4e-7) * diagonal;
  }
  double reach = 0;
  const Part closed = make_part(soup, crease_rad, &reach);
  EXPECT_NEAR(reach, 1e-7 * diagonal, 1e-13);
  EXPECT_EQ(closed.welded_count, 8);
  EXPECT_EQ(closed.vertices.cols(), 36) << "welding is connectivity only";

  soup.vertices_P.col(0).y() += 3e-7 * diagonal;
  const Part open = make_part(soup, crease_rad, &reach);
  EXPECT_EQ(reach, 0);
  EXPECT_GT(open.welded_count, 8);
  make_part(whole, crease_rad, &reach);
  EXPECT_EQ(reach, 0) << "an exact weld needs no reach";
}

TEST(MakePart, NeedlesFinerThanTheWeldReachAreNotWeldedAway) {
  TriangleSoup soup = square_soup(1, 4);
  soup.vertices_P.row(1) *= 1e-9;
  double reach = 0;
  const Part part = make_part(soup, crease_rad, &reach);
  EXPECT_EQ(reach, 0);
  EXPECT_EQ(part.triangle_count(), 32);
  EXPECT_EQ(part.welded_count, 25);
  expect_sound(part);
}

TEST(MakePart, WhereThreeTrianglesMeetThereIsNoNeighbourAndTheNormalIsTheirSum) {
  TriangleSoup soup;
  soup.vertices_P.resize(3, 5);
  soup.vertices_P << 0, 0, 1, -1, 0,  //
      0, 1, 0, 0, 0,                  //
      0, 0, 0, 0, 1;
  soup.triangles.resize(3, 3);
  soup.triangles << 1, 0, 0,  //
      0, 1, 1,                //
      2, 3, 4;
  const BuiltPart built = build_part(soup, crease_rad);
  EXPECT_EQ(built.census.nonmanifold_edges, 1);
  EXPECT_EQ(built.census.boundary_edges, 6);
  EXPECT_EQ(built.part.neighbours(0, 0), -1);
  const Vec3 sum = built.part.facet_normals.rowwise().sum();
  for (const int column : {0, 3, 6}) {
    EXPECT_NEAR((built.part.edge_pseudonormals.col(column) - sum.normalized()).norm(), 0, 1e-15);
  }
  expect_sound(built.part);
}

TEST(MakePart, ARepeatedFaceIsLeftOutInEitherWinding) {
  const TriangleSoup box = box_soup({1, 1, 1});
  for (const TriangleSoup& twice : {joined(box, box), joined(box, reversed(box))}) {
    const BuiltPart built = build_part(twice, crease_rad);
    EXPECT_EQ(built.census.duplicate, 12);
    EXPECT_EQ(built.census.nonmanifold_edges, 18);
    EXPECT_EQ(built.part.triangle_count(), 12);
    EXPECT_EQ(built.part.file_triangle.back(), 11) << "the first of each pair stays";
    EXPECT_NEAR(built.census.volume_m3, 1, 1e-15);
    expect_sound(built.part);
  }
}

TEST(MakePart, TrianglesWithEqualCornersAreLeftOutAndTheOthersKeepTheirNumbers) {
  TriangleSoup soup = box_soup({1, 1, 1});
  soup.triangles.col(3) = Eigen::Vector3i(4, 4, 6);
  const BuiltPart built = build_part(soup, crease_rad);
  EXPECT_EQ(built.census.degenerate, 1);
  EXPECT_EQ(built.part.triangle_count(), 11);
  EXPECT_EQ(built.part.file_triangle[3], 4);
  expect_sound(built.part);
}

/// A box whose top has a seam: triangle (left, middle, right) without area on the edge from left to right.
TriangleSoup seamed_box() {
  TriangleSoup soup = box_soup({1, 1, 1});
  // The edge from vertex 4 to vertex 5 bounds the top (4, 5, 7) and the front (0, 5, 4). Split the front
  // there.
  soup.vertices_P.conservativeResize(3, 9);
  soup.vertices_P.col(8) = 0.5 * (soup.vertices_P.col(4) + soup.vertices_P.col(5));
  soup.triangles.conservativeResize(3, 14);
  soup.triangles.col(5) = Eigen::Vector3i(0, 5, 8);
  soup.triangles.col(12) = Eigen::Vector3i(0, 8, 4);
  soup.triangles.col(13) = Eigen::Vector3i(4, 8, 5);
  return soup;
}

TEST(MakePart, ASeamWithoutAreaKeepsTheMeshClosedAndShowsTheFacetsBesideIt) {
  const BuiltPart built = build_part(seamed_box(), crease_rad);
  const Part& part = built.part;
  expect_sound(part);
  EXPECT_EQ(built.census.degenerate, 1);
  EXPECT_TRUE(built.census.closed);
  ASSERT_EQ(part.triangle_count(), 14);
  const Vec3 up = Vec3::UnitZ(), edge = Vec3(0, -1, 1).normalized();
  EXPECT_NEAR((part.facet_normals.col(13) - up).norm(), 0, 1e-15)
      << "the middle vertex stands on the top's edge";
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR((part.edge_pseudonormals.col(3 * 13 + k) - edge).norm(), 0, 1e-15) << k;
  }
  const Vec3 middle = part.vertex_pseudonormals.col(part.welded(1, 13));
  EXPECT_NEAR((middle - edge).norm(), 0, 1e-15);  // half a turn of top and half a turn of front
}

TEST(MakePart, AnIsolatedTriangleWithoutAreaIsLeftOut) {
  TriangleSoup line;
  line.vertices_P.resize(3, 3);
  line.vertices_P << 5, 6, 7,  //
      0, 0, 0,                 //
      0, 0, 0;
  line.triangles.resize(3, 1);
  line.triangles << 0, 1, 2;
  const BuiltPart built = build_part(joined(box_soup({1, 1, 1}), line), crease_rad);
  EXPECT_EQ(built.part.triangle_count(), 12);
  EXPECT_EQ(built.part.half_extent, Vec3(0.5, 0.5, 0.5)) << "and counts for no bounds";
  EXPECT_EQ(build_part(line, crease_rad).part.triangle_count(), 0);
}

TEST(MakePart, OpposedWindingIsSeenAndLeavesUnitNormals) {
  TriangleSoup soup = box_soup({1, 1, 1});
  std::swap(soup.triangles(0, 2), soup.triangles(1, 2));
  const BuiltPart built = build_part(soup, crease_rad);
  EXPECT_EQ(built.census.inconsistent_edges, 3);
  EXPECT_TRUE((built.part.neighbours.array() >= 0).all());
  expect_sound(built.part);
}

TEST(MakePart, InwardBodiesAreCountedAndCavitiesAreNot) {
  const TriangleSoup outer = box_soup({3, 3, 3}), inner = reversed(box_soup({1, 1, 1}));
  EXPECT_EQ(build_part(joined(outer, inner), crease_rad).census.inward_bodies, 0);
  const BuiltPart aside = build_part(joined(outer, moved(inner, {5, 0, 0})), crease_rad);
  EXPECT_EQ(aside.census.inward_bodies, 1);
  EXPECT_EQ(aside.census.components, 2);
  EXPECT_NEAR(aside.census.volume_m3, 26, 1e-12);  // some dozens of roundings of numbers up to 100
}

TEST(MakePart, AFarOffPartIsThePartItselfMoved) {
  // Moved by a power of two, box coordinates stay exact, so that nothing but the centre may change.
  const Part near = make_part(sphere_soup(1, 0), crease_rad);
  const Part far = make_part(moved(sphere_soup(1, 0), {8192, -8192, 8192}), crease_rad);
  EXPECT_EQ(near.vertices, far.vertices);
  EXPECT_EQ(near.corner_normals, far.corner_normals);
  EXPECT_EQ(near.vertex_pseudonormals, far.vertex_pseudonormals);
}

/// Were each to look at all others this would take an hour, and a watchdog ends the test.
TEST(MakePart, SeamsThatAllShareOneEdgeTakeTheNormalOfTheFacetThere) {
  constexpr int seams = 300000;
  TriangleSoup soup;
  soup.vertices_P.resize(3, seams + 3);
  soup.triangles.resize(3, seams + 1);
  soup.vertices_P.col(0) = Vec3(0, 0, 0);
  soup.vertices_P.col(1) = Vec3(0, 0, 1);
  soup.vertices_P.col(2) = Vec3(1, 0, 0);
  soup.triangles.col(0) << 0, 1, 2;
  for (int i = 0; i < seams; ++i) {
    soup.vertices_P.col(3 + i) = Vec3(0, 0, 2 + i);
    soup.triangles.col(1 + i) << 0, 1, 3 + i;
  }
  const Part part = make_part(soup, 0.5);
  ASSERT_EQ(part.triangle_count(), seams + 1);
  for (int t = 0; t < part.triangle_count(); t += 1000)
    EXPECT_EQ(part.facet_normals.col(t), Vec3(0, 1, 0)) << t;
}

}  // namespace
}  // namespace fingerpad::make_part_test
