#include "study/shape_meshes.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace fingerpad {
namespace {

constexpr double full_turn = 2 * std::numbers::pi, quarter_turn = full_turn / 4;

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

}  // namespace

TriangleSoup torus_mesh(double ring_m, double tube_m, int around, int across) {
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

TriangleSoup hollowed(const TriangleSoup& outer, const TriangleSoup& inner) {
  TriangleSoup soup;
  const Eigen::Index count = outer.vertices_P.cols();
  soup.vertices_P.resize(3, count + inner.vertices_P.cols());
  soup.vertices_P << outer.vertices_P, inner.vertices_P;
  IndexTriples turned = inner.triangles.array() + static_cast<int>(count);
  turned.row(1).swap(turned.row(2));
  soup.triangles.resize(3, outer.triangles.cols() + turned.cols());
  soup.triangles << outer.triangles, turned;
  return soup;
}

TriangleSoup revolved_mesh(const std::vector<Vec2>& profile, int around, double top_m, double bottom_m) {
  std::vector<Vec3> vertices;
  std::vector<Eigen::Vector3i> triangles;
  const int rings = static_cast<int>(profile.size());
  for (const Vec2& at : profile) {
    for (int k = 0; k < around; ++k)
      vertices.emplace_back(at.x() * std::cos(full_turn * k / around),
                            at.x() * std::sin(full_turn * k / around), at.y());
  }
  vertices.emplace_back(0, 0, top_m);
  vertices.emplace_back(0, 0, bottom_m);
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

TriangleSoup bar_mesh(const std::vector<Vec2>& profile, double half_width_m, double bottom_m) {
  std::vector<Vec3> vertices;  // four a point: the top's and the bottom's, on the near side and the far
  std::vector<Eigen::Vector3i> triangles;
  const auto quad = [&triangles](int a, int b, int c, int d) {
    triangles.emplace_back(a, b, c);
    triangles.emplace_back(a, c, d);
  };
  for (const Vec2& at : profile) {
    for (const double z_m : {at.y(), bottom_m})
      for (const double y_m : {-half_width_m, half_width_m}) vertices.emplace_back(at.x(), y_m, z_m);
  }
  const int last = 4 * (static_cast<int>(profile.size()) - 1);
  for (int i = 0; i < last; i += 4) {
    quad(i, i + 4, i + 5, i + 1);
    quad(i + 2, i + 3, i + 7, i + 6);
    quad(i, i + 2, i + 6, i + 4);
    quad(i + 1, i + 5, i + 7, i + 3);
  }
  quad(0, 1, 3, 2);
  quad(last, last + 2, last + 3, last + 1);
  return soup_of(vertices, triangles);
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
  TriangleSoup soup = hollowed(outer, ball_mesh(outer_m - thickness_m, 5));
  soup.vertices_P.row(2).array() -= outer_m;
  return soup;
}

TriangleSoup rounded_block_mesh(const Vec3& inner_half_m, double rounding_m, int steps) {
  // A globe whose lines of longitude stand twice where quarters meet, and whose equator does, drawn apart.
  const int around = 4 * (steps + 1), up = 2 * (steps + 1);
  TriangleSoup soup;
  soup.vertices_P.resize(3, Eigen::Index{around} * up);
  for (int j = 0; j < up; ++j) {
    const bool is_north = j > steps;
    const double latitude = quarter_turn * (static_cast<double>(is_north ? j - 1 : j) / steps - 1);
    for (int i = 0; i < around; ++i) {
      const int quarter = i / (steps + 1);
      const double longitude = quarter_turn * (quarter + static_cast<double>(i % (steps + 1)) / steps);
      const Vec3 middle((quarter == 0 || quarter == 3 ? 1 : -1) * inner_half_m.x(),
                        (quarter < 2 ? 1 : -1) * inner_half_m.y(), (is_north ? 1 : -1) * inner_half_m.z());
      soup.vertices_P.col(Eigen::Index{j} * around + i) =
          middle + rounding_m * Vec3(std::cos(latitude) * std::cos(longitude),
                                     std::cos(latitude) * std::sin(longitude), std::sin(latitude));
    }
  }
  std::vector<Eigen::Vector3i> triangles;
  for (int j = 0; j + 1 < up; ++j) {
    for (int i = 0; i < around; ++i) {
      const int a = j * around + i, b = j * around + (i + 1) % around;
      // At a pole a quarter's vertices are one; the edge to the next quarter is a flat side's.
      const bool is_within_quarter = i % (steps + 1) != steps;
      if (j > 0 || !is_within_quarter) triangles.emplace_back(a, b, b + around);
      if (j + 2 < up || !is_within_quarter) triangles.emplace_back(a, b + around, a + around);
    }
  }
  const int top = (up - 1) * around, quarter = steps + 1;
  triangles.emplace_back(top, top + quarter, top + 2 * quarter);
  triangles.emplace_back(top, top + 2 * quarter, top + 3 * quarter);
  triangles.emplace_back(0, 2 * quarter, quarter);
  triangles.emplace_back(0, 3 * quarter, 2 * quarter);
  soup.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
  for (std::size_t k = 0; k < triangles.size(); ++k)
    soup.triangles.col(static_cast<Eigen::Index>(k)) = triangles[k];
  return soup;
}

}  // namespace fingerpad
