// Every query of the tree with every kind of number that a double can be: Debian's Embree asserts on a ray
// that is no float, so a failure here may end the whole program.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "base/random_stream.hpp"
#include "contact/closest_memory.hpp"
#include "contact/surface_point.hpp"
#include "contact/tree_trials.hpp"
#include "contact/triangle_tree.hpp"
#include "support/effort.hpp"
#include "support/shapes.hpp"

namespace fingerpad::hostile_points_test {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

/// A number that something somewhere may take badly, or an ordinary one.
double hostile_number(RandomStream& random, double extent_m) {
  static const double kinds[] = {0,
                                 5e-324,
                                 1e-310,
                                 1e-300,
                                 1e-170,
                                 1e-40,
                                 1e-9,
                                 1e-3,
                                 0.3,
                                 0.999,
                                 1,
                                 1.5,
                                 1e3,
                                 1e4,
                                 1e6,
                                 1e8,
                                 1e9,
                                 1e15,
                                 1.8e18,
                                 1.9e18,
                                 1e19,
                                 1e35,
                                 3e38,
                                 4e38,
                                 1e60,
                                 1e103,
                                 1e154,
                                 1e200,
                                 1e300,
                                 1e308,
                                 std::numeric_limits<double>::max(),
                                 inf,
                                 std::nan("")};
  const double magnitude = kinds[static_cast<std::size_t>(random.uniform() * std::size(kinds))];
  const double sign = random.uniform() < 0.5 ? -1 : 1;
  return sign * magnitude * (random.uniform() < 0.5 ? extent_m : 1);
}

/// All three coordinates alike in size, one alone, or each for itself; now and then on the part.
Vec3 hostile_point(RandomStream& random, double extent_m) {
  const double which = random.uniform();
  const Vec3 near = test::random_point(random, extent_m);
  if (which < 0.1) return near;
  if (which < 0.4) return near / extent_m * hostile_number(random, extent_m);
  Vec3 p = which < 0.7 ? near : Vec3::Zero().eval();
  for (int i = 0; i < 3; ++i) {
    if (which > 0.7 || random.uniform() < 0.4) p[i] = hostile_number(random, extent_m);
  }
  return p;
}

bool is_triangle(const Part& part, int t) {
  return t >= 0 && t < part.triangle_count();
}

void expect_sound_closest(const TriangleTree& tree, const Vec3& q, double reach_m,
                          const ClosestTriangle& found) {
  if (found.triangle < 0) {
    // Nothing is an answer only where there is something to be missed.
    EXPECT_TRUE(!q.allFinite() || !(reach_m == inf)) << q.transpose() << " reach " << reach_m;
    return;
  }
  const Part& part = tree.part();
  ASSERT_TRUE(q.allFinite());
  ASSERT_TRUE(is_triangle(part, found.triangle));
  ASSERT_TRUE(found.at.point.allFinite()) << q.transpose();
  ASSERT_TRUE(found.at.barycentric.allFinite()) << q.transpose();
  ASSERT_FALSE(std::isnan(found.at.distance2_m2)) << q.transpose();
  // A corner's coordinates are off by rounding alone.
  ASSERT_LE((found.at.point.cwiseAbs() - part.half_extent).maxCoeff(), 1e-9 * part.half_extent.maxCoeff());
}

void expect_sound_surface(const SurfacePoint& found) {
  if (found.triangle < 0) return;
  EXPECT_TRUE(std::isfinite(found.signed_distance_m));
  EXPECT_TRUE(found.point_P.allFinite());
  EXPECT_NEAR(found.normal_P.norm(), 1, 1e-9);  // rounding of a unit vector
  EXPECT_NEAR(found.pseudonormal_P.norm(), 1, 1e-9);
}

class HostilePoints : public testing::TestWithParam<int> {
 protected:
  HostilePoints() : tree_(part_of(GetParam())), extent_m_(tree_.part().half_extent.maxCoeff()) {
    tree_.prepare_curved();
  }

  static std::shared_ptr<const Part> part_of(int number) {
    TriangleSoup soup = test::sphere_soup(1, 3);
    if (number == 1) soup = test::box_soup({1, 1, 1e-6});
    if (number == 2) soup = test::square_soup(1e-3, 4);
    if (number == 3) soup.vertices_P *= 1e-44;  // the smallest a float can hold, more or less
    if (number == 4) soup.vertices_P *= 1e36;   // and the largest
    if (number == 5) soup = test::moved(soup, {1e9, -1e9, 1e9});
    return std::make_shared<const Part>(make_part(soup, 0.5));
  }

  Vec3 point() { return hostile_point(random_, extent_m_); }
  double number() { return hostile_number(random_, extent_m_); }

  TriangleTree tree_;
  double extent_m_;
  RandomStream random_{11};
};

const int rounds = test::samples(20000);

TEST_P(HostilePoints, ClosestIsSound) {
  ClosestMemory memory;
  for (int i = 0; i < rounds; ++i) {
    const Vec3 q = point();
    const double reach_m = i % 3 == 0 ? number() : inf;
    expect_sound_closest(tree_, q, reach_m, tree_.closest(q, i % 12 - 2, reach_m));
    expect_sound_closest(tree_, q, reach_m, tree_.closest(q, memory, reach_m));
    if (HasFatalFailure()) return;
  }
}

TEST_P(HostilePoints, EachWithinIsSound) {
  struct Found {
    const Part& part;
    std::vector<bool> seen;
    int count = 0;
  };
  const Part& part = tree_.part();
  const auto add = [](void* context, int t) {
    Found& found = *static_cast<Found*>(context);
    ASSERT_TRUE(is_triangle(found.part, t));
    ASSERT_FALSE(found.seen[static_cast<std::size_t>(t)]);
    found.seen[static_cast<std::size_t>(t)] = true;
    ++found.count;
  };
  for (int i = 0; i < rounds / 10; ++i) {
    const Vec3 q = point();
    const double reach_m = i % 2 == 0 ? number() : inf;
    Found found{part, std::vector<bool>(static_cast<std::size_t>(part.triangle_count())), 0};
    tree_.each_within(q, reach_m, add, &found);
    if (reach_m < inf) continue;
    ASSERT_EQ(found.count, q.allFinite() && reach_m == inf ? part.triangle_count() : 0) << q.transpose();
  }
}

TEST_P(HostilePoints, FirstCrossingIsSound) {
  for (int i = 0; i < rounds; ++i) {
    const Vec3 from = point(), to = i % 5 == 0 ? Vec3(-from) : point();
    const SegmentHit hit = tree_.first_crossing(from, to);
    if (hit.triangle < 0) continue;
    ASSERT_TRUE(is_triangle(tree_.part(), hit.triangle)) << from.transpose() << " -> " << to.transpose();
    ASSERT_TRUE(hit.along >= 0 && hit.along <= 1) << from.transpose() << " -> " << to.transpose();
  }
}

TEST_P(HostilePoints, FirstExitIsSound) {
  for (int i = 0; i < rounds; ++i) {
    const Vec3 from = point();
    const Vec3 direction = i % 2 == 0 ? point() : test::random_point(random_, 1).normalized().eval();
    const RayExit exit = tree_.first_exit(i % tree_.part().triangle_count(), from, direction);
    if (exit.triangle < 0) continue;
    ASSERT_TRUE(is_triangle(tree_.part(), exit.triangle));
    ASSERT_TRUE(exit.distance_m >= 0 && std::isfinite(exit.distance_m)) << from.transpose();
  }
}

TEST_P(HostilePoints, NothingEnclosesAPointThatIsNowhereNear) {
  for (int i = 0; i < rounds; ++i) {
    const Vec3 q = point();
    const bool beyond = !((q.cwiseAbs() - tree_.part().half_extent).maxCoeff() <= 0.01 * extent_m_);
    ASSERT_FALSE(beyond && tree_.encloses(q)) << q.transpose();
  }
}

TEST_P(HostilePoints, SurfacePointsAreSound) {
  for (const Normals normals : normals_table()) {
    for (int i = 0; i < rounds / 4; ++i) {
      expect_sound_surface(nearest_surface_point(tree_, point(), normals, -1, i % 2 == 0 ? inf : number()));
      if (HasFailure()) return;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Parts, HostilePoints, testing::Range(0, 6));

/// A finger that comes from far away crosses what stands in its way, whichever way a double holds it.
TEST(HostilePoints, AFarSegmentStraightThroughAPartCrossesIt) {
  const TriangleTree tree(std::make_shared<const Part>(make_part(test::box_soup({2, 2, 2}), 0.5)));
  for (const double far : {1e3, 1e7, 1e9, 1e12, 1e18, 1e25, 1e35, 1e100, 1e300, 1.7e308}) {
    const SegmentHit hit = tree.first_crossing({0.3, 0.2, far}, {0.3, 0.2, -far});
    ASSERT_GE(hit.triangle, 0) << far;
    EXPECT_GT(tree.part().facet_normals.col(hit.triangle).z(), 0.5) << far;
    EXPECT_NEAR(hit.along, 0.5 - 0.5 / far, 1e-9) << far;  // a double of the whole segment's length
    EXPECT_LT(tree.first_crossing({0.3, 5, far}, {0.3, 5, -far}).triangle, 0) << far;
  }
}

}  // namespace
}  // namespace fingerpad::hostile_points_test
