#include "contact/reckoned_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "contact/contact_method_table.hpp"
#include "contact/surface_places.hpp"

namespace fingerpad::reckoned_error_test {
namespace {

const ContactMethodEntry& method(const char* name) {
  return *find_contact_method(name);
}

/// 1 N is felt at the least, 10 N at the most, by a point at 1000 N/m.
const Press press{1000, 0, 10};

double share(const SurfacePlace& place, const Press& how, const char* name, Normals normals) {
  const std::vector<SurfacePlace> places(100, place);
  return reckoned_error(places, how, method(name), normals).force_share;
}

TEST(ReckonedError, OfFlatFacesIsNone) {
  EXPECT_EQ(share({}, press, "proxy", Normals::facet), 0);
  EXPECT_EQ(reckoned_error({}, press, method("proxy"), Normals::facet).force_share, 0) << "no place at all";
}

TEST(ReckonedError, OfSagIsFeltTheMostByTheLightestTouch) {
  SurfacePlace place;
  place.sag_m = 5e-5;
  EXPECT_NEAR(share(place, press, "proxy", Normals::facet), 0.05, 1e-12) << "0.05 N of 1 N";
  EXPECT_NEAR(share(place, {2000, 0, 10}, "proxy", Normals::facet), 0.1, 1e-12);
  EXPECT_NEAR(share(place, {1000, 0, 20}, "proxy", Normals::facet), 0.025, 1e-12);
  EXPECT_EQ(share(place, press, "closest-point", Normals::curved), 0) << "the patch itself is touched";
  EXPECT_NEAR(share(place, press, "proxy", Normals::curved), 0.05, 1e-12) << "a proxy stands on the facet";
}

TEST(ReckonedError, OfNormalsIsTheirTiltAndThatOfTheFoot) {
  SurfacePlace place;
  place.facet_rad = 0.04;
  place.smooth_rad = 0.01;
  place.curvature_per_m = 20;  // a rounding of 50 mm; 10 mm deep u = -0.2
  EXPECT_NEAR(share(place, press, "closest-point", Normals::facet), 0.04, 1e-12) << "whatever the depth";
  EXPECT_NEAR(share(place, press, "proxy", Normals::facet), 0.04 / 0.8, 1e-12) << "it leaves the facet late";
  EXPECT_NEAR(share(place, press, "closest-point", Normals::smooth), 0.01 + 0.2 * 0.04, 1e-12);
  EXPECT_NEAR(share(place, press, "proxy", Normals::curved), 0.2 * 0.04, 1e-12);
  place.across_per_m = 20;
  EXPECT_NEAR(share(place, press, "proxy", Normals::curved), 0.2 / 0.8 * 0.04, 1e-12)
      << "inside what is round both ways no edge of a facet holds a proxy's foot";
  EXPECT_NEAR(share(place, press, "closest-point", Normals::smooth), 0.01 + 0.2 * 0.04, 1e-12);
  // A ball of 12 mm: its centre is 11 mm over the surface at 1 N, u = 0.22.
  const Press ball{1000, 0.012, 10};
  EXPECT_NEAR(share(place, ball, "proxy", Normals::curved), 0.04 * 0.22 / 1.22, 1e-12);
}

TEST(ReckonedError, OfAPatchIsWhatItsOwnNormalTurnsTheFootBy) {
  SurfacePlace place;
  place.patch_rad = 0.01;
  EXPECT_NEAR(share(place, press, "closest-point", Normals::curved), 0.0125, 1e-12);
  place.curvature_per_m = 80;  // a rounding of 12.5 mm; 10 mm deep the foot turns by four times as much
  EXPECT_NEAR(share(place, press, "closest-point", Normals::curved), 0.0625, 1e-12);
}

TEST(ReckonedError, OfAnyNormalsIsHowFarThePatchesThatTheyAreHeldAgainstDoNotFitTheirs) {
  SurfacePlace place;
  place.patch_rad = 0.02;
  EXPECT_NEAR(share(place, press, "proxy", Normals::curved), 0.95 * 0.02, 1e-12);
  place.smooth_rad = 0.01;
  EXPECT_NEAR(share(place, press, "proxy", Normals::smooth), 0.01 + 1.05 * 0.02, 1e-12);
  place.facet_rad = 0.05;
  EXPECT_NEAR(share(place, press, "closest-point", Normals::facet), 0.05 + 1.05 * 0.02, 1e-12);
}

TEST(ReckonedError, OfRoundedCoordinatesIsFeltTheMostByTheLightestTouch) {
  EXPECT_NEAR(rounding_share(press, 5e-5), 0.05, 1e-12) << "0.05 N of 1 N";
  EXPECT_EQ(rounding_share(press, 5e-6), 0) << "a two-hundredth, which nobody feels";
  ReckonedError error;
  add_rounding(error, press, 5e-5);
  EXPECT_NEAR(error.force_share, 0.05, 1e-12);
  EXPECT_NEAR(error.force_shares.front(), 0.05, 1e-12);
  EXPECT_NEAR(error.force_shares.back(), 0.005, 1e-12);
}

TEST(ReckonedError, IsToldUnderEachForce) {
  SurfacePlace light, deep;
  light.sag_m = 5e-5;
  light.region = 1;
  deep.facet_rad = 0.03;
  deep.region = 2;
  std::vector<SurfacePlace> places(100, light);
  places.insert(places.end(), 100, deep);
  const ReckonedError error = reckoned_error(places, press, method("closest-point"), Normals::facet);
  EXPECT_NEAR(error.force_shares.front(), 0.05, 1e-12) << "1 N, where the facets cut in";
  EXPECT_NEAR(error.force_shares.back(), 0.03, 1e-12) << "10 N, where they are turned";
  EXPECT_NEAR(error.mean_tilts_rad.back(), 0.03, 1e-12);
}

TEST(ReckonedError, OfFacetsUnderAProxyDeepInARoundingIsTheWholeForce) {
  SurfacePlace place;
  place.facet_rad = 0.001;
  place.curvature_per_m = 80;  // 10 mm deep: u = -0.8
  EXPECT_EQ(share(place, press, "proxy", Normals::facet), 2);
  place.curvature_per_m = 70;
  EXPECT_LT(share(place, press, "proxy", Normals::facet), 0.004) << "up to three quarters deep it keeps up";
  EXPECT_LT(share(place, press, "closest-point", Normals::facet), 0.002);
}

TEST(ReckonedError, CountsPlacesByTheWayThatAFingerHasThere) {
  SurfacePlace flat, edge;
  edge.sag_m = 1e-3;
  edge.curvature_per_m = 2000;  // a rounding of half a millimetre, tighter than 1 N is deep
  std::vector<SurfacePlace> places(90, flat);
  places.insert(places.end(), 10, edge);
  EXPECT_EQ(reckoned_error(places, press, method("proxy"), Normals::facet).force_share, 0)
      << "a point slides off there at once";
  for (SurfacePlace& place : places) place.curvature_per_m = -place.curvature_per_m;
  EXPECT_GT(reckoned_error(places, press, method("proxy"), Normals::curved).force_share, 0.9)
      << "and dwells in a groove";
  EXPECT_EQ(reckoned_error(places, {1000, 0.02, 10}, method("proxy"), Normals::curved).force_share, 0)
      << "where a ball cannot get";
  EXPECT_EQ(reckoned_error(places, {1000, 0.002, 10}, method("proxy"), Normals::curved).force_share, 0)
      << "not even one that is pressed deeper than its radius";
}

TEST(ReckonedError, LeavesAHundredthToItself) {
  SurfacePlace flat, bad;
  bad.sag_m = 1e-3;
  std::vector<SurfacePlace> places(1000, flat);
  std::fill_n(places.begin(), 9, bad);
  EXPECT_EQ(reckoned_error(places, press, method("proxy"), Normals::facet).force_share, 0);
  std::fill_n(places.begin(), 11, bad);
  EXPECT_NEAR(reckoned_error(places, press, method("proxy"), Normals::facet).force_share, 1, 1e-12);
}

TEST(ReckonedError, IsThatOfTheWorstRegionForAFingerThatStaysThere) {
  SurfacePlace flat, bad;
  bad.sag_m = 1e-3;
  bad.facet_rad = 0.01;
  bad.region = 7;
  std::vector<SurfacePlace> places(10000, flat);
  places.insert(places.end(), 20, bad);
  const ReckonedError error = reckoned_error(places, press, method("proxy"), Normals::facet);
  EXPECT_NEAR(error.force_share, 1, 1e-4) << "a five-hundredth of the part";
  EXPECT_NEAR(error.mean_tilt_rad, 0.01, 1e-12);
  places.resize(10004);
  EXPECT_EQ(reckoned_error(places, press, method("proxy"), Normals::facet).force_share, 0)
      << "too few to judge by";
}

TEST(ReckonedError, OfABallInAHollowThatItNearlyFitsIsLarger) {
  SurfacePlace place;
  place.smooth_rad = 0.01;
  place.curvature_per_m = -100;  // a hollow of 10 mm
  const double loose = share(place, {1000, 0.005, 10}, "proxy", Normals::smooth);
  EXPECT_NEAR(loose, 0.01, 1e-12) << "half its radius: no larger than under a point";
  // The more the lighter it is pressed: at 1 N the ball's centre is 0.1 + 1 mm from the hollow's middle.
  EXPECT_NEAR(share(place, {1000, 0.0099, 10}, "proxy", Normals::smooth), 0.01 * std::sqrt(0.25 / 0.11),
              1e-9);
  EXPECT_NEAR(share(place, {1000, 0.0099, 10}, "closest-point", Normals::smooth),
              0.01 * std::sqrt(0.5 / 0.11), 1e-9)
      << "which no second facet holds";
}

TEST(ReckonedError, CountsNoHollowInWhichABallHasNoRoomBetweenTheFacets) {
  SurfacePlace bore;
  bore.facet_rad = bore.smooth_rad = 0.03;
  bore.sag_m = 5e-6;
  bore.curvature_per_m = -1 / 0.007004;
  EXPECT_EQ(share(bore, {1000, 0.007, 10}, "proxy", Normals::smooth), 0);
  bore.sag_m = 3e-6;
  EXPECT_GT(share(bore, {1000, 0.007, 10}, "proxy", Normals::smooth), 0.03);
}

TEST(ReckonedError, TellsByHowMuchAProxyFallsBehindInARounding) {
  SurfacePlace place;
  place.curvature_per_m = 1 / 0.005;
  const auto error = [&place](const Press& press, const char* name) {
    const std::vector<SurfacePlace> places(100, place);
    return reckoned_error(places, press, method(name), Normals::smooth);
  };
  // Of a rim of 5 mm under a ball of 7: at 9.5 N the proxy has 12/2.5 of the finger's way to go, and may go
  // four times as far; 0.37 of the force were measured there over a quarter turn, 0.67 at 10 N (12/2), on a
  // line of vertices of a tube.
  EXPECT_NEAR(error({1000, 0.007, 9.5}, "proxy").behind_share, 0.37, 0.06);
  EXPECT_NEAR(error({1000, 0.007, 10}, "proxy").behind_share, 0.67, 0.06);
  EXPECT_NEAR(error({1000, 0.007, 10}, "proxy").behind_m, 0.005, 1e-12);
  EXPECT_EQ(error({1000, 0.007, 8.9}, "proxy").behind_share, 0);
  EXPECT_EQ(error({1000, 0.007, 10}, "closest-point").behind_share, 0);
  // So is a point, however fine the facets are that it goes round.
  EXPECT_EQ(error({1000, 0, 3.7}, "proxy").behind_share, 0);
  EXPECT_GT(error({1000, 0, 4}, "proxy").behind_share, 0.3);
  EXPECT_EQ(error({1000, 0, 4}, "closest-point").behind_share, 0);
}

}  // namespace
}  // namespace fingerpad::reckoned_error_test
