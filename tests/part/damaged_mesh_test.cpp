#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "part/import.hpp"
#include "support/mesh_files.hpp"
#include "support/paths.hpp"
#include "support/shapes.hpp"
#include "support/signs.hpp"

namespace fingerpad::damaged_mesh_test {
namespace {

using namespace test;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

ImportedPart import_soup(const TriangleSoup& soup) {
  ImportOptions options;
  options.metres_per_unit = 1;
  return import_part(write_file(scratch_dir(), "part.obj", obj_text(soup)).string(), options);
}

void expect_told(const ImportedPart& imported, const std::string& words) {
  ASSERT_TRUE(imported.verdict.touchable) << imported.verdict.error;
  EXPECT_THAT(imported.verdict.warnings, Contains(HasSubstr(words)));
}

bool in_box(const Vec3& p, const Vec3& centre) {
  return (p - centre).cwiseAbs().maxCoeff() < 0.5;
}

const Vec3 unit_box(1, 1, 1);

/// Rounding to float32 keeps every number here but for spheres: halves, quarters and small integers.
TriangleSoup box_at(const Vec3& centre) {
  return moved(box_soup(unit_box), centre);
}

TEST(DamagedMesh, AFinOnAnEdgeIsNonManifoldAndOpenAndLeavesTheSolidsSignFarFromIt) {
  TriangleSoup soup = box_at({0, 0, 0});
  soup.vertices_P.conservativeResize(3, 9);
  soup.vertices_P.col(8) = Vec3(1, 1, 0);
  soup.triangles.conservativeResize(3, 13);
  soup.triangles.col(12) << 3, 7, 8;
  const ImportedPart imported = import_soup(soup);
  expect_told(imported, "non-manifold: 1 edge with more than two triangles");
  expect_told(imported, "open: 2 boundary edges");
  EXPECT_EQ(imported.verdict.nonmanifold_edges, 1);
  EXPECT_FALSE(imported.verdict.closed);
  expect_touchable(imported.part, 200, nullptr);
}

TEST(DamagedMesh, TwoBoxesThatMeetInAnEdgeAreTwoSolids) {
  const ImportedPart imported = import_soup(joined(box_at({0, 0, 0}), box_at({1, 1, 0})));
  expect_told(imported, "non-manifold: 1 edge");
  EXPECT_EQ(imported.verdict.inconsistent_edges, 0);
  expect_touchable(imported.part, 500, [](const Vec3& p) {
    return in_box(p, {0, 0, 0}) || in_box(p, {1, 1, 0});
  });
}

TEST(DamagedMesh, AnInvertedShellIsToldAndSwapsInsideAndOutside) {
  const ImportedPart imported = import_soup(reversed(box_at({0, 0, 0})));
  expect_told(imported, "wound inwards (negative volume)");
  EXPECT_DOUBLE_EQ(imported.verdict.volume_m3, -1);
  expect_touchable(imported.part, 200, [](const Vec3& p) { return !in_box(p, {0, 0, 0}); });
}

TEST(DamagedMesh, OneInvertedShellBesideAnotherIsTold) {
  const ImportedPart imported = import_soup(joined(box_at({0, 0, 0}), reversed(box_at({3, 0, 0}))));
  expect_told(imported, "one closed body is wound inwards");
  EXPECT_EQ(imported.verdict.components, 2);
  expect_touchable(imported.part, 200, nullptr);
}

TEST(DamagedMesh, AnInvertedShellInTheHoleOfARingIsNoCavity) {
  // Its box lies in the ring's box, but it does not lie in the ring.
  const TriangleSoup ring = torus_soup(2, 0.5, 24, 12);
  const TriangleSoup ball = moved(sphere_soup(0.25, 2), {0.25, 0.125, 0});
  expect_told(import_soup(joined(ring, reversed(ball))), "one closed body is wound inwards");
  EXPECT_THAT(import_soup(joined(ring, ball)).verdict.warnings, IsEmpty());
}

TEST(DamagedMesh, DuplicatesAreLeftOutAndTheSignsAreRight) {
  const ImportedPart imported = import_soup(joined(box_at({0, 0, 0}), box_at({0, 0, 0})));
  expect_told(imported, "12 duplicate triangles");
  EXPECT_EQ(imported.verdict.duplicate, 12);
  EXPECT_EQ(imported.verdict.kept, 12);
  expect_touchable(imported.part, 200, [](const Vec3& p) { return in_box(p, {0, 0, 0}); });
}

TEST(DamagedMesh, OverlappingSolidsHaveTheSignOfTheNearestSheet) {
  const Vec3 second(0.5, 0.25, 0.25);
  const ImportedPart imported = import_soup(joined(box_at({0, 0, 0}), box_at(second)));
  ASSERT_TRUE(imported.verdict.touchable);
  EXPECT_TRUE(imported.verdict.closed);
  EXPECT_EQ(imported.verdict.components, 2);
  // Outside both, and in one alone whose own walls are nearest, the sign is the union's.
  const auto nearest_sheet = [&](const Vec3& p) {
    const auto side = [&p](const Vec3& centre) {
      const Vec3 over = (p - centre).cwiseAbs() - Vec3::Constant(0.5);
      return over.maxCoeff() < 0 ? over.maxCoeff() : over.cwiseMax(0).norm();
    };
    const double a = side({0, 0, 0}), b = side(second);
    return (std::abs(a) < std::abs(b) ? a : b) < 0;
  };
  expect_touchable(imported.part, 500, nearest_sheet);
}

TEST(DamagedMesh, AnOpenSheetIsToldAndHasASideAboveAndBelow) {
  const ImportedPart imported = import_soup(square_soup(1, 4));
  expect_told(imported, "open: 16 boundary edges; a finger can pass through");
  EXPECT_FALSE(imported.verdict.closed);
  expect_touchable(imported.part, 200, nullptr);
}

TEST(DamagedMesh, ACavityIsNoDamageAndAnOutwardShellInAnotherIsTold) {
  const TriangleSoup outer = sphere_soup(1, 3), inner = moved(sphere_soup(0.5, 2), {0.25, 0, 0});
  const ImportedPart hollow = import_soup(joined(outer, reversed(inner)));
  EXPECT_THAT(hollow.verdict.warnings, IsEmpty());
  EXPECT_EQ(hollow.verdict.components, 2);
  expect_touchable(hollow.part, 200, nullptr);
  expect_told(import_soup(joined(outer, inner)),
              "one closed body lies inside another and is wound outwards too");
}

TEST(DamagedMesh, AThousandBodiesAreCountedAndTouched) {
  TriangleSoup soup = box_at({0, 0, 0});
  for (int i = 1; i < 1024; i *= 2) soup = joined(soup, moved(soup, {2.0 * i, 0, 0}));
  const ImportedPart imported = import_soup(soup);
  EXPECT_THAT(imported.verdict.warnings, IsEmpty());
  EXPECT_EQ(imported.verdict.components, 1024);
  expect_touchable(imported.part, 200, [](const Vec3& p) {
    const double along = p.x() - 2 * std::round(p.x() / 2);
    return p.x() > -1 && p.x() < 2047 && in_box({along, p.y(), p.z()}, {0, 0, 0});
  });
}

}  // namespace
}  // namespace fingerpad::damaged_mesh_test
