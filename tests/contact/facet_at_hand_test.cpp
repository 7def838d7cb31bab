#include "contact/facet_at_hand.hpp"

#include <gtest/gtest.h>

#include "base/random_stream.hpp"
#include "contact/placed_soup.hpp"
#include "contact/surface_point.hpp"
#include "support/shapes.hpp"

namespace fingerpad::facet_at_hand_test {
namespace {

using test::placed;

TEST(FacetAtHand, FindsTheFootThatIsLookedUpOtherwise) {
  const PlacedSurface torus = placed(test::torus_soup(1, 0.4, 24, 16));
  const PlacedSurface sphere = placed(test::sphere_soup(1, 2));
  RandomStream random(3);
  FacetAtHand facet;
  int found = 0, beside = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    // From part to part too: what is at hand is of one surface.
    const PlacedSurface& surface = trial / 16 % 2 == 0 ? torus : sphere;
    const Part& part = *surface.part;
    const int t = trial / 8 % part.triangle_count();
    const Vec3 corner = part.centre_P + part.vertices.col(part.triangles(trial % 3, t));
    const Vec3 p_P = corner + 0.2 * Vec3(random.normal(), random.normal(), random.normal());
    Vec3 foot_W;
    facet.take(surface, t);
    const bool is_found = facet.find_foot(surface.R_WP * p_P + surface.p_WP, foot_W);
    const FacetFoot foot = foot_on_facet(part, t, p_P);
    ASSERT_EQ(is_found, foot.triangle == t) << trial;
    ++(is_found ? found : beside);
    // A few roundings of lengths near 1.
    if (is_found) {
      ASSERT_LT((surface.R_WP * foot.point_P + surface.p_WP - foot_W).norm(), 1e-14);
    }
  }
  EXPECT_GT(std::min(found, beside), 2000);
}

TEST(FacetAtHand, HasNoFootBeforeOneIsTaken) {
  const FacetAtHand facet;
  Vec3 foot_W;
  EXPECT_FALSE(facet.find_foot(Vec3(0.1, 0.1, 0.1), foot_W));
}

}  // namespace
}  // namespace fingerpad::facet_at_hand_test
