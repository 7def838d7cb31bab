#include "study/contact_surfaces.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace fingerpad {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;

TriangleSoup soup_of(const std::vector<Vec3>& vertices, const std::vector<Eigen::Vector3i>& triangles) {
  TriangleSoup soup;
  soup.vertices_P.resize(3, static_cast<Eigen::Index>(vertices.size()));
  soup.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
  for (Eigen::Index i = 0; i < soup.vertices_P.cols(); ++i)
    soup.vertices_P.col(i) = vertices[static_cast<std::size_t>(i)];
  for (Eigen::Index i = 0; i < soup.triangles.cols(); ++i)
    soup.triangles.col(i) = triangles[static_cast<std::size_t>(i)];
  return soup;
}

constexpr double sphere_m = 0.05;

ExactSurface sphere() {
  ExactSurface surface{"sphere", "radius 50 mm", {3, 4, 5, 6, 7}, {}, {}, {}, {}};
  surface.mesh = [](int level) { return ball_mesh(sphere_m, level); };
  surface.facet_m = [](int level) { return sphere_m * full_turn / 4 / std::exp2(level); };
  surface.foot = [](const Vec3& p) { return ExactFoot{p.norm() - sphere_m, p.normalized()}; };
  surface.way = [](double along) {
    const double around = 0.3 + 4.1 * along, up = 0.45 * std::sin(1.3 + 5 * along);
    return Vec3(sphere_m *
                Vec3(std::cos(up) * std::cos(around), std::cos(up) * std::sin(around), std::sin(up)));
  };
  return surface;
}

/// The torus's ring and tube [m].
constexpr double ring_m = 0.05, tube_m = 0.02;

TriangleSoup torus_mesh(int around, int across) {
  std::vector<Vec3> vertices;
  std::vector<Eigen::Vector3i> triangles;
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double u = full_turn * i / around, v = full_turn * j / across, r = ring_m + tube_m * std::cos(v);
      vertices.emplace_back(r * std::cos(u), r * std::sin(u), tube_m * std::sin(v));
      const int a = i * across + j, b = (i + 1) % around * across + j;
      const int c = (i + 1) % around * across + (j + 1) % across, d = i * across + (j + 1) % across;
      triangles.emplace_back(a, b, c);
      triangles.emplace_back(a, c, d);
    }
  }
  return soup_of(vertices, triangles);
}

ExactSurface torus() {
  ExactSurface surface{"torus", "50 mm to the middle of a tube of 20 mm", {16, 32, 64, 128, 256}, {}, {}, {},
                       {}};
  surface.mesh = [](int across) { return torus_mesh(2 * across, across); };
  surface.facet_m = [](int across) { return tube_m * full_turn / across; };
  surface.foot = [](const Vec3& p) {
    const Vec3 middle = ring_m * Vec3(p.x(), p.y(), 0).normalized();
    return ExactFoot{(p - middle).norm() - tube_m, (p - middle).normalized()};
  };
  surface.way = [](double along) {
    const double u = 0.21 + 1.7 * along, v = 0.4 + 6.9 * along, r = ring_m + tube_m * std::cos(v);
    return Vec3(r * std::cos(u), r * std::sin(u), tube_m * std::sin(v));
  };
  return surface;
}

/// The round part's sizes: radius, half height, fillet [m].
constexpr double round_m = 0.02, half_height_m = 0.015, fillet_m = 0.005;

/// Both fillets in `steps` facets, the flats between them in one each, as a CAD tessellation has them.
TriangleSoup round_part_mesh(int steps) {
  const int around = 8 * steps;
  std::vector<Vec2> profile;  // radius and height, from the top's rim to the bottom's
  for (int i = 0; i <= steps; ++i) {
    const double angle = full_turn / 4 * i / steps;
    profile.emplace_back(round_m - fillet_m * (1 - std::sin(angle)),
                         half_height_m - fillet_m * (1 - std::cos(angle)));
  }
  for (int i = steps; i >= 0; --i) {
    const Vec2 above = profile[static_cast<std::size_t>(i)];
    profile.emplace_back(above.x(), -above.y());
  }
  std::vector<Vec3> vertices;
  std::vector<Eigen::Vector3i> triangles;
  const int rings = static_cast<int>(profile.size());
  for (const Vec2& at : profile) {
    for (int k = 0; k < around; ++k)
      vertices.emplace_back(at.x() * std::cos(full_turn * k / around),
                            at.x() * std::sin(full_turn * k / around), at.y());
  }
  vertices.emplace_back(0, 0, half_height_m);
  vertices.emplace_back(0, 0, -half_height_m);
  for (int k = 0; k < around; ++k) {
    const int next = (k + 1) % around, last = (rings - 1) * around;
    triangles.emplace_back(rings * around, k, next);
    triangles.emplace_back(rings * around + 1, last + next, last + k);
    for (int i = 0; i + 1 < rings; ++i) {
      const int a = i * around + k, b = i * around + next;
      triangles.emplace_back(a, a + around, b + around);
      triangles.emplace_back(a, b + around, b);
    }
  }
  return soup_of(vertices, triangles);
}

ExactFoot round_part_foot(const Vec3& p) {
  const double from_axis_m = std::hypot(p.x(), p.y());
  const Vec3 outward = Vec3(p.x(), p.y(), 0) / from_axis_m, up(0, 0, p.z() < 0 ? -1 : 1);
  const Vec2 corner(from_axis_m - (round_m - fillet_m), std::abs(p.z()) - (half_height_m - fillet_m));
  if (corner.x() > 0 && corner.y() > 0) {
    const double length_m = corner.norm();
    return {length_m - fillet_m, (corner.x() * outward + corner.y() * up) / length_m};
  }
  return corner.x() > corner.y() ? ExactFoot{corner.x() - fillet_m, outward}
                                 : ExactFoot{corner.y() - fillet_m, up};
}

/// The profile at a length along it, from 7 mm off the axis over the top, the fillet and down the wall.
Vec2 round_part_profile(double length_m) {
  constexpr double flat_m = round_m - fillet_m - 0.007, arc_m = fillet_m * full_turn / 4;
  if (length_m < flat_m) return {0.007 + length_m, half_height_m};
  if (length_m > flat_m + arc_m) return {round_m, half_height_m - fillet_m - (length_m - flat_m - arc_m)};
  const double angle = (length_m - flat_m) / fillet_m;
  return {round_m - fillet_m * (1 - std::sin(angle)), half_height_m - fillet_m * (1 - std::cos(angle))};
}

ExactSurface round_part() {
  ExactSurface surface{
      "fillet", "a cylinder of radius 20 mm, rims rounded by 5 mm", {4, 8, 16, 32, 64}, {}, {}, {}, {}};
  surface.mesh = round_part_mesh;
  surface.facet_m = [](int steps) { return fillet_m * full_turn / 4 / steps; };
  surface.foot = round_part_foot;
  surface.way = [](double along) {
    const Vec2 at = round_part_profile(0.0125 - 0.012 * std::cos(7.1 * std::numbers::pi * along));
    const double around = 0.13 + 4.9 * along;
    return Vec3(at.x() * std::cos(around), at.x() * std::sin(around), at.y());
  };
  return surface;
}

}  // namespace

std::vector<ExactSurface> exact_surfaces() {
  return {sphere(), torus(), round_part()};
}

TriangleSoup ball_mesh(double radius_m, int subdivisions) {
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

TriangleSoup plate_mesh(double thickness_m) {
  // Vertex number: bit 0 is x, bit 1 is y, bit 2 is z.
  std::vector<Vec3> vertices;
  vertices.reserve(8);
  for (int i = 0; i < 8; ++i)
    vertices.emplace_back(0.06 * ((i & 1) - 0.5), 0.04 * ((i >> 1 & 1) - 0.5),
                          (i & 4) != 0 ? 0 : -thickness_m);
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

TriangleSoup hollow_ball_mesh(double thickness_m) {
  constexpr double outer_m = 0.03;
  const TriangleSoup outer = ball_mesh(outer_m, 5);
  const Eigen::Index count = outer.vertices_P.cols();
  TriangleSoup soup;
  soup.vertices_P.resize(3, 2 * count);
  soup.vertices_P << outer.vertices_P, outer.vertices_P * ((outer_m - thickness_m) / outer_m);
  soup.vertices_P.row(2).array() -= outer_m;
  IndexTriples inner = outer.triangles.array() + static_cast<int>(count);
  inner.row(1).swap(inner.row(2));
  soup.triangles.resize(3, 2 * outer.triangles.cols());
  soup.triangles << outer.triangles, inner;
  return soup;
}

}  // namespace fingerpad
