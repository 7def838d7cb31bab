#pragma once

#include <cmath>
#include <limits>
#include <utility>

#include "base/types.hpp"

namespace fingerpad {

/// A segment prepared to be tested against many triangles (Woop, Benthin & Wald, "Watertight ray/triangle
/// intersection", JCGT 2013), in double.
///
/// Every corner is sheared by itself, so that it comes to the same place for all triangles that share it; the
/// sign of an edge function is then right or zero, and zero counts as inside on both sides of the edge. So
/// nothing slips through an edge whose two triangles have the same corners, bit for bit.
class SegmentCrossing {
 public:
  /// @pre from and to finite and not the same
  SegmentCrossing(const Vec3& from, const Vec3& to) noexcept : from_(from) {
    const Vec3 way = to - from;
    way.cwiseAbs().maxCoeff(&z_);
    x_ = (z_ + 1) % 3;
    y_ = (z_ + 2) % 3;
    if (way[z_] < 0) std::swap(x_, y_);
    shear_x_ = way[x_] / way[z_];
    shear_y_ = way[y_] / way[z_];
    length_z_m_ = way[z_];
  }

  /// How far along the segment (0 its start, 1 its end) it passes through the triangle against its normal;
  /// infinite where it does not.
  double entry(const Vec3& a, const Vec3& b, const Vec3& c) const noexcept {
    constexpr double none = std::numeric_limits<double>::infinity();
    const Vec3 pa = sheared(a), pb = sheared(b), pc = sheared(c);
    // Twice the areas that the origin spans with the edges, as seen along the segment.
    const double u = pc.x() * pb.y() - pc.y() * pb.x();
    const double v = pa.x() * pc.y() - pa.y() * pc.x();
    const double w = pb.x() * pa.y() - pb.y() * pa.x();
    if (u < 0 || v < 0 || w < 0) return none;  // beside it, or from the inside
    const double whole = u + v + w;
    if (!(whole > 0)) return none;
    const double along = (u * pa.z() + v * pb.z() + w * pc.z()) / whole / length_z_m_;
    return along >= 0 && along <= 1 ? std::abs(along) : none;  // abs: a zero without sign
  }

 private:
  Vec3 sheared(const Vec3& p) const noexcept {
    const Vec3 r = p - from_;
    return {r[x_] - shear_x_ * r[z_], r[y_] - shear_y_ * r[z_], r[z_]};
  }

  Vec3 from_;
  int x_ = 0, y_ = 1, z_ = 2;
  double shear_x_ = 0, shear_y_ = 0, length_z_m_ = 1;
};

}  // namespace fingerpad
