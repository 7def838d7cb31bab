#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/random_stream.hpp"
#include "contact/bare_part.hpp"
#include "contact/segment_crossing.hpp"
#include "contact/triangle_tree.hpp"
#include "part/import.hpp"
#include "support/effort.hpp"
#include "support/paths.hpp"
#include "support/shapes.hpp"

namespace fingerpad::tree_queries_test {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

Vec3 random_point(RandomStream& random, double scale) {
  return Vec3(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5) * (2 * scale);
}

std::vector<int> within(const TriangleTree& tree, const Vec3& q, double reach_m) {
  std::vector<int> found;
  const auto add = [](void* list, int t) { static_cast<std::vector<int>*>(list)->push_back(t); };
  tree.each_within(q, reach_m, add, &found);
  std::sort(found.begin(), found.end());
  return found;
}

void expect_all_within(const TriangleTree& tree, const Vec3& q, double reach_m) {
  const Part& part = tree.part();
  std::vector<int> expected;
  for (int t = 0; t < part.triangle_count(); ++t) {
    if (closest_on_triangle(part, t, q).distance2_m2 <= reach_m * reach_m) expected.push_back(t);
  }
  ASSERT_EQ(within(tree, q, reach_m), expected) << q.transpose() << " reach " << reach_m;
}

SegmentHit brute_crossing(const Part& part, const Vec3& from, const Vec3& to) {
  const SegmentCrossing crossing(from, to);
  SegmentHit hit;
  for (int t = 0; t < part.triangle_count(); ++t) {
    const auto corner = [&](int k) -> Vec3 { return part.vertices.col(part.triangles(k, t)); };
    const double along = crossing.entry(corner(0), corner(1), corner(2));
    if (along < hit.along) hit = {t, along};
  }
  return hit;
}

void expect_same_crossing(const TriangleTree& tree, const Vec3& from, const Vec3& to) {
  const SegmentHit expected = brute_crossing(tree.part(), from, to), found = tree.first_crossing(from, to);
  ASSERT_EQ(found.triangle, expected.triangle) << from.transpose() << " -> " << to.transpose();
  ASSERT_EQ(found.along, expected.along);
}

std::shared_ptr<const Part> torus(int n, int m) {
  return std::make_shared<const Part>(make_part(test::torus_soup(1, 0.4, n, m), 0.5));
}

TEST(EachWithin, FindsWhatBruteForceFinds) {
  const auto part = torus(40, 24);
  const TriangleTree tree(part);
  RandomStream random(1);
  for (int i = 0; i < test::samples(1000); ++i) {
    const Vec3 q = random_point(random, 1.5);
    const double nearest_m = std::sqrt(tree.closest(q, -1, unbounded).at.distance2_m2);
    for (const double reach_m :
         {nearest_m, nearest_m * (1 + 1e-12), nearest_m * 0.999, nearest_m + 0.05, 1.0, 100.0}) {
      expect_all_within(tree, q, reach_m);
      if (HasFatalFailure()) return;
    }
    expect_all_within(tree, q * 1e5, 1e5 * q.norm());
    if (HasFatalFailure()) return;
  }
}

TEST(EachWithin, OnASharedVertexAReachOfNothingFindsItsFan) {
  const auto part = torus(16, 10);
  const TriangleTree tree(part);
  for (int v = 0; v < part->vertices.cols(); ++v) {
    EXPECT_EQ(within(tree, part->vertices.col(v), 0).size(), 6U);
  }
}

TEST(EachWithin, FindsNothingWhereThereIsNothingToAsk) {
  const auto part = torus(8, 6);
  const TriangleTree tree(part);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(within(tree, {0, 0, nan}, 1).empty());
  EXPECT_TRUE(within(tree, {1, 0, 0}, nan).empty());
  EXPECT_TRUE(within(tree, {1, 0, 0}, -1).empty());
  EXPECT_TRUE(within(tree, {1e300, 0, 0}, 1).empty());
  EXPECT_EQ(within(tree, {1e300, 0, 0}, unbounded).size(), static_cast<std::size_t>(part->triangle_count()));
}

TEST(FirstCrossing, IsTheOneThatBruteForceFinds) {
  const auto part = torus(40, 24);
  const TriangleTree tree(part);
  RandomStream random(2);
  int hits = 0;
  for (int i = 0; i < test::samples(4000); ++i) {
    const double far = i % 4 == 0 ? 1e6 : i % 4 == 1 ? 10 : 1.5;
    const Vec3 to = random_point(random, 1),
               from = i % 3 == 0 ? random_point(random, 1) : random_point(random, far);
    expect_same_crossing(tree, from, to);
    if (HasFatalFailure()) return;
    hits += tree.first_crossing(from, to).triangle >= 0 ? 1 : 0;
  }
  EXPECT_GT(hits, test::samples(1000));
}

TEST(FirstCrossing, NothingSlipsThroughEdgesAndVertices) {
  // From outside through every vertex and edge of a closed surface, and aimed a rounding beside them, into
  // the torus's core, that no two facets share.
  const auto part = torus(24, 16);
  const TriangleTree tree(part);
  RandomStream random(3);
  for (int t = 0; t < part->triangle_count(); ++t) {
    const Vec3 a = part->vertices.col(part->triangles(0, t)), b = part->vertices.col(part->triangles(1, t));
    const Vec3 middle = a + 0.37 * (b - a);
    for (const Vec3& on : {a, middle}) {
      const Vec3 ring = Vec3(on.x(), on.y(), 0).normalized();
      for (int i = 0; i < 4; ++i) {
        const Vec3 core = ring + random_point(random, 1e-3), aim = on + random_point(random, i * 1e-16);
        const Vec3 from = core + 1.5 * (aim - core), to = core;
        const SegmentHit hit = tree.first_crossing(from, to);
        ASSERT_GE(hit.triangle, 0) << aim.transpose();
        ASSERT_NEAR(((from + hit.along * (to - from)) - on).norm(), 0, 1e-14);  // some roundings of 1.5
        expect_same_crossing(tree, from, to);
        if (HasFatalFailure()) return;
      }
    }
  }
}

TEST(FirstCrossing, CountsOnlyWaysIn) {
  const auto part = std::make_shared<const Part>(make_part(test::torus_soup(1, 0.4, 60, 40), 0.5));
  const TriangleTree tree(part);
  const Vec3 core(1, 0, 0), outside(2, 0.01, 0.02);
  EXPECT_EQ(tree.first_crossing(core, outside).triangle, -1);
  const SegmentHit in = tree.first_crossing(outside, core);
  ASSERT_GE(in.triangle, 0);
  EXPECT_LT(part->facet_normals.col(in.triangle).dot(core - outside), 0);
  EXPECT_NEAR(in.along, 0.6, 1e-2);  // facets lie up to 0.4 (1 - cos(pi / 40)) within the torus
  // On through the hole of the ring: out at 0.6, in again at -0.6.
  const SegmentHit across = tree.first_crossing(core, {-1, 0.01, 0.02});
  ASSERT_GE(across.triangle, 0);
  EXPECT_NEAR(across.along, 0.8, 1e-2);
}

TEST(FirstCrossing, TiesGoToTheLowestTriangle) {
  Points vertices(3, 4);
  vertices << -1, 1, 0, 0, 0, 0, 1, -1, 0, 0, 0, 0;
  IndexTriples triangles(3, 3);
  triangles << 0, 0, 0, 1, 3, 1, 2, 1, 2;  // two that share the edge 0-1 (the x axis), and the first again
  const TriangleTree tree(std::make_shared<const Part>(test::bare_part(vertices, triangles)));
  EXPECT_EQ(tree.first_crossing({0.25, 0, 1}, {0.25, 0, -3}).triangle, 0);
  EXPECT_EQ(tree.first_crossing({0.25, 0, 1}, {0.25, 0, -3}).along, 0.25);
  EXPECT_EQ(tree.first_crossing({0.25, 0.1, 1}, {0.25, 0.1, -1}).triangle, 0);
  EXPECT_EQ(tree.first_crossing({0.25, -0.1, 1}, {0.25, -0.1, -1}).triangle, 1);
  EXPECT_EQ(tree.first_crossing({0.25, 0, -1}, {0.25, 0, 1}).triangle, -1);
}

TEST(FirstCrossing, BothEndsCountAndNothingBeyond) {
  Points vertices(3, 3);
  vertices << -1, 1, 0, -1, -1, 1, 0, 0, 0;
  IndexTriples triangles(3, 1);
  triangles << 0, 1, 2;
  const TriangleTree tree(std::make_shared<const Part>(test::bare_part(vertices, triangles)));
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(tree.first_crossing({0, 0, 0}, {0, 0, -1}).along, 0);
  EXPECT_EQ(tree.first_crossing({0, 0, 1}, {0, 0, 0}).along, 1);
  EXPECT_EQ(tree.first_crossing({0, 0, 1}, {0, 0, 1e-9}).triangle, -1);
  EXPECT_EQ(tree.first_crossing({0, 0, -1e-9}, {0, 0, -1}).triangle, -1);
  EXPECT_EQ(tree.first_crossing({0, 0, 1e12}, {0, 0, -1e12}).triangle, 0);
  EXPECT_EQ(tree.first_crossing({0, 0, 1}, {0, 0, 1}).triangle, -1);
  EXPECT_EQ(tree.first_crossing({0, 0, 1}, {0, 0, nan}).triangle, -1);
  EXPECT_EQ(tree.first_crossing({0, nan, 1}, {0, 0, 0}).triangle, -1);
  EXPECT_EQ(tree.first_crossing({0, 0, unbounded}, {0, 0, -1}).triangle, -1);
}

TEST(TreeQueries, OnRealPartsAreThoseOfBruteForce) {
  const auto files = test::real_parts();
  if (files.empty()) GTEST_SKIP() << "no real parts at hand";
  for (const auto& file : files) {
    const auto part = import_part(file.string(), 1e-3, 0.5).part;
    if (!part) continue;
    const TriangleTree tree(part);
    RandomStream random(4);
    const int count = std::clamp(test::samples(1000000) / part->triangle_count(), 3, 200);
    for (int i = 0; i < count; ++i) {
      const Vec3 q = random_point(random, 1.2).cwiseProduct(part->half_extent);
      const Vec3 to = random_point(random, 1).cwiseProduct(part->half_extent);
      expect_all_within(tree, q, std::sqrt(tree.closest(q, -1, unbounded).at.distance2_m2) * (1 + i % 3));
      expect_same_crossing(tree, q, to);
      if (HasFatalFailure()) FAIL() << file;
    }
  }
}

}  // namespace
}  // namespace fingerpad::tree_queries_test
