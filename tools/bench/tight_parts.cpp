#include "tight_parts.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "meshes.hpp"

namespace fingerpad::bench {
namespace {

Vec3 around(int k, int count, double radius_m, double z_m) {
  const double angle = 2 * std::numbers::pi * k / count;
  return {radius_m * std::cos(angle), radius_m * std::sin(angle), z_m};
}

}  // namespace

TriangleSoup bore(double radius_m, int facets) {
  const double inner_m = radius_m / std::cos(std::numbers::pi / facets), outer_m = 3 * radius_m,
               half_m = 4 * radius_m;
  TriangleSoup soup;
  soup.vertices_P.resize(3, 4 * facets);
  soup.triangles.resize(3, 8 * facets);
  for (int k = 0; k < facets; ++k) {
    // Inner edge above and below, outer edge above and below.
    soup.vertices_P.col(4 * k) = around(k, facets, inner_m, half_m);
    soup.vertices_P.col(4 * k + 1) = around(k, facets, inner_m, -half_m);
    soup.vertices_P.col(4 * k + 2) = around(k, facets, outer_m, half_m);
    soup.vertices_P.col(4 * k + 3) = around(k, facets, outer_m, -half_m);
    const int a = 4 * k, b = 4 * ((k + 1) % facets);
    int column = 8 * k;
    const auto quad = [&](int p, int q, int r, int s) {
      soup.triangles.col(column++) << p, q, r;
      soup.triangles.col(column++) << p, r, s;
    };
    quad(a, a + 1, b + 1, b);          // the bore, seen from its axis
    quad(a + 2, b + 2, b + 3, a + 3);  // the bar
    quad(a, b, b + 2, a + 2);          // its upper end
    quad(a + 1, a + 3, b + 3, b + 1);  // its lower end
  }
  return soup;
}

TriangleSoup socket(double radius_m, int subdivisions) {
  const TriangleSoup ball = icosphere(subdivisions);
  double nearest_m = 1;
  for (Eigen::Index t = 0; t < ball.triangles.cols(); ++t) {
    const Vec3 a = ball.vertices_P.col(ball.triangles(0, t)), b = ball.vertices_P.col(ball.triangles(1, t)),
               c = ball.vertices_P.col(ball.triangles(2, t));
    nearest_m = std::min(nearest_m, std::abs((b - a).cross(c - a).normalized().dot(a)));
  }
  const Eigen::Index vertices = ball.vertices_P.cols(), triangles = ball.triangles.cols();
  TriangleSoup soup;
  soup.vertices_P.resize(3, vertices + 8);
  soup.triangles.resize(3, triangles + 12);
  soup.vertices_P.leftCols(vertices) = ball.vertices_P * (radius_m / nearest_m);
  soup.triangles.leftCols(triangles) = ball.triangles.colwise().reverse();  // wound inwards
  for (int k = 0; k < 8; ++k)
    soup.vertices_P.col(vertices + k) = 2 * radius_m * Vec3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
  const int sides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                           {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  const int first = static_cast<int>(vertices);
  for (int k = 0; k < 6; ++k) {
    const auto& s = sides[k];
    soup.triangles.col(triangles + 2 * k) << first + s[0], first + s[1], first + s[2];
    soup.triangles.col(triangles + 2 * k + 1) << first + s[0], first + s[2], first + s[3];
  }
  return soup;
}

TriangleSoup fan(double radius_m, double height_m, int facets) {
  TriangleSoup soup;
  soup.vertices_P.resize(3, facets + 2);
  soup.triangles.resize(3, 2 * facets);
  soup.vertices_P.col(0) = Vec3::Zero();
  soup.vertices_P.col(1) = Vec3(0, 0, -height_m);
  for (int k = 0; k < facets; ++k) {
    soup.vertices_P.col(k + 2) = around(k, facets, radius_m, -height_m);
    const int a = k + 2, b = (k + 1) % facets + 2;
    soup.triangles.col(2 * k) << 0, a, b;
    soup.triangles.col(2 * k + 1) << 1, b, a;
  }
  return soup;
}

}  // namespace fingerpad::bench
