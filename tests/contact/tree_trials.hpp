#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "base/random_stream.hpp"
#include "contact/bare_part.hpp"
#include "contact/triangle_tree.hpp"

// Parts on which a tree can go wrong, and how its answers are compared.

namespace fingerpad::test {

inline Vec3 random_point(RandomStream& random, double scale) {
  return Vec3(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5) * (2 * scale);
}

/// A torus of n x m quads, each cut in two; `stretch` along x makes slivers of it.
inline std::shared_ptr<const Part> torus(int n, int m, double stretch = 1) {
  Points vertices(3, Eigen::Index{n} * m);
  IndexTriples triangles(3, Eigen::Index{2} * n * m);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < m; ++j) {
      const double u = 2 * M_PI * i / n, v = 2 * M_PI * j / m, r = 1 + 0.4 * std::cos(v);
      vertices.col(i * m + j) = Vec3(stretch * r * std::cos(u), r * std::sin(u), 0.4 * std::sin(v));
      const int a = i * m + j, b = (i + 1) % n * m + j;
      const int c = (i + 1) % n * m + (j + 1) % m, d = i * m + (j + 1) % m;
      triangles.col(2 * (i * m + j)) << a, b, c;
      triangles.col(2 * (i * m + j) + 1) << a, c, d;
    }
  }
  return std::make_shared<const Part>(bare_part(vertices, triangles));
}

/// Triangles of every size and shape, touching nowhere: needles to 1e7, some without area, some twice.
inline std::shared_ptr<const Part> soup_of_slivers(int count) {
  RandomStream random(7);
  Points vertices(3, Eigen::Index{3} * count);
  IndexTriples triangles(3, count);
  for (int t = 0; t < count; ++t) {
    const Vec3 a = random_point(random, 1);
    const Vec3 ab = random_point(random, 0.3 * std::pow(10.0, -3 * random.uniform()));
    const double width = t % 10 == 0 ? 0 : std::pow(10.0, -7 * random.uniform());
    vertices.col(3 * t) = a;
    vertices.col(3 * t + 1) = a + ab;
    vertices.col(3 * t + 2) = a + ab * random.uniform() + random_point(random, ab.norm() * width);
    triangles.col(t) << 3 * t, 3 * t + 1, 3 * t + 2;
    if (t % 17 == 1) triangles.col(t) = triangles.col(t - 1);
  }
  return std::make_shared<const Part>(bare_part(vertices, triangles));
}

inline void expect_same_bits(const ClosestTriangle& a, const ClosestTriangle& b) {
  ASSERT_EQ(a.triangle, b.triangle);
  ASSERT_EQ(a.at.distance2_m2, b.at.distance2_m2);
  ASSERT_EQ(a.at.point, b.at.point);
  ASSERT_EQ(a.at.feature, b.at.feature);
  ASSERT_EQ(a.at.barycentric, b.at.barycentric);
}

}  // namespace fingerpad::test
