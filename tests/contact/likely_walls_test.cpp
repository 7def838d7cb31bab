#include "contact/likely_walls.hpp"

#include <gtest/gtest.h>

#include "base/random_stream.hpp"
#include "contact/tree_trials.hpp"
#include "support/effort.hpp"
#include "support/shapes.hpp"

namespace fingerpad::likely_walls_test {
namespace {

constexpr double radius_m = 6e-3;

class Likely {
 public:
  explicit Likely(const TriangleSoup& soup)
      : sight_(ProxyWorld({surface_of(soup)}, radius_m, Normals::facet)),
        looks_(Looks::unlimited),
        walls_(sight_.world(), looks_) {}

  std::span<const ProxyWall> found(const Vec3& place_O, const Vec3& goal_O) {
    walls_.forget();
    walls_.find(place_O, goal_O, (goal_O - place_O).norm(), {});
    return walls_.found();
  }

  /// By every triangle, each looked at anew.
  bool is_free(const Vec3& place_O, const Vec3& goal_O) {
    ProxyState state;
    state.place_O = place_O;
    state.goal_O = goal_O;
    return sight_.step(state, {2 * (goal_O - place_O).norm()}).wall_count == 0;
  }

  double gap_m(const Vec3& place_O) const {
    double least_m = std::numeric_limits<double>::infinity();
    for (int t = 0; t < sight_.world().part(0).triangle_count(); ++t)
      least_m = std::min(least_m, sight_.world().approach(0, t, place_O).distance_m);
    return least_m - sight_.world().clearance_m();
  }

 private:
  ProxySight sight_;
  Looks looks_;
  LikelyWalls walls_;
};

TEST(LikelyWalls, AreThoseOnTheWaysSideOfAPlate) {
  Likely plate(test::box_soup(Vec3(0.06, 0.06, 4e-4)));
  for (const double side : {1.0, -1.0}) {
    const auto walls = plate.found(Vec3(0.01, 0.02, side * 0.03), Vec3(0.012, 0.018, side * 0.003));
    ASSERT_EQ(walls.size(), 1U);
    EXPECT_GT(side * walls[0].normal.z(), 0.999);
  }
}

// From beyond the rim to below: the facet above the finger is in front of where the way begins, but not in
// it.
TEST(LikelyWalls, AreNoneWhereTheWayGoesPastThePlate) {
  Likely plate(test::box_soup(Vec3(0.06, 0.06, 4e-4)));
  const Vec3 beyond(0.2, 0, 0.03), below(0.0116, 0.0183, -0.03);
  ASSERT_TRUE(plate.is_free(beyond, below));
  EXPECT_TRUE(plate.found(beyond, below).empty());
}

TEST(LikelyWalls, AreNoneWhereTheWayIsFree) {
  for (const TriangleSoup& soup :
       {test::box_soup(Vec3(0.06, 0.06, 4e-4)), test::box_soup(Vec3(0.02, 0.01, 0.04)),
        test::torus_soup(0.02, 0.006, 48, 24)}) {
    Likely likely(soup);
    RandomStream random(7);
    const auto any_m = [&random] { return 0.08 * (2 * random.uniform() - 1); };
    int free = 0, held = 0;
    for (int k = 0; k < test::samples(2000); ++k) {
      const Vec3 from(any_m(), any_m(), any_m()), to(any_m(), any_m(), any_m());
      if (!(likely.gap_m(from) > 0)) continue;
      const bool is_free = likely.is_free(from, to), is_found = !likely.found(from, to).empty();
      ASSERT_FALSE(is_free && is_found) << from.transpose() << " to " << to.transpose();
      free += is_free ? 1 : 0;
      held += is_found ? 1 : 0;
    }
    EXPECT_GT(free, test::samples(200));
    EXPECT_GT(held, test::samples(50));
  }
}

}  // namespace
}  // namespace fingerpad::likely_walls_test
