#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "closed_mesh.hpp"

namespace fingerpad::parts {

/// How high the centre of a sphere stands that is lowered along -z onto a mesh until it touches: the surface
/// a round fingertip's centre follows when it rolls over the part without pressing. Exact for the triangles
/// given.
class RollingSphere {
 public:
  RollingSphere(const ClosedMesh& mesh, double radius_mm);

  /// Nothing where the sphere would miss the part.
  std::optional<double> centre_height_mm(double x_mm, double y_mm) const;

 private:
  struct Cell {
    long column, row;
  };
  Cell cell_of(double x_mm, double y_mm) const;

  double radius_mm_;
  std::vector<std::array<Eigen::Vector3d, 3>> triangles_;
  double x0_mm_ = 0, y0_mm_ = 0;
  long columns_ = 0, rows_ = 0;
  std::vector<std::vector<std::uint32_t>>
      in_reach_;  ///< per cell: the triangles within the radius, seen from above
};

}  // namespace fingerpad::parts
