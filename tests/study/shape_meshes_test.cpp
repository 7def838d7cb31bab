#include "study/shape_meshes.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "part/part.hpp"

namespace fingerpad::shape_meshes_test {
namespace {

double volume_m3(const TriangleSoup& soup) {
  double sum = 0;
  for (Eigen::Index t = 0; t < soup.triangles.cols(); ++t) {
    const auto corner = [&](int k) -> Vec3 { return soup.vertices_P.col(soup.triangles(k, t)); };
    sum += corner(0).dot(corner(1).cross(corner(2))) / 6;
  }
  return sum;
}

bool is_closed(const TriangleSoup& soup) {
  const Part part = make_part(soup, std::numbers::pi / 6);
  return part.neighbours.minCoeff() >= 0;
}

TEST(ShapeMeshes, ABarIsClosedAndHasItsVolume) {
  const TriangleSoup bar = bar_mesh({{-0.02, 0}, {-0.005, 0.003}, {0.02, 0.001}}, 0.01, -0.01);
  EXPECT_TRUE(is_closed(bar));
  const double side_m2 = 0.015 * (0.01 + 0.0015) + 0.025 * (0.01 + 0.002);
  EXPECT_NEAR(volume_m3(bar), side_m2 * 0.02, 1e-12) << "outward, or it were less than nothing";
}

}  // namespace
}  // namespace fingerpad::shape_meshes_test
