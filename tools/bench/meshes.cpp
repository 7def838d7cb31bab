#include "meshes.hpp"

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace fingerpad::bench {
namespace {

using Triple = std::array<int, 3>;

TriangleSoup soup_of(const std::vector<Vec3>& vertices, const std::vector<Triple>& triangles) {
  TriangleSoup soup;
  soup.vertices_P.resize(3, static_cast<Eigen::Index>(vertices.size()));
  for (std::size_t i = 0; i < vertices.size(); ++i)
    soup.vertices_P.col(static_cast<Eigen::Index>(i)) = vertices[i];
  soup.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) soup.triangles(k, static_cast<Eigen::Index>(t)) = triangles[t][k];
  }
  return soup;
}

std::vector<Triple> split(const std::vector<Triple>& triangles, std::vector<Vec3>& vertices) {
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](int a, int b) {
    const auto [place, is_new] = middles.try_emplace(std::minmax(a, b), static_cast<int>(vertices.size()));
    if (is_new) vertices.push_back((vertices[a] + vertices[b]).normalized() / 2);
    return place->second;
  };
  std::vector<Triple> finer;
  for (const auto& [a, b, c] : triangles) {
    const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
  }
  return finer;
}

}  // namespace

TriangleSoup icosphere(int subdivisions) {
  const double g = std::numbers::phi;
  std::vector<Vec3> vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                                {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  for (Vec3& v : vertices) v = v.normalized() / 2;
  std::vector<Triple> triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                   {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                   {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                   {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (int i = 0; i < subdivisions; ++i) triangles = split(triangles, vertices);
  return soup_of(vertices, triangles);
}

TriangleSoup drilled_plate() {
  constexpr int columns = 16, rows = 10, sides = 80;
  constexpr double cell_m = 0.0625, hole_m = 0.02, half_height_m = 0.005;
  std::vector<Vec3> vertices;
  std::vector<Triple> triangles;
  const auto quad = [&](int a, int b, int c, int d) {
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
  };
  // Corner (i, j) of the grid of cells is vertex 2 (i (rows + 1) + j) above, the next one below.
  const auto corner = [&](int i, int j) { return 2 * (i * (rows + 1) + j); };
  for (int i = 0; i <= columns; ++i) {
    for (int j = 0; j <= rows; ++j) {
      for (const double z : {half_height_m, -half_height_m}) {
        vertices.emplace_back((i - 0.5 * columns) * cell_m, (j - 0.5 * rows) * cell_m, z);
      }
    }
  }
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      const int rim = static_cast<int>(vertices.size());
      const double x = (i + 0.5 - 0.5 * columns) * cell_m, y = (j + 0.5 - 0.5 * rows) * cell_m;
      for (int s = 0; s < sides; ++s) {
        const double angle = 2 * std::numbers::pi * s / sides;
        for (const double z : {half_height_m, -half_height_m}) {
          vertices.emplace_back(x + hole_m * std::cos(angle), y + hole_m * std::sin(angle), z);
        }
      }
      const int corners[4] = {corner(i + 1, j + 1), corner(i, j + 1), corner(i, j), corner(i + 1, j)};
      for (int s = 0; s < sides; ++s) {
        const int at = rim + 2 * s, next = rim + 2 * ((s + 1) % sides), c = corners[s * 4 / sides];
        triangles.push_back({at, c, next});
        triangles.push_back({at + 1, next + 1, c + 1});
        quad(at, next, next + 1, at + 1);  // the hole's wall
      }
      for (int k = 0; k < 4; ++k) {  // between two fans: from the rim to a whole side of the cell
        const int at = rim + 2 * (k * sides / 4), a = corners[(k + 3) % 4], b = corners[k];
        triangles.push_back({at, a, b});
        triangles.push_back({at + 1, b + 1, a + 1});
      }
    }
  }
  for (int i = 0; i < columns; ++i) {
    quad(corner(i, 0), corner(i, 0) + 1, corner(i + 1, 0) + 1, corner(i + 1, 0));
    quad(corner(i + 1, rows), corner(i + 1, rows) + 1, corner(i, rows) + 1, corner(i, rows));
  }
  for (int j = 0; j < rows; ++j) {
    quad(corner(0, j + 1), corner(0, j + 1) + 1, corner(0, j) + 1, corner(0, j));
    quad(corner(columns, j), corner(columns, j) + 1, corner(columns, j + 1) + 1, corner(columns, j + 1));
  }
  return soup_of(vertices, triangles);
}

}  // namespace fingerpad::bench
