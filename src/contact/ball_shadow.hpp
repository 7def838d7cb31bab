#pragma once

#include <algorithm>
#include <cmath>

#include "contact/triangle_approach.hpp"
#include "contact/triangle_packet.hpp"

namespace fingerpad {

/// A point of a surface that a ball keeps its clearance from, wherever it goes.
struct KeptPoint {
  Vec3 point;          ///< relative to the part's centre [m]
  double clearance_m;  ///< what the ball keeps from every triangle, > 0 ...
  double missed_m;     ///< ... but for at most so much, less than the clearance
};

/// What stands in the shadow of a point of a surface: a ball that keeps clear of that point and goes no
/// farther than a reach about a place cannot come near it. Where a ball lies on fine facets these are nearly
/// all that are within reach, beside the point and behind its plane.
///
/// With c the point, D its distance from the place, n the way from it to the place, R the clearance, r the
/// reach, m what the clearance may be missed by: for q within r of the place and at least R - m away from c,
/// |q - place|^2 + 2 D n.(q - place) + D^2 >= (R - m)^2, so that q stands at least R - dip above c's plane,
/// where dip = (r^2 - (D - R + m)^2) / 2 D + m. A point t of the height h above this plane and the distance d
/// from the axis along n is nearer to q than R only if dip + h > 0 and d < r + sqrt(2 R (dip + h)). The place
/// itself need not keep the clearance. The point's own triangle is in the shadow only if dip <= 0, and then
/// the clearance from the point is kept all over the reach: what is left still sees to it that it is kept.
/// Rounding lets what is covered come nearer by some 1e-15 of the scaled lengths, far below any tolerance.
class BallShadow {
 public:
  /// @param scale  of the lengths that are asked about, to metres
  BallShadow(const Vec3& place, double reach_m, const KeptPoint& kept, double scale) noexcept
      : point_(scale * kept.point), reach_(scale * reach_m), clearance2_(2 * scale * kept.clearance_m) {
    const Vec3 way = place - kept.point;
    const double distance_m = way.norm(), least_m = kept.clearance_m - kept.missed_m;
    outwards_ = way / distance_m;
    const double dip_m =
        (reach_m - (distance_m - least_m)) * (reach_m + (distance_m - least_m)) / (2 * distance_m) +
        kept.missed_m;
    dip_ = scale * dip_m;
  }

  /// Whether there is one at all: beyond such a reach it gets too thin, and without any place within reach
  /// that keeps the clearance it means nothing.
  static bool is_cast(const Vec3& place, double reach_m, const KeptPoint& kept) noexcept {
    const double distance_m = (place - kept.point).norm(), least_m = kept.clearance_m - kept.missed_m;
    return reach_m >= 0 && reach_m < kept.clearance_m / 2 && distance_m > kept.clearance_m / 2 &&
           least_m > 0 && distance_m + reach_m >= least_m;
  }

  bool covers(const TrianglePacket& packet) const noexcept {
    const Vec3 way = packet.origin - point_;
    const double height = outwards_.dot(way), radius = static_cast<double>(packet.radius);
    if (dip_ + height + 1.5 * radius <= 0) return true;  // `highest` is at most sqrt(2) of the radius
    const double beside = std::sqrt(std::max(0.0, way.squaredNorm() - height * height)) - radius;
    return covers(height + packet.highest(outwards_), beside);
  }

  /// @param corners  scaled
  bool covers(const std::array<Vec3, 3>& corners) const noexcept {
    const Vec3 a = corners[0] - point_, b = corners[1] - point_, c = corners[2] - point_;
    const double height_a = outwards_.dot(a), height_b = outwards_.dot(b), height_c = outwards_.dot(c);
    const double highest = std::max({height_a, height_b, height_c});
    if (dip_ + highest <= 0) return true;  // wherever it is beside the axis
    // No point of it is nearer to the axis than its corners are along any way away from it.
    const Vec3 sum = a + b + c;
    const Vec3 aside = sum - (height_a + height_b + height_c) * outwards_;
    const double length = aside.norm();
    if (!(length > 0)) return covers(highest, 0);
    // About the axis `aside` is but rounding, which may point along it: that share does not count.
    const double along = aside.dot(outwards_);
    const double beside = std::min(
        {aside.dot(a) - along * height_a, aside.dot(b) - along * height_b, aside.dot(c) - along * height_c});
    return covers(highest, beside / length);
  }

 private:
  bool covers(double highest, double beside) const noexcept {
    const double lift = dip_ + highest, beyond = beside - reach_;
    return lift <= 0 || (beyond > 0 && beyond * beyond > clearance2_ * lift);
  }

  Vec3 point_, outwards_;
  double reach_, clearance2_, dip_;
};

}  // namespace fingerpad
