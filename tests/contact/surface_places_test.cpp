#include "contact/surface_places.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <Eigen/Geometry>

#include <cmath>
#include <numbers>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "contact/part_measures.hpp"
#include "contact/triangle_tree.hpp"
#include "support/shapes.hpp"

namespace fingerpad::surface_places_test {
namespace {

PartMeasures measures_of(const TriangleSoup& soup) {
  const auto part = std::make_shared<const Part>(make_part(soup, std::numbers::pi / 6));
  return measure_part(*part, TriangleTree(part));
}

TEST(SurfacePlaces, OfABoxAreFlat) {
  const PartMeasures box = measures_of(test::box_soup({0.1, 0.2, 0.003}));
  ASSERT_EQ(box.places.size(), 12u * 64);
  for (const SurfacePlace& place : box.places) {
    EXPECT_LT(place.sag_m, 1e-15);
    EXPECT_LT(place.facet_rad + place.smooth_rad + place.patch_rad, 1e-6);
    EXPECT_EQ(place.curvature_per_m, 0);
  }
  EXPECT_EQ(box.tightest_round_m, PartMeasures::inf);
}

TEST(SurfacePlaces, OfASphereHaveItsSagAndItsRadius) {
  // A facet stands off the sphere by what its corners' distance from its middle makes: at the most where the
  // sphere over its middle is.
  const TriangleSoup soup = test::sphere_soup(0.05, 4);
  double deepest_m = 0;
  for (int t = 0; t < soup.triangles.cols(); ++t) {
    const Vec3 a = soup.vertices_P.col(soup.triangles(0, t)), b = soup.vertices_P.col(soup.triangles(1, t)),
               c = soup.vertices_P.col(soup.triangles(2, t));
    deepest_m = std::max(deepest_m, 0.05 - std::abs((b - a).cross(c - a).normalized().dot(a)));
  }
  const PartMeasures sphere = measures_of(soup);
  double sag_m = 0;
  for (const SurfacePlace& place : sphere.places) {
    sag_m = std::max(sag_m, place.sag_m);
    EXPECT_LT(place.smooth_rad, place.facet_rad / 3 + 0.01);
  }
  EXPECT_NEAR(sag_m, deepest_m, 0.02 * deepest_m);
  EXPECT_NEAR(sphere.median_round_m, 0.05, 0.01);
  EXPECT_NEAR(measures_of(test::sphere_soup(0.008, 4)).tightest_round_m, 0.008, 0.0018);
}

TEST(SurfacePlaces, OfATorusTellItsHollowFromItsRound) {
  const PartMeasures torus = measures_of(test::torus_soup(0.04, 0.01, 96, 48));
  double hollowest_per_m = 0, roundest_per_m = 0;
  for (const SurfacePlace& place : torus.places) {
    hollowest_per_m = std::min(hollowest_per_m, place.curvature_per_m);
    roundest_per_m = std::max(roundest_per_m, place.curvature_per_m);
  }
  EXPECT_NEAR(roundest_per_m, 100, 10) << "the tube";
  EXPECT_LT(hollowest_per_m, 0) << "the ring's inner side, along the ring";
  EXPECT_GT(hollowest_per_m, -1 / 0.03 * 1.1);
}

TEST(SurfacePlaces, AreTheSameOnAnyNumberOfThreads) {
  const TriangleSoup soup = test::torus_soup(0.04, 0.01, 96, 48);
  const auto many = measures_of(soup).places;
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const auto one = measures_of(soup).places;
  EXPECT_TRUE(one == many);
}

TEST(SurfacePlaces, GoRegionByRegion) {
  // Cubes of 12.5 mm: two across a rod of 20 mm each way, and eight along its 100 mm.
  const PartMeasures rod = measures_of(test::box_soup({0.02, 0.02, 0.1}));
  std::set<int> regions;
  for (std::size_t i = 0; i < rod.places.size(); ++i) {
    regions.insert(rod.places[i].region);
    EXPECT_GE(rod.places[i].region, rod.places[i == 0 ? 0 : i - 1].region);
  }
  EXPECT_EQ(regions.size(), 4u * 8);
}

/// So many places of a region, of which the first are not told.
void add_region(std::vector<SurfacePlace>& places, int region, int count, int untold) {
  for (int i = 0; i < count; ++i) {
    SurfacePlace& place = places.emplace_back();
    place.region = region;
    place.is_told = i >= untold;
  }
}

TEST(SurfacePlaces, AreTakenRegionByRegion) {
  std::vector<SurfacePlace> places;
  for (const auto& [region, count] : {std::pair(2, 3), {5, 1}, {511, 4}})
    add_region(places, region, count, 0);
  std::vector<std::pair<int, std::size_t>> taken;
  each_region(places, [&](std::span<const SurfacePlace> region) {
    for (const SurfacePlace& place : region) EXPECT_EQ(place.region, region.front().region);
    taken.emplace_back(region.front().region, region.size());
  });
  EXPECT_EQ(taken, (std::vector<std::pair<int, std::size_t>>{{2, 3}, {5, 1}, {511, 4}}));
  each_region({}, [](std::span<const SurfacePlace>) { FAIL() << "there is none"; });
}

TEST(SurfacePlaces, TellHowManyAreNotInTheWorstRegionThatIsLargeEnough) {
  std::vector<SurfacePlace> places;
  EXPECT_EQ(untold_share(places), 0);
  add_region(places, 0, 5000, 50);
  add_region(places, 1, 1000, 400);
  EXPECT_EQ(untold_share(places), 0.4);
  add_region(places, 2, 2, 2);  // of 6002: less than a two-thousandth
  EXPECT_EQ(untold_share(places), 0.4);
  add_region(places, 3, 3, 3);
  EXPECT_EQ(untold_share(places), 1);
}

TEST(SurfacePlaces, ABoxReachesTheRegionsOfItsPointsAndNoOther) {
  const Part part = make_part(test::box_soup({0.08, 0.05, 0.003}), std::numbers::pi / 6);
  const Vec3 low(-0.013, -0.001, -0.0015), high(0.011, 0.012, 0.001);
  std::set<int> theirs, reached;
  constexpr int points = 16;  // nearer to each other than regions are wide
  for (int i = 0; i <= points; ++i)
    for (int j = 0; j <= points; ++j)
      for (int k = 0; k <= points; ++k)
        theirs.insert(region_of(part, low + Vec3(i, j, k).cwiseProduct(high - low) / points));
  for (int region = 0; region < 8 * 8 * 8; ++region)
    if (reaches_region(part, low, high, region)) reached.insert(region);
  EXPECT_GT(theirs.size(), 4u);
  EXPECT_EQ(reached, theirs);
}

}  // namespace
}  // namespace fingerpad::surface_places_test
