#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/random_stream.hpp"
#include "contact/curved_patch.hpp"
#include "contact/part_measures.hpp"
#include "contact/surface_point.hpp"
#include "contact/triangle_tree.hpp"
#include "part/import.hpp"
#include "support/brute_force.hpp"
#include "support/effort.hpp"
#include "support/paths.hpp"

namespace fingerpad::real_parts_test {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();
constexpr double crease_rad = 30 * M_PI / 180;

/// Points that a finger visits: near the surface (most), in the box, and around it. Relative to the part's
/// centre.
Vec3 trial_point(const Part& part, RandomStream& random, int i) {
  const Vec3 anywhere = Vec3(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5) * 2;
  if (i % 4 == 0) return anywhere.cwiseProduct(part.half_extent) * (i % 8 == 0 ? 1 : 2);
  const int t = static_cast<int>(random.uniform() * part.triangle_count());
  Vec3 w(random.uniform(), random.uniform(), random.uniform());
  w /= w.sum();
  Vec3 on = Vec3::Zero();
  for (int k = 0; k < 3; ++k) on += w[k] * part.vertices.col(part.triangles(k, t));
  return on + anywhere * part.size_m() * std::pow(10.0, -2 - 4 * random.uniform());
}

/// So many points that a part of n triangles takes some 1e7 looks at a triangle.
int affordable_points(const Part& part) {
  return std::clamp(test::samples(10000000) / part.triangle_count(), test::samples(100), 2000);
}

/// Whether the surface near a point of it has solid on one side and nothing on the other. It has not where
/// shells overlap or the surface crosses itself (winding numbers of -1 or 2 on one side); a sign means little
/// there.
bool bounds_a_solid(const Part& part, const Vec3& on_surface) {
  RandomStream random(2);
  for (int i = 0; i < 40; ++i) {
    const Vec3 off = Vec3(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5);
    const double winding =
        test::winding_number(part, on_surface + off * part.size_m() * std::pow(10.0, -2 - i % 5));
    if (std::abs(winding - 0.5) > 0.6) return false;
  }
  return true;
}

class RealParts : public testing::TestWithParam<std::filesystem::path> {
 protected:
  ImportedPart imported_ = import_part(GetParam().string(), 1e-3, crease_rad);
};

TEST_P(RealParts, AreMeasuredAsByBruteForceAndSignedAsByTheirWindingNumber) {
  if (!imported_.part) GTEST_SKIP() << imported_.verdict.error;
  const Part& part = *imported_.part;
  const TriangleTree tree(imported_.part);
  RandomStream random(1);
  int excused = 0, signs = 0, seed = -1;
  for (int i = 0; i < affordable_points(part); ++i) {
    const Vec3 q = trial_point(part, random, i);
    const SurfacePoint s = nearest_surface_point(tree, q + part.centre_P, Normals::facet, seed, unbounded);
    seed = s.triangle;
    const double truth_m = test::brute_closest(part, q).distance_m;
    // The promise of the project: 1e-12 of the part's size, and of its offset from the origin, which p_P
    // carries.
    ASSERT_NEAR(std::abs(s.signed_distance_m), truth_m, 1e-12 * (part.size_m() + part.centre_P.norm()));
    ASSERT_NEAR(s.normal_P.norm(), 1, 1e-12);
    if (!imported_.verdict.closed || i % 3 == 1 || truth_m < 1e-9 * part.size_m()) continue;
    ++signs;
    const double winding = test::winding_number(part, q);
    if ((s.signed_distance_m < 0) == (winding > 0.5)) continue;
    ++excused;
    ASSERT_FALSE(bounds_a_solid(part, s.point_P - part.centre_P))
        << "sign at " << q.transpose() << " distance " << s.signed_distance_m << " winding " << winding;
  }
  EXPECT_LT(excused,
            signs / 4 + 1);  // of the parts at hand one has a sixth of its surface inside other shells
  RecordProperty("signs", signs);
  RecordProperty("on_no_boundary", excused);
}

/// The part as a soup again, moved; its triangles in the same order.
TriangleSoup moved_soup(const Part& part, const Vec3& offset_m) {
  TriangleSoup soup;
  soup.vertices_P = part.vertices.colwise() + offset_m;
  soup.triangles = part.triangles;
  return soup;
}

TEST_P(RealParts, AnswerTheSameWhereTheyAreMovedFarOff) {
  if (!imported_.part) GTEST_SKIP() << imported_.verdict.error;
  const Part& part = *imported_.part;
  const Vec3 offset = Vec3(1e4, -1e4, 1e4) * 1e-3;  // of the file's units, millimetres
  const TriangleTree here(
      std::make_shared<const Part>(make_part(moved_soup(part, Vec3::Zero()), crease_rad)));
  const TriangleTree there(std::make_shared<const Part>(make_part(moved_soup(part, offset), crease_rad)));
  if (there.part().triangle_count() != here.part().triangle_count())
    GTEST_SKIP() << "smaller than what coordinates of that size can tell apart";
  // Every coordinate is rounded at its new size.
  const double tolerance_m = 1e-12 * (part.size_m() + offset.norm());
  RandomStream random(3);
  int signs = 0;
  for (int i = 0; i < test::samples(600); ++i) {
    const Vec3 p = trial_point(part, random, i);
    const SurfacePoint a = nearest_surface_point(here, p, Normals::facet, -1, unbounded);
    const SurfacePoint b = nearest_surface_point(there, p + offset, Normals::facet, -1, unbounded);
    ASSERT_NEAR(std::abs(a.signed_distance_m), std::abs(b.signed_distance_m), tolerance_m);
    if (!imported_.verdict.closed || std::abs(a.signed_distance_m) <= tolerance_m) continue;
    ++signs;
    ASSERT_EQ(a.signed_distance_m < 0, b.signed_distance_m < 0)
        << p.transpose() << " " << a.signed_distance_m << " " << b.signed_distance_m;
  }
  RecordProperty("signs", signs);
}

TEST_P(RealParts, StayWithinTheirPatchesReachOfTheFacetsAsCurvedSurfaces) {
  if (!imported_.part) GTEST_SKIP() << imported_.verdict.error;
  const Part& part = *imported_.part;
  const TriangleTree tree(imported_.part);
  tree.prepare_curved();
  double deviation_m = 1e-12 * (part.size_m() + part.centre_P.norm());
  for (int t = 0; t < part.triangle_count(); ++t) {
    deviation_m = std::max(deviation_m, curved_patch({part, tree.curved_normals()}, t).deviation_m);
  }
  RandomStream random(4);
  int seed = -1;
  for (int i = 0; i < test::samples(600); ++i) {
    const Vec3 p = trial_point(part, random, i) + part.centre_P;
    const SurfacePoint facet = nearest_surface_point(tree, p, Normals::facet, seed, unbounded);
    const SurfacePoint curved = nearest_surface_point(tree, p, Normals::curved, seed, unbounded);
    seed = facet.triangle;
    ASSERT_NEAR(std::abs(curved.signed_distance_m), std::abs(facet.signed_distance_m), deviation_m);
    ASSERT_NEAR(curved.normal_P.norm(), 1, 1e-12);
    if (std::abs(facet.signed_distance_m) <= deviation_m) continue;
    ASSERT_EQ(curved.signed_distance_m < 0, facet.signed_distance_m < 0);
  }
}

TEST_P(RealParts, HaveAThinnestWallWhereTheyAreClosed) {
  if (!imported_.part) GTEST_SKIP() << imported_.verdict.error;
  const double thinnest =
      told_wall_m(*imported_.part, measure_part(*imported_.part, TriangleTree(imported_.part)));
  if (imported_.verdict.closed) {
    EXPECT_GE(thinnest, 0);
    EXPECT_LE(thinnest, imported_.part->size_m());
  } else {
    EXPECT_TRUE(std::isnan(thinnest));
  }
}

std::string test_name(const testing::TestParamInfo<std::filesystem::path>& info) {
  std::string name = info.param.filename().string();
  for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return name;
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(RealParts);
INSTANTIATE_TEST_SUITE_P(Parts, RealParts, testing::ValuesIn(test::real_parts()), test_name);

}  // namespace
}  // namespace fingerpad::real_parts_test
