#include "contact/facets_at_hand.hpp"

#include <gtest/gtest.h>

#include "base/random_stream.hpp"
#include "contact/placed_soup.hpp"
#include "contact/surface_point.hpp"
#include "support/shapes.hpp"

namespace fingerpad::facets_at_hand_test {
namespace {

using test::placed;

Vec3 middle_of(const Part& part, int t) {
  Vec3 sum = Vec3::Zero();
  for (int k = 0; k < 3; ++k) sum += part.vertices.col(part.triangles(k, t));
  return part.centre_P + sum / 3;
}

/// How the feet of points that lag behind a contact going from facet to facet compare with foot_on_facet's.
struct Feet {
  int found = 0, missed = 0, other = 0;
};

Feet follow(const PlacedSurface& surface, double lag_m) {
  const Part& part = *surface.part;
  RandomStream random(5);
  FacetsAtHand facets;
  Feet feet;
  int t = 0;
  for (int step = 0; step < 5000; ++step) {
    const int next = part.neighbours(std::min(2, static_cast<int>(3 * random.uniform())), t);
    if (next >= 0) t = next;
    for (int tick = 0; tick < 4; ++tick) {
      const Vec3 p_P = middle_of(part, t) + lag_m * Vec3(random.normal(), random.normal(), random.normal());
      const FacetFoot expected = foot_on_facet(part, t, p_P);
      Vec3 foot_W;
      const bool is_found = facets.find_foot(surface, t, surface.R_WP * p_P + surface.p_WP, foot_W);
      if (expected.triangle >= 0 && !is_found) ++feet.missed;
      if (!is_found) continue;
      ++feet.found;
      // A few roundings of lengths near 1.
      if (expected.triangle < 0 || (surface.R_WP * expected.point_P + surface.p_WP - foot_W).norm() > 1e-13)
        ++feet.other;
    }
  }
  return feet;
}

TEST(FacetsAtHand, FindTheFeetThatAreLookedUpOtherwise) {
  // In one plane there is one foot, on whichever triangle.
  const Feet flat = follow(placed(test::square_soup(1, 12)), 0.05);
  EXPECT_EQ(flat.missed, 0);
  EXPECT_EQ(flat.other, 0);
  EXPECT_GT(flat.found, 10000);
  // Beside a bent edge's both facets, one of which is at hand, there may be two.
  const Feet bent = follow(placed(test::torus_soup(1, 0.4, 24, 16)), 0.05);
  EXPECT_EQ(bent.missed, 0);
  EXPECT_LT(bent.other, bent.found / 50);
  EXPECT_GT(bent.found, 10000);
}

TEST(FacetsAtHand, AreOfTheSurfaceThatIsAskedFor) {
  const PlacedSurface low = placed(test::square_soup(1, 2));
  PlacedSurface high = low;
  high.p_WP.z() += 1;
  FacetsAtHand facets;
  for (int trial = 0; trial < 4; ++trial) {
    const PlacedSurface& surface = trial % 2 == 0 ? low : high;
    const Vec3 middle_P = middle_of(*surface.part, trial / 2);
    Vec3 foot_W;
    ASSERT_TRUE(facets.find_foot(surface, trial / 2, surface.R_WP * middle_P + surface.p_WP, foot_W));
    EXPECT_LT((foot_W - surface.R_WP * middle_P - surface.p_WP).norm(), 1e-15);
  }
}

}  // namespace
}  // namespace fingerpad::facets_at_hand_test
