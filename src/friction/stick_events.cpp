#include "friction/stick_events.hpp"

#include <cmath>

namespace fingerpad {
namespace {

/// Where |before + u (now - before)| passes the limit inwards and outwards; `inwards` > `outwards`: nowhere.
struct Passes {
  double inwards = 1, outwards = 0;  ///< u
};

/// @pre the faster of the two is above the limit
Passes passes_of(const TickVelocity& velocity, double limit_m_per_s) noexcept {
  // In units of the greater speed, so that no square overflows.
  const double unit = std::max(length(velocity.before_m_per_s), length(velocity.now_m_per_s));
  const PlaneVector from = velocity.before_m_per_s / unit, to = velocity.now_m_per_s / unit;
  const PlaneVector turn = to - from;
  const double limit = limit_m_per_s / unit, a = turn.square(), b = -from.dot(turn);
  const double from_length = length(from), c = (from_length - limit) * (from_length + limit);
  // a u^2 - 2 b u + c = 0. A finger that turns straight back passes 0 itself, whatever the rounding.
  const double cross = from.x() * to.y() - from.y() * to.x();
  const double quarter = limit * limit * a - cross * cross;
  if (!(a > 0) || quarter < -1e-28 * a) return {};
  const double root = std::sqrt(std::max(0.0, quarter));
  // Each root by the sum that does not cancel.
  if (b > 0) return {c / (b + root), (b + root) / a};
  return {(b - root) / a, root > b ? c / (b - root) : 0};
}

}  // namespace

double TickVelocity::falls_to(double limit_m_per_s, double share) const noexcept {
  if (speed_at(share) <= limit_m_per_s) return share;
  if (share >= 0.5) return never;
  const Passes passes = passes_of(*this, limit_m_per_s);
  // Slow at this tick's middle: it falls by then, whatever the rounding.
  const double latest = length(now_m_per_s) <= limit_m_per_s ? 0.5 : never;
  const double falls = std::min(passes.inwards - 0.5, latest);
  if (passes.outwards < passes.inwards || passes.outwards - 0.5 < share || falls > 0.5) {
    return latest;
  }
  return std::max(falls, share);
}

double TickVelocity::rises_above(double limit_m_per_s, double share) const noexcept {
  if (share >= 0.5 || !(length(now_m_per_s) > limit_m_per_s)) return never;
  return std::clamp(passes_of(*this, limit_m_per_s).outwards - 0.5, share, 0.5);
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
  const double teeth = tooth > 0 ? std::min(std::floor(pulled / tooth), 1e9) : 0;
  const double last = tooth > 0 ? std::clamp(pulled - teeth * tooth, 0.0, tooth) : 0;
  const PlaneVector across = sine > 0 ? aside / sine : PlaneVector();
  const PlaneVector direction = end_cosine * along.direction + end_sine * across;
  return {(low + last) * direction, static_cast<int>(teeth)};
}

}  // namespace fingerpad
