#pragma once

#include <TopoDS_Shape.hxx>

#include "solids.hpp"

namespace fingerpad::parts {

/// A small grip for the contact study, 30 x 22 x 20 mm, its bottom in z = 0: one face of each kind that CAD
/// has. A bicubic B-spline top, planes and cylinders for sides, a rim rounded by a rolling ball of 2.5 mm, a
/// bore with sharp edges, and a boss with a concave fillet of 2 mm at its foot and a chamfer at its top.
TopoDS_Shape grip();

/// Sizes of it that other files go by [mm].
namespace grip_size {
inline constexpr double x = 30, y = 22, corner = 6, rim = 2.5;
inline constexpr double bore_x = -8, bore_y = 0, bore_radius = 2.5;
inline constexpr double boss_x = 5, boss_y = 1, boss_radius = 3, boss_top = 20, boss_fillet = 2;
}  // namespace grip_size

/// The height of the B-spline top's surface, a bicubic polynomial of the place [mm].
double grip_top_mm(double x_mm, double y_mm);

}  // namespace fingerpad::parts
