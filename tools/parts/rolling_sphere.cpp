#include "rolling_sphere.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace fingerpad::parts {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double cell_mm = 3;
constexpr double nothing = -std::numeric_limits<double>::infinity();

/// The sphere resting on the line from a to b: over a point of the line a horizontal distance d away its
/// centre is sqrt(R^2 - d^2) higher; the highest of these along the line holds it.
double on_edge(const Vector3d& a, const Vector3d& b, const Vector2d& centre, double radius) {
  const Vector2d run = (b - a).head<2>();
  const double length = run.norm();
  if (length < 1e-9) {  // upright: the higher end
    const double gap2 = radius * radius - (a.head<2>() - centre).squaredNorm();
    return gap2 < 0 ? nothing : std::max(a.z(), b.z()) + std::sqrt(gap2);
  }
  const Vector2d along = run / length;
  const double foot = along.dot(centre - a.head<2>());  // along the line from a
  const double across2 = (centre - a.head<2>()).squaredNorm() - foot * foot;
  const double reach2 = radius * radius - across2;
  if (reach2 < 0) return nothing;
  const double slope = (b.z() - a.z()) / length;
  const double best = foot + slope * std::sqrt(reach2 / (1 + slope * slope));
  const double at = std::clamp(best, 0.0, length);
  const double gap2 = reach2 - (at - foot) * (at - foot);
  return gap2 < 0 ? nothing : a.z() + slope * at + std::sqrt(gap2);
}

/// The sphere resting on the inside of a triangle that faces up.
double on_face(const std::array<Vector3d, 3>& corner, const Vector2d& centre, double radius) {
  const Vector3d area = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
  if (area.z() <= 0) return nothing;
  const Vector3d normal = area.normalized();
  const Vector2d contact = centre - radius * normal.head<2>();
  for (int k = 0; k < 3; ++k) {
    const Vector2d side = (corner[(k + 1) % 3] - corner[k]).head<2>();
    const Vector2d to = contact - corner[k].head<2>();
    if (side.x() * to.y() - side.y() * to.x() < 0) return nothing;
  }
  const double z = corner[0].z() - normal.head<2>().dot(contact - corner[0].head<2>()) / normal.z();
  return z + radius * normal.z();
}

}  // namespace

RollingSphere::RollingSphere(const ClosedMesh& mesh, double radius_mm) : radius_mm_(radius_mm) {
  Vector2d low(1e30, 1e30), high(-1e30, -1e30);
  for (const auto& triangle : mesh.triangles) {
    std::array<Vector3d, 3> corner;
    for (int k = 0; k < 3; ++k) {
      const auto& v = mesh.vertices[triangle[k]];
      corner[k] = Vector3d(v[0], v[1], v[2]);
      low = low.cwiseMin(corner[k].head<2>());
      high = high.cwiseMax(corner[k].head<2>());
    }
    triangles_.push_back(corner);
  }
  x0_mm_ = low.x() - radius_mm;
  y0_mm_ = low.y() - radius_mm;
  columns_ = long((high.x() + radius_mm - x0_mm_) / cell_mm) + 1;
  rows_ = long((high.y() + radius_mm - y0_mm_) / cell_mm) + 1;
  in_reach_.resize(size_t(columns_ * rows_));
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
    const auto& [a, b, c] = triangles_[i];
    const Vector3d from = a.cwiseMin(b).cwiseMin(c).array() - radius_mm;
    const Vector3d to = a.cwiseMax(b).cwiseMax(c).array() + radius_mm;
    const Cell first = cell_of(from.x(), from.y());
    const Cell last = cell_of(to.x(), to.y());
    for (long row = first.row; row <= last.row; ++row) {
      for (long column = first.column; column <= last.column; ++column) {
        in_reach_[size_t(row * columns_ + column)].push_back(i);
      }
    }
  }
}

RollingSphere::Cell RollingSphere::cell_of(double x_mm, double y_mm) const {
  return {std::clamp(long((x_mm - x0_mm_) / cell_mm), 0L, columns_ - 1),
          std::clamp(long((y_mm - y0_mm_) / cell_mm), 0L, rows_ - 1)};
}

std::optional<double> RollingSphere::centre_height_mm(double x_mm, double y_mm) const {
  const Cell cell = cell_of(x_mm, y_mm);
  const Vector2d centre(x_mm, y_mm);
  double highest = nothing;
  for (const std::uint32_t i : in_reach_[size_t(cell.row * columns_ + cell.column)]) {
    const auto& corner = triangles_[i];
    highest = std::max(highest, on_face(corner, centre, radius_mm_));
    for (int k = 0; k < 3; ++k) {
      highest = std::max(highest, on_edge(corner[k], corner[(k + 1) % 3], centre, radius_mm_));
    }
  }
  if (highest == nothing) return std::nullopt;
  return highest;
}

}  // namespace fingerpad::parts
