#include "contact/triangle_tree.hpp"

#include <gtest/gtest.h>
#include <malloc.h>

#include <Eigen/Geometry>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <new>
#include <thread>

#include "base/random_stream.hpp"
#include "contact/bare_part.hpp"
#include "contact/closest_memory.hpp"
#include "contact/surface_point.hpp"
#include "contact/tree_trials.hpp"
#include "support/brute_force.hpp"
#include "support/effort.hpp"
#include "support/shapes.hpp"

namespace {
std::atomic<long> allocations{0};
}  // namespace

// Counts every allocation of this test program made through operator new.
// Not inlined: where g++ 12 inlines only one of a pair, it warns of a mismatch that is none.
[[gnu::noinline]] void* operator new(std::size_t bytes) {
  ++allocations;
  if (void* memory = std::malloc(bytes)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace fingerpad::triangle_tree_test {
namespace {

using test::bare_part;
using test::expect_same_bits;
using test::random_point;
using test::samples;
using test::soup_of_slivers;
using test::torus;

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// What the tree promises: the lowest (distance, number) of all triangles.
ClosestTriangle look_at_all(const Part& part, const Vec3& q) {
  ClosestTriangle best;
  for (int t = 0; t < part.triangle_count(); ++t) {
    const TrianglePoint p = closest_on_triangle(part, t, q);
    if (best.triangle < 0 || p.distance2_m2 < best.at.distance2_m2) best = {t, p};
  }
  return best;
}

/// Points far and near: in the box, beyond it, close to the surface, and on vertices and edges exactly.
Vec3 trial_point(const Part& part, RandomStream& random, int i) {
  const int t = static_cast<int>(random.uniform() * part.triangle_count());
  Vec3 a = part.vertices.col(part.triangles(0, t));
  const Vec3 b = part.vertices.col(part.triangles(1, t));
  switch (i % 5) {
    case 0:
      return random_point(random, 1.5);
    case 1:
      return random_point(random, 100);
    case 2:
      return a + random.uniform() * (b - a) + random_point(random, 1e-3);
    case 3:
      return a;
    default:
      return a + 0.5 * (b - a);
  }
}

TEST(TriangleTree, GivesTheAnswerOfLookingAtEveryTriangleBitForBit) {
  for (const auto& part : {torus(32, 16), torus(64, 8, 1e-4), torus(30, 20, 1e5), soup_of_slivers(1000)}) {
    const TriangleTree tree(part);
    RandomStream random(8);
    for (int i = 0; i < 1000; ++i) {
      const Vec3 q =
          trial_point(*part, random, i).cwiseProduct(i % 2 == 0 ? part->half_extent : Vec3::Ones());
      expect_same_bits(tree.closest(q, -1, unbounded), look_at_all(*part, q));
      if (HasFatalFailure()) return;
    }
  }
}

TEST(TriangleTree, DistancesAgreeWithLongDouble) {
  for (const auto& part : {torus(40, 24), torus(64, 8, 1e-4), soup_of_slivers(2000)}) {
    const TriangleTree tree(part);
    RandomStream random(9);
    for (int i = 0; i < samples(500); ++i) {
      const Vec3 q = trial_point(*part, random, i);
      const double truth_m = test::brute_closest(*part, q).distance_m;
      const ClosestTriangle found = tree.closest(q, -1, unbounded);
      // Rounding of coordinates of the size of the part and of q.
      ASSERT_NEAR(std::sqrt(found.at.distance2_m2), truth_m, 4e-15 * (part->size_m() + q.norm()));
    }
  }
}

TEST(TriangleTree, NoSeedChangesABit) {
  const auto part = torus(50, 30);
  const TriangleTree tree(part);
  RandomStream random(10);
  for (int i = 0; i < samples(3000); ++i) {
    const Vec3 q = trial_point(*part, random, i);
    const ClosestTriangle plain = tree.closest(q, -1, unbounded);
    const int any = static_cast<int>(random.uniform() * part->triangle_count());
    for (const int seed :
         {any, plain.triangle, 0, part->triangle_count(), -5, std::numeric_limits<int>::max()}) {
      expect_same_bits(tree.closest(q, seed, unbounded), plain);
      if (HasFatalFailure()) return;
    }
  }
}

TEST(TriangleTree, ThreadsAndTreesChangeNothing) {
  const auto part = torus(60, 40);
  const TriangleTree tree(part), again(part);
  const int count = samples(4000);
  const auto answer_all = [&](const TriangleTree& which, std::vector<ClosestTriangle>& answers) {
    RandomStream random(11);
    int seed = -1;
    for (int i = 0; i < count; ++i) {
      answers.push_back(which.closest(trial_point(*part, random, i), seed, unbounded));
      seed = answers.back().triangle;
    }
  };
  std::vector<ClosestTriangle> alone;
  answer_all(again, alone);
  std::vector<ClosestTriangle> shared[4];
  std::vector<std::thread> threads;
  for (auto& answers : shared) threads.emplace_back([&] { answer_all(tree, answers); });
  for (auto& thread : threads) thread.join();
  for (const auto& answers : shared) {
    for (int i = 0; i < count; ++i) expect_same_bits(answers[i], alone[i]);
  }
}

TEST(TriangleTree, TiesGoToTheLowestTriangle) {
  const auto part = torus(24, 12);
  const TriangleTree tree(part);
  for (int v = 0; v < part->vertices.cols(); ++v) {
    int lowest = part->triangle_count();
    for (int t = part->triangle_count() - 1; t >= 0; --t) {
      if ((part->triangles.col(t).array() == v).any()) lowest = t;
    }
    for (int seed = -1; seed < part->triangle_count(); seed += 7) {
      ASSERT_EQ(tree.closest(part->vertices.col(v), seed, unbounded).triangle, lowest);
    }
  }
}

TEST(TriangleTree, TiesAreTiesWhereRoundingWouldBreakThem) {
  // A flat grid turned askew, so that no coordinate is exact, with points above its vertices and edges: all
  // triangles there are equally near in exact arithmetic, and the lowest must win.
  constexpr int cells = 9;
  const Vec3 x = Vec3(0.36, 0.48, -0.8), y = Vec3(-0.8, 0.6, 0), z = x.cross(y);
  Points vertices(3, Eigen::Index{cells + 1} * (cells + 1));
  IndexTriples triangles(3, Eigen::Index{2} * cells * cells);
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; j <= cells; ++j)
      vertices.col(i * (cells + 1) + j) = (i / 7.0 - 0.6) * x + (j / 7.0 - 0.7) * y;
  }
  for (int i = 0; i < cells * cells; ++i) {
    const int a = i / cells * (cells + 1) + i % cells, b = a + cells + 1;
    triangles.col(2 * i) << a, b, b + 1;
    triangles.col(2 * i + 1) << a, b + 1, a + 1;
  }
  const TriangleTree tree(std::make_shared<const Part>(bare_part(vertices, triangles)));
  const auto lowest_with = [&](int a, int b) {
    for (int t = 0;; ++t) {
      if ((triangles.col(t).array() == a).any() && (triangles.col(t).array() == b).any()) return t;
    }
  };
  for (const double height : {0.0, 1e-9, 1e-3, 0.5, -0.3}) {
    for (int t = 0; t < triangles.cols(); ++t) {
      for (int k = 0; k < 3; ++k) {
        const int a = triangles(k, t), b = triangles((k + 1) % 3, t);
        const Vec3 at_a = vertices.col(a), middle = at_a + 0.37 * (vertices.col(b) - at_a);
        ASSERT_EQ(tree.closest(at_a + height * z, t, unbounded).triangle, lowest_with(a, a)) << height;
        ASSERT_EQ(tree.closest(middle + height * z, t, unbounded).triangle, lowest_with(a, b)) << height;
      }
    }
  }
}

TEST(TriangleTree, ReachBoundsTheSearchExactly) {
  Points vertices(3, 3);
  vertices << -1, 1, 0, -1, -1, 1, 0, 0, 0;
  IndexTriples triangles(3, 1);
  triangles << 0, 1, 2;
  const TriangleTree tree(std::make_shared<const Part>(bare_part(vertices, triangles)));
  const Vec3 q(0, 0, 0.5);
  EXPECT_EQ(tree.closest(q, -1, 0.5).triangle, 0);
  EXPECT_EQ(tree.closest(q, 0, 0.5).triangle, 0);
  EXPECT_EQ(tree.closest(q, -1, std::nextafter(0.5, 0)).triangle, -1);
  EXPECT_EQ(tree.closest(q, 0, std::nextafter(0.5, 0)).triangle, -1);
  EXPECT_EQ(tree.closest({0, 1, 0}, -1, 0).triangle, 0);
}

TEST(TriangleTree, FarAndAbsurdPointsAreAnswered) {
  const auto part = torus(20, 10);
  const TriangleTree tree(part);
  const Vec3 direction = Vec3(1, 2, -3) / 4;
  for (const double away : {1e3, 1e4, 1e5, 1e7, 1e10, 1e50, 1e160, 1e300}) {
    const Vec3 q = direction * away;
    const ClosestTriangle found = tree.closest(q, 3, unbounded);
    ASSERT_GE(found.triangle, 0) << away;
    ASSERT_TRUE(found.at.point.allFinite()) << away;
    ASSERT_FALSE(std::isnan(found.at.distance2_m2)) << away;
    // The point is one of the torus, on its far rim in that direction.
    double off_m = 0;
    const auto corner = [&](int k) -> Vec3 { return part->vertices.col(part->triangles(k, found.triangle)); };
    test::brute_closest_on(corner(0), corner(1), corner(2), found.at.point, &off_m);
    ASSERT_LE(off_m, 1e-14) << away;
    if (away < 1e150) {
      // Relative rounding of a squared distance; and beyond 2^20 sizes the direction's own error, half of
      // size^2 / 2^20 at most, which is 1e-12 of the distance.
      const double truth_m = test::brute_closest(*part, q).distance_m;
      ASSERT_NEAR(std::sqrt(found.at.distance2_m2), truth_m, 1e-12 * truth_m) << away;
    }
    ASSERT_EQ(tree.closest(q, -1, 10).triangle, -1) << away;
  }
}

TEST(TriangleTree, PointsThatAreNoNumbersAreAnsweredWithNothing) {
  const TriangleTree tree(torus(8, 6));
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(tree.closest({nan, 0, 0}, -1, unbounded).triangle, -1);
  EXPECT_EQ(tree.closest({0, 0, nan}, 2, 1.0).triangle, -1);
  EXPECT_EQ(tree.closest({unbounded, 0, 0}, -1, unbounded).triangle, -1);
  EXPECT_EQ(tree.closest({0, 0, 0}, -1, nan).triangle, -1);
}

TEST(TriangleTree, PartsOfAnySizeAreAnswered) {
  for (const double scale : {1e-30, 1e-9, 1e9, 1e30}) {
    const auto base = torus(20, 10);
    const auto part = std::make_shared<const Part>(bare_part(base->vertices * scale, base->triangles));
    const TriangleTree tree(part);
    RandomStream random(12);
    for (int i = 0; i < 200; ++i) {
      const Vec3 q = random_point(random, 2 * scale);
      expect_same_bits(tree.closest(q, -1, unbounded), look_at_all(*part, q));
      if (HasFatalFailure()) return;
    }
  }
}

TEST(TriangleTree, APartOfOnePointIsAnswered) {
  IndexTriples triangles(3, 2);
  triangles << 0, 0, 0, 0, 0, 0;
  const TriangleTree tree(std::make_shared<const Part>(bare_part(Points::Zero(3, 1), triangles)));
  EXPECT_EQ(tree.closest({3, 4, 0}, -1, unbounded).triangle, 0);
  EXPECT_EQ(tree.closest({3, 4, 0}, -1, unbounded).at.distance2_m2, 25);
  EXPECT_EQ(tree.closest({0, 0, 0}, 1, 0).triangle, 0);
}

TEST(TriangleTree, QueriesAllocateNothing) {
  const auto part = std::make_shared<const Part>(make_part(test::torus_soup(1, 0.4, 60, 40), 0.5));
  const TriangleTree tree(part);
  RandomStream random(13);
  ClosestMemory memory;
  const auto query_all = [&] {
    for (int i = 0; i < 2000; ++i) {
      const Vec3 q = trial_point(*part, random, i);
      (void)tree.closest({1.5 + 1e-4 * i, 0, 0}, memory, unbounded);
      (void)tree.closest(q, i % part->triangle_count(), unbounded);
      (void)nearest_surface_point(tree, q, Normals::smooth, i % part->triangle_count(), unbounded);
      (void)tree.first_exit(i % part->triangle_count(), q, Vec3::UnitX());
    }
  };
  query_all();  // whatever a thread sets up once is not a query's
  const long before = allocations;
  const auto heap_before = mallinfo2().uordblks;  // sees malloc too; zero under a sanitizer's own heap
  query_all();
  EXPECT_EQ(allocations, before);
  EXPECT_EQ(mallinfo2().uordblks, heap_before);
}

TEST(TriangleTree, RaysLeaveThroughTheFarWall) {
  // A slab 0.25 thick: two unit triangles facing away from each other, and one between them that faces the
  // ray.
  Points vertices(3, 9);
  vertices << 0, 1, 0, 0, 0, 1, 0, 0, 1,  //
      0, 0, 1, 0, 1, 0, 0, 1, 0,          //
      0, 0, 0, -0.25, -0.25, -0.25, -0.1, -0.1, -0.1;
  IndexTriples triangles(3, 3);
  triangles << 0, 3, 6, 1, 4, 8, 2, 5, 7;
  const TriangleTree tree(std::make_shared<const Part>(bare_part(vertices, triangles)));
  const RayExit exit = tree.first_exit(0, {0.3, 0.3, 0}, -Vec3::UnitZ());
  EXPECT_EQ(exit.triangle, 1);
  EXPECT_EQ(exit.distance_m, 0.25);
  EXPECT_EQ(tree.first_exit(0, {2, 2, 0}, -Vec3::UnitZ()).triangle, -1);
}

}  // namespace
}  // namespace fingerpad::triangle_tree_test
