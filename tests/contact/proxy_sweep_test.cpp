#include "contact/proxy_sweep.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/random_stream.hpp"
#include "support/brute_force.hpp"

namespace fingerpad::proxy_sweep_test {
namespace {

Part random_triangle(RandomStream& random, double flatness) {
  TriangleSoup soup;
  soup.vertices_P.resize(3, 3);
  for (int k = 0; k < 3; ++k)
    soup.vertices_P.col(k) = Vec3(random.normal(), flatness * random.normal(), random.normal());
  soup.triangles.resize(3, 1);
  soup.triangles.col(0) << 0, 1, 2;
  return make_part(soup, 0.5);
}

double brute_distance_m(const Part& part, const Vec3& q) {
  return test::brute_closest(part, q).distance_m;
}

TEST(ProxySweep, ApproachIsTheBruteForceDistance) {
  RandomStream random(5);
  for (int trial = 0; trial < 4000; ++trial) {
    const Part part = random_triangle(random, trial % 4 == 0 ? 1e-7 : 1);
    const Vec3 q(random.normal(), random.normal(), random.normal());
    const TriangleApproach approach = approach_triangle(part, 0, q);
    // Rounding of numbers of size 5, ten operations deep.
    ASSERT_NEAR(approach.distance_m, brute_distance_m(part, q), 1e-14);
    ASSERT_LT((approach.at.point + approach.distance_m * approach.towards - q).norm(), 1e-14);
  }
}

TEST(ProxySweep, SaysFreeOrShowsAWallAndNeverPassesTheTouch) {
  RandomStream random(6);
  int blocked = 0, free = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const Part part = random_triangle(random, trial % 4 == 0 ? 1e-4 : 1);
    const double clearance_m = std::pow(10, -8 * random.uniform()), tolerance_m = 1e-3 * clearance_m;
    const Vec3 from(random.normal(), random.normal(), random.normal());
    const Vec3 to(random.normal(), random.normal(), random.normal());
    if (brute_distance_m(part, from) < clearance_m) continue;
    const TriangleSweep sweep = sweep_past_triangle(corners_of(part, 0), from, to, clearance_m, tolerance_m,
                                                    FirstApproach(approach_triangle(part, 0, from)),
                                                    std::numeric_limits<double>::infinity());
    ++(sweep.blocked ? blocked : free);
    // Rounding of 1e-14 aside, wherever the sweep says free there is the clearance.
    for (int k = 0; k <= 100; ++k) {
      const Vec3 y = from + (sweep.free_share * k / 100.0) * (to - from);
      ASSERT_GE(brute_distance_m(part, y), clearance_m - tolerance_m - 1e-14) << trial;
    }
    if (!sweep.blocked) continue;
    ASSERT_GE(sweep.normal.dot(from), sweep.offset_m - tolerance_m - 1e-14) << "the start is in front";
    ASSERT_LT(sweep.normal.dot(to), sweep.offset_m);
    for (int k = 0; k < 3; ++k) {
      // The triangle stands a clearance behind its wall: a normal from a distance of 1e-8 is known to 1e-7.
      ASSERT_LE(sweep.normal.dot(part.vertices.col(k)), sweep.offset_m - clearance_m + 4e-15 / clearance_m)
          << trial;
    }
  }
  EXPECT_GT(blocked, 300);
  EXPECT_GT(free, 300);
}

}  // namespace
}  // namespace fingerpad::proxy_sweep_test
