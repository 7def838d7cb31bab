#include "device/landing_way.hpp"

#include <gtest/gtest.h>

namespace fingerpad::landing_way_test {
namespace {

constexpr double soft_m = 1e-3;

/// Down along -z, from so far over the place and so far beside it [of what a flight keeps].
LandingWay from(double over, double beside, double hurry = 0) {
  return {soft_m * Vec3(beside, 0, -over), -Vec3::UnitZ(), soft_m, hurry};
}

TEST(LandingWay, MeetsThePlaceFromOverItAndNotFromAfarOrBeside) {
  EXPECT_TRUE(from(1.5, 0).meets_place(landing_begins));
  EXPECT_TRUE(from(1.5, 1.9).meets_place(landing_begins));
  EXPECT_FALSE(from(1.5, 2.1).meets_place(landing_begins)) << "it would go down beside an edge";
  EXPECT_FALSE(from(4.1, 0).meets_place(landing_begins));
  EXPECT_FALSE(from(-0.1, 0).meets_place(landing_begins)) << "from behind";
}

TEST(LandingWay, GoesOnFromWhereItWouldNotBegin) {
  for (const LandingWay& way : {from(7.9, 0), from(1, 2.9), from(-1.9, 0)}) {
    EXPECT_FALSE(way.meets_place(landing_begins));
    EXPECT_TRUE(way.meets_place(landing_goes_on));
  }
  EXPECT_FALSE(from(8.1, 0).meets_place(landing_goes_on));
  EXPECT_FALSE(from(-2.1, 0).meets_place(landing_goes_on));
}

TEST(LandingWay, BehindAPointerThatGoesOnItBeginsFartherAsideAndLower) {
  EXPECT_FALSE(from(0, 3).meets_place(landing_begins));
  EXPECT_TRUE(from(0, 3, 1).meets_place(landing_begins));
  EXPECT_FALSE(from(-1, 0).meets_place(landing_begins));
  EXPECT_TRUE(from(-1, 0, 1).meets_place(landing_begins));
}

TEST(LandingWay, IsInFrontUntilItIsFarBehind) {
  EXPECT_TRUE(from(100, 0).is_in_front());
  EXPECT_TRUE(from(-1.9, 0).is_in_front());
  EXPECT_FALSE(from(-2.1, 0).is_in_front());
}

TEST(LandingWay, LeadsThroughThePlaceFromAboveItAndElseToIt) {
  for (const double over : {2.0, 0.0, -1.0})
    EXPECT_LT((from(over, 0).unit_W() + Vec3::UnitZ()).norm(), 1e-12) << over;
  const LandingWay aside = from(1, 1);
  EXPECT_LT((aside.unit_W() - aside.there_W.normalized()).norm(), 1e-12);
  EXPECT_LT((from(0, 1).unit_W() - Vec3::UnitX()).norm(), 1e-12) << "level with it: along the surface";
  EXPECT_LT((from(-1, 1).unit_W() - Vec3::UnitX()).norm(), 1e-12) << "never back up";
}

TEST(LandingWay, BehindAPointerThatGoesOnItComesDownSteeply) {
  double last = 0;
  for (const double hurry : {0.0, 0.25, 0.5}) {
    const Vec3 way_W = from(0.5, 3, hurry).unit_W();
    EXPECT_NEAR(way_W.norm(), 1, 1e-12);
    EXPECT_GT(-way_W.z(), last) << hurry;
    last = -way_W.z();
  }
}

}  // namespace
}  // namespace fingerpad::landing_way_test
