#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "base/random_stream.hpp"
#include "contact/proxy.hpp"
#include "support/shapes.hpp"

// Worlds in which a shaded proxy has a hard time: corners, cusps and folds, about 1 m in size.

namespace fingerpad::test {

struct NastyWorld {
  std::string name;
  std::vector<PlacedSurface> surfaces;
  Vec3 start = Vec3(0.01, 0.02, 1.2);  ///< where the finger sets out: outside of all, or within a hollow
};

inline PlacedSurface part_surface(std::shared_ptr<const Part> part) {
  PlacedSurface surface;
  surface.tree = std::make_shared<const TriangleTree>(std::move(part));
  return surface;
}

inline PlacedSurface creased_surface(const TriangleSoup& soup) {
  return part_surface(std::make_shared<const Part>(make_part(soup, std::numbers::pi / 6)));
}

inline PlacedSurface plane_of(const Vec3& point, const Vec3& normal) {
  PlacedSurface surface;
  surface.plane_point_W = point;
  surface.plane_normal_W = normal.normalized();
  return surface;
}

/// Rows of points joined by quads, each split in two.
/// @param closed  joins the last of a row to its first
inline TriangleSoup woven(const std::vector<std::vector<Vec3>>& rows, bool closed) {
  const int across = static_cast<int>(rows[0].size()), along = static_cast<int>(rows.size());
  TriangleSoup soup;
  soup.vertices_P.resize(3, Eigen::Index{across} * along);
  soup.triangles.resize(3, Eigen::Index{2} * (along - 1) * (closed ? across : across - 1));
  Eigen::Index next = 0;
  for (int j = 0; j < along; ++j) {
    for (int i = 0; i < across; ++i) {
      const int a = j * across + i, b = j * across + (i + 1) % across;
      soup.vertices_P.col(a) = rows[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)];
      if (j + 1 == along || (!closed && i + 1 == across)) continue;
      soup.triangles.col(next++) << a, b, b + across;
      soup.triangles.col(next++) << a, b + across, a + across;
    }
  }
  return soup;
}

/// A profile (x, z) from left to right, drawn along y over 2 m, its outer side up.
inline TriangleSoup drawn(const std::vector<Vec2>& profile, int rows) {
  std::vector<std::vector<Vec3>> points;
  for (int j = 0; j <= rows; ++j) {
    points.emplace_back();
    for (const Vec2& p : profile) points.back().emplace_back(p.x(), 2.0 * j / rows - 1, p.y());
  }
  return woven(points, false);
}

/// A profile (r, z) from the outside in, turned about z, its outer side up.
inline TriangleSoup turned_about_z(const std::vector<Vec2>& profile, int around) {
  std::vector<std::vector<Vec3>> points;
  for (const Vec2& p : profile) {
    points.emplace_back();
    for (int i = 0; i < around; ++i) {
      const double angle = 2 * std::numbers::pi * i / around;
      points.back().emplace_back(p.x() * std::cos(angle), p.x() * std::sin(angle), p.y());
    }
  }
  return woven(points, true);
}

/// A field of heights over [-1, 1] x [-1, 1].
inline TriangleSoup field(int cells, double (*height)(double x, double y)) {
  std::vector<std::vector<Vec3>> points;
  for (int j = 0; j <= cells; ++j) {
    points.emplace_back();
    for (int i = 0; i <= cells; ++i) {
      const double x = 2.0 * i / cells - 1, y = 2.0 * j / cells - 1;
      points.back().emplace_back(x, y, height(x, y));
    }
  }
  return woven(points, false);
}

/// The profile of a groove of this opening angle, its bottom a tessellated fillet.
inline std::vector<Vec2> groove(double opening_deg, double radius, int facets) {
  const double half = opening_deg / 2 * std::numbers::pi / 180, turn = std::numbers::pi / 2 - half;
  std::vector<Vec2> profile{{-std::tan(half), 1}};
  for (int i = 0; i <= facets; ++i) {
    const double angle = turn * (2.0 * i / facets - 1);
    profile.emplace_back(radius * std::sin(angle), radius / std::sin(half) - radius * std::cos(angle));
  }
  profile.emplace_back(std::tan(half), 1);
  return profile;
}

/// A corner whose one wall is a fan of slivers about it.
inline TriangleSoup slivers_at_a_corner() {
  constexpr int count = 40;
  TriangleSoup soup;
  soup.vertices_P.resize(3, count + 3);
  soup.triangles.resize(3, 2 * count + 1);
  soup.vertices_P.leftCols<2>() << 0, 0, 0, 0, 0, 1;
  for (int i = 0; i <= count; ++i) {
    const double angle = 1.2 * std::pow(static_cast<double>(i) / count, 3);
    soup.vertices_P.col(2 + i) << std::cos(angle), std::sin(angle), 0.15 * angle * angle;
    if (i == count) break;
    soup.triangles.col(i) << 0, 2 + i, 3 + i;
    soup.triangles.col(count + i) << 1, 3 + i, 2 + i;
  }
  soup.triangles.col(2 * count) << 0, 1, 2;
  return soup;
}

/// Three sheets that meet in one edge.
inline TriangleSoup three_sheets() {
  TriangleSoup soup;
  soup.vertices_P.resize(3, 8);
  soup.triangles.resize(3, 6);
  soup.vertices_P << 0, 0, 1, 1, -0.8, -0.8, 0.2, 0.2, -1, 1, -1, 1, -1, 1, -1, 1, 0, 0, 0.4, 0.4, 0.5, 0.5,
      1, 1;
  soup.triangles << 0, 0, 4, 4, 0, 0, 2, 3, 0, 1, 6, 7, 3, 1, 1, 5, 7, 1;
  return soup;
}

inline TriangleSoup random_triangles() {
  constexpr int count = 70;
  RandomStream random(5);
  const auto somewhere = [&random]() -> Vec3 {
    return 0.4 * Vec3(random.normal(), random.normal(), random.normal());
  };
  TriangleSoup soup;
  soup.vertices_P.resize(3, 3 * count);
  soup.triangles.resize(3, count);
  for (int t = 0; t < count; ++t) {
    const Vec3 at = somewhere();
    for (int k = 0; k < 3; ++k) {
      soup.vertices_P.col(3 * t + k) = at + somewhere();
      soup.triangles(k, t) = 3 * t + k;
    }
  }
  return soup;
}

/// A spike of 20 facets between a floor and a wall.
inline TriangleSoup spike_by_a_wall() {
  const TriangleSoup spike = turned_about_z({{0.4, 0}, {0.2, 0.5}, {1e-3, 1}}, 20);
  const TriangleSoup wall = moved(drawn({{0, 1}, {0, -1}}, 2), Vec3(-0.35, 0, 0));
  return joined(joined(spike, square_soup(2, 1)), wall);
}

inline std::vector<NastyWorld> nasty_worlds() {
  const double degree = std::numbers::pi / 180;
  const auto one = [](const TriangleSoup& soup) { return std::vector<PlacedSurface>{creased_surface(soup)}; };
  const TriangleSoup ring = torus_soup(0.5, 0.3, 20, 16), bowl = reversed(sphere_soup(1, 2));
  return {
      {"valley of 90 degrees", one(roof_soup(2, -90 * degree))},
      {"valley of 30 degrees", one(roof_soup(2, -150 * degree))},
      {"valley just no crease", one(roof_soup(2, -29 * degree))},
      {"valley just a crease", one(roof_soup(2, -31 * degree))},
      {"ridge just no crease", one(roof_soup(2, 29 * degree))},
      {"ridge just a crease", one(roof_soup(2, 31 * degree))},
      {"groove of 20 degrees, filleted", one(drawn(groove(20, 0.1, 6), 5))},
      {"groove of 40 degrees, filleted", one(drawn(groove(40, 0.2, 6), 5))},
      {"groove of 60 degrees, coarse fillet", one(drawn(groove(60, 0.3, 4), 3))},
      {"slot with a round bottom and rims", one(drawn({{-1, 1},
                                                       {-0.3, 1},
                                                       {-0.25, 0.98},
                                                       {-0.21, 0.93},
                                                       {-0.2, 0.85},
                                                       {-0.2, 0},
                                                       {-0.17, -0.1},
                                                       {-0.1, -0.17},
                                                       {0, -0.2},
                                                       {0.1, -0.17},
                                                       {0.17, -0.1},
                                                       {0.2, 0},
                                                       {0.2, 0.85},
                                                       {0.21, 0.93},
                                                       {0.25, 0.98},
                                                       {0.3, 1},
                                                       {1, 1}},
                                                      3))},
      {"torus from within", one(reversed(torus_soup(1, 0.5, 14, 13))), Vec3(1.01, 0.02, 0.03)},
      {"hollow ball", one(bowl), Vec3(0.01, 0.02, 0.03)},
      {"funnel", one(turned_about_z({{1, 1}, {0.5, 0.2}, {0.1, -0.4}, {1e-3, -0.55}}, 13))},
      {"narrow funnel", one(turned_about_z({{0.4, 1}, {0.3, 0.5}, {0.15, -0.3}, {0.02, -0.95}}, 14))},
      {"hexagonal socket", one(turned_about_z({{1, 0.5}, {0.5, 0.5}, {0.5, -0.5}, {0, -0.5}}, 6))},
      {"blind bore, filleted", one(turned_about_z({{1, 0.5},
                                                   {0.6, 0.5},
                                                   {0.52, 0.47},
                                                   {0.5, 0.4},
                                                   {0.5, -0.3},
                                                   {0.48, -0.39},
                                                   {0.42, -0.46},
                                                   {0.3, -0.5},
                                                   {0, -0.5}},
                                                  14))},
      {"saddle", one(field(9, [](double x, double y) { return 0.6 * (x * x - y * y); }))},
      {"egg box",
       one(field(12, [](double x, double y) { return 0.25 * std::sin(6 * x) * std::sin(5.3 * y + 0.3); }))},
      {"crumpled sheet", one(field(10,
                                   [](double x, double y) {
                                     return 0.1 * std::sin(37 * x + 11 * y) +
                                            0.12 * std::cos(23 * y - 31 * x * y);
                                   }))},
      {"spike by a wall", one(spike_by_a_wall())},
      {"slivers at a corner", one(slivers_at_a_corner())},
      {"three sheets in an edge", one(three_sheets())},
      {"random triangles", one(random_triangles())},
      {"ring on a plane",
       {creased_surface(moved(ring, Vec3(0, 0, 0.299))), plane_of(Vec3::Zero(), Vec3::UnitZ())}},
      {"two balls that touch",
       {creased_surface(moved(sphere_soup(0.6, 2), Vec3(-0.59, 0, 0))),
        creased_surface(moved(sphere_soup(0.6, 3), Vec3(0.59, 0, 0)))}},
      {"ball and plane in a hollow ball",
       {creased_surface(bowl), creased_surface(moved(sphere_soup(0.3, 2), Vec3(0.1, 0.2, -0.6))),
        plane_of(Vec3(0, 0, -0.7), Vec3(0.2, 0.1, 1))},
       Vec3(0.1, -0.3, 0.3)},
      {"ring in a groove by a plane",
       {creased_surface(drawn(groove(70, 0.15, 5), 4)),
        creased_surface(moved(torus_soup(0.5, 0.25, 16, 12), Vec3(0, 0.1, 0.6))),
        plane_of(Vec3(0, -0.5, 0), Vec3(0, 1, 0.3))}},
  };
}

}  // namespace fingerpad::test
