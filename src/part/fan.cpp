#include "part/fan.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <span>

namespace fingerpad {
namespace {

/// Whether a triangle of the fan turns against the polygon's own normal (Newell's sum, which is the fan's).
bool folds_over(const RawMesh& mesh, std::span<const int> corners) {
  const auto at = [&](std::size_t k) -> const Vec3& {
    return mesh.vertices[static_cast<std::size_t>(corners[k])];
  };
  const auto area = [&](std::size_t k) -> Vec3 { return (at(k) - at(0)).cross(at(k + 1) - at(0)); };
  Vec3 whole = Vec3::Zero();
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) whole += area(k);
  constexpr double rounding = 1e-6;  // flat corners come out on either side of zero
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    if (area(k).dot(whole) < -rounding * whole.squaredNorm()) return true;
  }
  return false;
}

}  // namespace

Fan fan_polygons(const RawMesh& mesh, double metres_per_unit) {
  Fan fan;
  for (int i = 0; i < mesh.polygon_count(); ++i) fan.triangles += mesh.corner_count(i) - 2;
  fan.soup.triangles.resize(3, fan.triangles);
  int number = 0, kept = 0;
  for (int i = 0; i < mesh.polygon_count(); ++i) {
    const int first = mesh.first_corner(i), count = mesh.corner_count(i);
    const std::span<const int> corners(mesh.corners.data() + first, static_cast<std::size_t>(count));
    if (std::find(corners.begin(), corners.end(), -1) != corners.end()) {
      if (fan.first_out_of_range < 0) fan.first_out_of_range = i;
      fan.out_of_range += count - 2;
      number += count - 2;
      continue;
    }
    if (count > 3 && folds_over(mesh, corners)) ++fan.concave;
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
      fan.soup.file_triangle.push_back(number++);
      fan.soup.triangles.col(kept++) << corners[0], corners[k], corners[k + 1];
    }
  }
  fan.soup.triangles.conservativeResize(3, kept);
  fan.soup.vertices_P.resize(3, static_cast<Eigen::Index>(mesh.vertices.size()));
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    fan.soup.vertices_P.col(static_cast<Eigen::Index>(v)) = metres_per_unit * mesh.vertices[v];
  }
  return fan;
}

}  // namespace fingerpad
