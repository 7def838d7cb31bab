#include "friction/stick_events.hpp"

#include <cmath>

namespace fingerpad {

double rupture_share(const PlaneVector& q, const PlaneVector& p, double limit, double left) noexcept {
  // Rounding of a spring that was set exactly on the limit must not break the stick.
  constexpr double rounding = 1 + 1e-12;
  if (!is_longer(q + left * p, limit * rounding)) return TickSpeeds::never;
  if (is_longer(q, limit)) return 0;
  // |q + s p|^2 = limit^2, in units of the limit so that no square overflows or vanishes.
  const double unit = std::max(limit, 1e-140);
  const PlaneVector from = q / unit, way = p / unit;
  const double a = way.square(), b = from.dot(way), c = std::min(0.0, from.square() - 1);
  const double root = std::sqrt(b * b - a * c);
  const double share = b > 0 ? -c / (b + root) : (root - b) / a;
  return share >= 0 && share <= left ? share : (share > left ? left : 0);
}

Teeth many_teeth(const PlaneVector& q, const PlaneVector& way, double low, double high) noexcept {
  const Polar from = polar(q), along = polar(way);
  if (along.length == 0) return {q, 0};
  const double radius = 0.5 * (low + high), tooth = high - low;
  const double cosine = std::clamp(from.direction.dot(along.direction), -1.0, 1.0);
  const PlaneVector aside = from.direction - cosine * along.direction;
  const double sine = length(aside);
  // tan(angle/2) shrinks by e^(-way/radius).
  const double shrink = radius > 0 ? std::exp(-along.length / radius) : 0;
  const double tangent = 1 + cosine > 0 ? sine / (1 + cosine) * shrink : 0;
  const double end_cosine = (1 - tangent * tangent) / (1 + tangent * tangent);
  const double end_sine = 2 * tangent / (1 + tangent * tangent);
  // What the spring was stretched by: the integral of cos(angle) over the way, radius ln(sin/sin').
  const bool bends = sine > 1e-12 && end_sine > 1e-300;
  const double pulled = bends ? std::max(0.0, radius * std::log(sine / end_sine)) : along.length;
  const double teeth = tooth > 0 ? std::min(std::floor(pulled / tooth), 1e9) : 1;
  const double last = tooth > 0 ? std::clamp(pulled - teeth * tooth, 0.0, tooth) : 0;
  const PlaneVector across = sine > 0 ? aside / sine : PlaneVector();
  const PlaneVector direction = end_cosine * along.direction + end_sine * across;
  return {(low + last) * direction, static_cast<int>(teeth)};
}

}  // namespace fingerpad
