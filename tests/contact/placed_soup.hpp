#pragma once

#include <Eigen/Geometry>

#include "contact/placed_surface.hpp"
#include "support/shapes.hpp"

namespace fingerpad::test {

/// A part that is turned and shifted, with creases from half a radian.
inline PlacedSurface placed(const TriangleSoup& soup) {
  PlacedSurface surface;
  surface.part = std::make_shared<const Part>(make_part(soup, 0.5));
  surface.R_WP = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  surface.p_WP = Vec3(0.3, -0.2, 0.1);
  return surface;
}

}  // namespace fingerpad::test
