#pragma once

#include <algorithm>

#include "friction/plane_vector.hpp"

namespace fingerpad {

/// The finger's velocity over a tick, against the share of the tick that has passed. A velocity measured over
/// a tick belongs to its middle: it runs straight from the last tick's middle (share -1/2) to this one's
/// (1/2), and stays as it is from there on, until the next tick tells better. As vectors: a finger that turns
/// back between two middles has stopped in between, however fast it is at both.
struct TickVelocity {
  static constexpr double never = 2;  ///< a share beyond the tick

  PlaneVector before_m_per_s, now_m_per_s;

  /// @pre share in -1/2 .. 1
  double speed_at(double share) const noexcept {
    if (share >= 0.5) return length(now_m_per_s);
    return length(before_m_per_s + (share + 0.5) * (now_m_per_s - before_m_per_s));
  }
  /// The first share from `share` on at which the speed is at or below the limit.
  double falls_to(double limit_m_per_s, double share) const noexcept;
  /// The same, where only a fall through the limit counts, not a speed below it all the time.
  double falls_through(double limit_m_per_s, double share) const noexcept {
    return speed_at(share) > limit_m_per_s ? falls_to(limit_m_per_s, share) : never;
  }
  /// The first share from `share` on at which the speed rises above the limit.
  /// @pre not above it at `share`
  double rises_above(double limit_m_per_s, double share) const noexcept;

  /// Whether the speed is nowhere above the limit: a ball of velocities holds the way between two of its own.
  bool is_nowhere_above(double limit_m_per_s) const noexcept {
    return !is_longer(now_m_per_s, limit_m_per_s) && !is_longer(before_m_per_s, limit_m_per_s);
  }
  /// Whether the speed stays above the limit from one middle to the other; false also where that is not plain
  /// to see. |before + u (now - before)|^2 is a mean, with weights (1-u)^2, 2 u (1-u) and u^2, of these
  /// three.
  bool is_plainly_above(double limit_m_per_s) const noexcept {
    const double square = limit_m_per_s * limit_m_per_s;
    return now_m_per_s.square() > square && before_m_per_s.square() > square &&
           before_m_per_s.dot(now_m_per_s) > square;
  }
};

/// A force ratio q on its way through a tick: q + s p after the share s.
/// @returns the share at which |q| passes the limit outwards, 0 where it is beyond already; `never` where it
/// is not passed within `left`
inline double rupture_share(const PlaneVector& q, const PlaneVector& p, double limit, double left) noexcept {
  // Rounding of a spring that was set exactly on the limit must not break the stick.
  constexpr double rounding = 1 + 1e-12;
  if (!is_longer(q + left * p, limit * rounding)) return TickVelocity::never;
  if (is_longer(q, limit)) return 0;
  // |q + s p|^2 = limit^2; in units of the limit where a square might overflow or vanish.
  PlaneVector from = q, way = p;
  double limit_square = limit * limit;
  if (!(limit > 1e-70 && limit < 1e70 && p.square() < 1e140)) [[unlikely]] {
    const double unit = std::max(limit, 1e-140);
    from = q / unit;
    way = p / unit;
    limit_square = 1;
  }
  const double a = way.square(), b = from.dot(way), c = std::min(0.0, from.square() - limit_square);
  const double root = std::sqrt(b * b - a * c);
  const double share = b > 0 ? -c / (b + root) : (root - b) / a;
  return share >= 0 && share <= left ? share : (share > left ? left : 0);
}

/// What a spring that has ruptured at `high` falls to, along itself.
/// @param passed  the rupture_share: above 0 q stands on the limit, so that its length need not be told anew
inline PlaneVector fallen(const PlaneVector& q, double passed, double low, double high) noexcept {
  return passed > 0 ? (low / high) * q : low * direction_of(q);
}

/// A sawtooth over the rest of a way, each tooth from |q| = low to |q| = high and back along q.
struct Teeth {
  PlaneVector ratio;  ///< where it ends
  int count = 0;      ///< ruptures
};

/// The teeth all at once, as the limit of small ones: q's direction follows the way as a dragged point does
/// (a tractrix of radius (low + high)/2). Where low = high it is dragged along and never ruptures; so it is
/// where there would be over a million teeth: it counts none and ends at the limit.
/// @param q     on the way out of a tooth's end, |q| = low
/// @param way   what is left of the way, as a ratio
Teeth many_teeth(const PlaneVector& q, const PlaneVector& way, double low, double high) noexcept;

}  // namespace fingerpad
