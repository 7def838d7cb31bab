#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/random_stream.hpp"
#include "contact/effort.hpp"
#include "contact/surface_point.hpp"
#include "contact/thinnest_wall.hpp"
#include "part/import.hpp"
#include "support/brute_force.hpp"
#include "support/paths.hpp"

namespace fingerpad {
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

TEST_P(RealParts, HaveAThinnestWallWhereTheyAreClosed) {
  if (!imported_.part) GTEST_SKIP() << imported_.verdict.error;
  const double thinnest = thinnest_wall_m(*imported_.part, TriangleTree(imported_.part));
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
INSTANTIATE_TEST_SUITE_P(Parts, RealParts,
                         testing::ValuesIn(test::real_files("parts", {".stl", ".obj", ".ply", ".off"})),
                         test_name);

}  // namespace
}  // namespace fingerpad
