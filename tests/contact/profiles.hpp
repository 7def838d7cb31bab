#pragma once

#include <cmath>
#include <vector>

#include "part/part.hpp"

namespace fingerpad::test {

/// Two flat faces, z = 1 and x = 1, that a fillet of radius 1 about the y axis joins: each face 10 long, all
/// 20 wide, open at the borders.
/// @param facets  of the fillet
/// @param rows    along y
/// @param sliver  width of a strip of the face z = 1 beside the fillet; none where 0
inline TriangleSoup filleted_bar(int facets, int rows, double sliver = 0) {
  std::vector<Vec2> profile = {{-10, 1}};
  if (sliver > 0) profile.emplace_back(-sliver, 1);
  for (int i = 0; i <= facets; ++i) {
    const double angle = M_PI / 2 * i / facets;
    profile.emplace_back(std::sin(angle), std::cos(angle));
  }
  profile.emplace_back(1, -10);
  const int across = static_cast<int>(profile.size());
  TriangleSoup soup;
  soup.vertices_P.resize(3, Eigen::Index{across} * (rows + 1));
  soup.triangles.resize(3, Eigen::Index{2} * (across - 1) * rows);
  Eigen::Index next = 0;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i < across; ++i) {
      const Vec2 p = profile[static_cast<std::size_t>(i)];
      const int a = j * across + i;
      soup.vertices_P.col(a) = Vec3(p.x(), 20.0 * j / rows - 10, p.y());
      if (j == rows || i == across - 1) continue;
      soup.triangles.col(next++) << a, a + 1, a + 1 + across;
      soup.triangles.col(next++) << a, a + 1 + across, a + across;
    }
  }
  return soup;
}

/// A cylinder's wall of radius 2 from z = -8 to z = 8 in one row of strips, and the quarter rounds of radius
/// 1 that lead to its ends, which are open.
/// @param around  strips of the wall
/// @param facets  of each round
/// @param share   of two strips' turn, that of the first
inline TriangleSoup rounded_drum(int around, int facets, double share = 0.5) {
  std::vector<Vec2> profile;  // radius and height, upwards
  for (int i = 0; i <= facets; ++i) {
    const double angle = M_PI / 2 * (1 - static_cast<double>(i) / facets);
    profile.emplace_back(1 + std::cos(angle), -8 - std::sin(angle));
  }
  for (int i = facets; i >= 0; --i) {
    const Vec2 below = profile[static_cast<std::size_t>(i)];
    profile.emplace_back(below.x(), -below.y());
  }
  const int rows = static_cast<int>(profile.size());
  TriangleSoup soup;
  soup.vertices_P.resize(3, Eigen::Index{rows} * around);
  soup.triangles.resize(3, Eigen::Index{2} * (rows - 1) * around);
  Eigen::Index next = 0;
  for (int j = 0; j < rows; ++j) {
    const Vec2 at = profile[static_cast<std::size_t>(j)];
    for (int i = 0; i < around; ++i) {
      const double angle = 2 * M_PI / around * (i - i % 2 + i % 2 * 2 * share);
      const int a = j * around + i, b = j * around + (i + 1) % around;
      soup.vertices_P.col(a) << at.x() * std::cos(angle), at.x() * std::sin(angle), at.y();
      if (j + 1 == rows) continue;
      soup.triangles.col(next++) << a, b, b + around;
      soup.triangles.col(next++) << a, b + around, a + around;
    }
  }
  return soup;
}

/// A closed cylinder of radius 1 from z = -1 to z = 1, its rims sharp; the ends are fans about their middles.
inline TriangleSoup drum(int facets) {
  TriangleSoup soup;
  soup.vertices_P.resize(3, Eigen::Index{2} * facets + 2);
  soup.triangles.resize(3, Eigen::Index{4} * facets);
  const int low_middle = 2 * facets, high_middle = low_middle + 1;
  soup.vertices_P.col(low_middle) << 0, 0, -1;
  soup.vertices_P.col(high_middle) << 0, 0, 1;
  for (int i = 0; i < facets; ++i) {
    const double angle = 2 * M_PI * i / facets;
    const int low = 2 * i, high = low + 1, next_low = 2 * ((i + 1) % facets), next_high = next_low + 1;
    soup.vertices_P.col(low) << std::cos(angle), std::sin(angle), -1;
    soup.vertices_P.col(high) << std::cos(angle), std::sin(angle), 1;
    const Eigen::Index first = Eigen::Index{4} * i;
    soup.triangles.col(first) << low, next_low, next_high;
    soup.triangles.col(first + 1) << low, next_high, high;
    soup.triangles.col(first + 2) << low_middle, next_low, low;
    soup.triangles.col(first + 3) << high_middle, high, next_high;
  }
  return soup;
}

/// A closed cylinder of radius 1 from z = -1 to z = 1, its rims sharp, in strips of 24 and 6 degrees in turn;
/// the ends are fans about a corner of the rim, so that the first and the last triangle are slivers.
inline TriangleSoup uneven_drum() {
  constexpr int strips = 24;
  TriangleSoup soup;
  soup.vertices_P.resize(3, 2 * strips);
  soup.triangles.resize(3, 4 * strips - 4);
  for (int i = 0; i < strips; ++i) {
    const double angle = M_PI / 180 * (30 * (i / 2) + 24 * (i % 2));
    for (const int k : {0, 1}) soup.vertices_P.col(2 * i + k) << std::cos(angle), std::sin(angle), 2 * k - 1;
    const int low = 2 * i, high = low + 1, next_low = 2 * ((i + 1) % strips), next_high = next_low + 1;
    soup.triangles.col(2 * i) << low, next_low, next_high;
    soup.triangles.col(2 * i + 1) << low, next_high, high;
    if (i == 0 || i == strips - 1) continue;
    soup.triangles.col(2 * strips + 2 * i - 2) << 0, next_low, low;
    soup.triangles.col(2 * strips + 2 * i - 1) << 1, high, next_high;
  }
  return soup;
}

}  // namespace fingerpad::test
