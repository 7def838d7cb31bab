#include "support/shapes.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace fingerpad::test {
namespace {

TriangleSoup soup_of(const std::vector<Vec3>& vertices, const std::vector<Eigen::Vector3i>& triangles) {
  TriangleSoup soup;
  soup.vertices_P.resize(3, static_cast<Eigen::Index>(vertices.size()));
  soup.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    soup.vertices_P.col(static_cast<Eigen::Index>(i)) = vertices[i];
  }
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    soup.triangles.col(static_cast<Eigen::Index>(i)) = triangles[i];
  }
  return soup;
}

}  // namespace

TriangleSoup box_soup(const Vec3& size_m) {
  // Vertex number: bit 0 is x, bit 1 is y, bit 2 is z.
  std::vector<Vec3> vertices;
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner((i & 1) - 0.5, ((i >> 1) & 1) - 0.5, ((i >> 2) & 1) - 0.5);
    vertices.emplace_back(corner.cwiseProduct(size_m));
  }
  return soup_of(vertices, {{0, 2, 3},
                            {0, 3, 1},
                            {4, 5, 7},
                            {4, 7, 6},
                            {0, 1, 5},
                            {0, 5, 4},
                            {2, 6, 7},
                            {2, 7, 3},
                            {0, 4, 6},
                            {0, 6, 2},
                            {1, 3, 7},
                            {1, 7, 5}});
}

TriangleSoup sphere_soup(double radius_m, int subdivisions) {
  std::vector<Vec3> vertices{Vec3::UnitX(),  -Vec3::UnitX(), Vec3::UnitY(),
                             -Vec3::UnitY(), Vec3::UnitZ(),  -Vec3::UnitZ()};
  std::vector<Eigen::Vector3i> triangles{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                         {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int level = 0; level < subdivisions; ++level) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [place, fresh] = middles.try_emplace(std::minmax(a, b), static_cast<int>(vertices.size()));
      if (fresh) {
        const Vec3 sum = vertices[static_cast<std::size_t>(a)] + vertices[static_cast<std::size_t>(b)];
        vertices.emplace_back(sum.normalized());
      }
      return place->second;
    };
    std::vector<Eigen::Vector3i> finer;
    for (const Eigen::Vector3i& t : triangles) {
      const int ab = middle(t[0], t[1]), bc = middle(t[1], t[2]), ca = middle(t[2], t[0]);
      finer.insert(finer.end(), {{t[0], ab, ca}, {t[1], bc, ab}, {t[2], ca, bc}, {ab, bc, ca}});
    }
    triangles = std::move(finer);
  }
  for (Vec3& vertex : vertices) vertex *= radius_m;
  return soup_of(vertices, triangles);
}

TriangleSoup torus_soup(double ring_radius_m, double tube_radius_m, int around, int across) {
  std::vector<Vec3> vertices;
  std::vector<Eigen::Vector3i> triangles;
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * j / across;
      const double r = ring_radius_m + tube_radius_m * std::cos(v);
      vertices.emplace_back(r * std::cos(u), r * std::sin(u), tube_radius_m * std::sin(v));
      const int a = i * across + j, b = ((i + 1) % around) * across + j;
      const int c = ((i + 1) % around) * across + (j + 1) % across, d = i * across + (j + 1) % across;
      triangles.emplace_back(a, b, c);
      triangles.emplace_back(a, c, d);
    }
  }
  return soup_of(vertices, triangles);
}

TriangleSoup square_soup(double side_m, int cells) {
  std::vector<Vec3> vertices;
  std::vector<Eigen::Vector3i> triangles;
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; j <= cells; ++j) {
      vertices.emplace_back(side_m * (double(i) / cells - 0.5), side_m * (double(j) / cells - 0.5), 0);
      if (i == cells || j == cells) continue;
      const int a = i * (cells + 1) + j, b = a + cells + 1;
      triangles.emplace_back(a, b, b + 1);
      triangles.emplace_back(a, b + 1, a + 1);
    }
  }
  return soup_of(vertices, triangles);
}

TriangleSoup roof_soup(double side_m, double turn_rad) {
  const double x = side_m * std::cos(turn_rad / 2), z = -side_m * std::sin(turn_rad / 2), y = side_m / 2;
  const std::vector<Vec3> vertices{{0, -y, 0}, {0, y, 0}, {x, -y, z}, {x, y, z}, {-x, -y, z}, {-x, y, z}};
  return soup_of(vertices, {{0, 2, 3}, {0, 3, 1}, {4, 0, 1}, {4, 1, 5}});
}

TriangleSoup joined(const TriangleSoup& first, const TriangleSoup& second) {
  TriangleSoup soup;
  soup.vertices_P.resize(3, first.vertices_P.cols() + second.vertices_P.cols());
  soup.vertices_P << first.vertices_P, second.vertices_P;
  soup.triangles.resize(3, first.triangles.cols() + second.triangles.cols());
  const int behind = static_cast<int>(first.vertices_P.cols());
  soup.triangles << first.triangles, (second.triangles.array() + behind).matrix();
  return soup;
}

TriangleSoup moved(TriangleSoup soup, const Vec3& offset_m) {
  soup.vertices_P.colwise() += offset_m;
  return soup;
}

TriangleSoup reversed(TriangleSoup soup) {
  soup.triangles.row(1).swap(soup.triangles.row(2));
  return soup;
}

TriangleSoup unshared(const TriangleSoup& soup) {
  TriangleSoup loose;
  loose.file_triangle = soup.file_triangle;
  loose.triangles.resize(3, soup.triangles.cols());
  loose.vertices_P.resize(3, 3 * soup.triangles.cols());
  for (Eigen::Index t = 0; t < soup.triangles.cols(); ++t) {
    for (Eigen::Index k = 0; k < 3; ++k) {
      loose.triangles(k, t) = static_cast<int>(3 * t + k);
      loose.vertices_P.col(3 * t + k) = soup.vertices_P.col(soup.triangles(k, t));
    }
  }
  return loose;
}

}  // namespace fingerpad::test
