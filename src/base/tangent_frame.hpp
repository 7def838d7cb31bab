#pragma once

#include "base/types.hpp"

namespace fingerpad {

/// A contact frame C with Cz along the unit normal: columns Cx, Cy, Cz. Cy is `along` projected into the
/// tangent plane; where that vanishes, an axis is chosen that depends on the normal alone.
Mat3 tangent_frame(const Vec3& normal, const Vec3& along) noexcept;

/// The frame turned by the smallest rotation that takes its Cz onto `normal` (parallel transport). For an
/// opposite normal the turn is by pi about Cx.
Mat3 transported(const Mat3& frame, const Vec3& normal) noexcept;

/// Displacement along a curved surface from point c to point s [m], in the tangent plane at s.
///
/// With chord r = s - c and phi the angle between the normals: the part of r along n_c x n_s keeps its
/// length, the part across it is stretched by (phi/2)/sin(phi/2) (the arc of a cylinder or sphere) and turned
/// by phi/2 into the tangent plane at s. On a plane the result is s - c, to rounding.
Vec3 surface_displacement(const Vec3& c, const Vec3& normal_c, const Vec3& s, const Vec3& normal_s) noexcept;

}  // namespace fingerpad
