#include "part/random_places.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>
#include <vector>

#include "support/shapes.hpp"

namespace fingerpad::random_places_test {
namespace {

/// A sheet whose cells get narrower and narrower along it: areas from one to a thousandth of that.
Part uneven_sheet() {
  return make_part(test::sheet_soup(40, 7, [](double u, double v) { return Vec3(u * u * u, v * v, 0); }),
                   std::numbers::pi / 6);
}

TEST(RandomPlaces, DrawsTheTriangleWhoseAreaTheDrawnShareFallsInto) {
  const Part part = uneven_sheet();
  const RandomPlaces places(part);
  std::vector<double> sums{0};
  for (int t = 0; t < part.triangle_count(); ++t) {
    const Vec3 a = part.vertices.col(part.triangles(0, t));
    const Vec3 b = part.vertices.col(part.triangles(1, t)), c = part.vertices.col(part.triangles(2, t));
    sums.push_back(sums.back() + (b - a).cross(c - a).norm());
  }
  RandomStream random(7), same(7);
  for (int i = 0; i < 20000; ++i) {
    const auto t = static_cast<std::size_t>(places.triangle(random));
    const double drawn = same.uniform() * sums.back();
    ASSERT_LE(sums[t], drawn) << i;
    ASSERT_GT(sums[t + 1], drawn) << i;
  }
}

TEST(RandomPlaces, PassingAPointDrawsWhatThePointWould) {
  const Part part = uneven_sheet();
  const RandomPlaces places(part);
  RandomStream random(7), same(7);
  places.point(0, Vec3::Zero(), random);
  RandomPlaces::pass_point(same);
  EXPECT_EQ(random.bits(), same.bits());
}

}  // namespace
}  // namespace fingerpad::random_places_test
