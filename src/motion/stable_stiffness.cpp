#include "motion/stable_stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "motion/stiffness_border.hpp"

namespace fingerpad {
namespace {

/// Mass, damper and the hand's spring under a force F that is held over each tick:
///   x(z)/F(z) = (n0 + n1 z)/(m0 + m1 z + z^2).
struct HeldFinger {
  double n0, n1, m0, m1;
};

/// Whether the hand's spring is none, or moves so little within a tick that what it does is lost in rounding.
bool is_springless(const HeldWall& wall) {
  return !(wall.hand_stiffness_n_per_m * wall.tick_s * wall.tick_s > 1e-9 * wall.mass_kg);
}

HeldFinger held_without_spring(double b, double m, double t) {
  const double gone = -std::expm1(-b * t / m), a = 1 - gone;
  const double v_per_force = gone / b, x_per_force = (t - m / b * gone) / b;
  return {m / b * gone * v_per_force - a * x_per_force, x_per_force, a, -(1 + a)};
}

/// A finger whose free motion is a sum of exp(-slow t) and exp(-fast t), which are apart: each by itself, as
/// a strong damper makes one of them nothing and the other hardly any change within a tick.
HeldFinger held_by_strong_damper(double k, double m, double t, double slow, double fast) {
  const double apart = fast - slow, slow_gone = -std::expm1(-slow * t), fast_gone = -std::expm1(-fast * t);
  const double x_per_force = (fast * slow_gone - slow * fast_gone) / (apart * k),
               v_from_v = (fast * (1 - fast_gone) - slow * (1 - slow_gone)) / apart,
               x_from_v = (fast_gone - slow_gone) / apart;
  return {x_from_v * x_from_v / m - v_from_v * x_per_force, x_per_force, (1 - slow_gone) * (1 - fast_gone),
          slow_gone + fast_gone - 2};
}

/// As the exponential of [[0, 1], [-k/m, -b/m]] t takes x and v over a tick.
HeldFinger held_finger(const HeldWall& wall) {
  constexpr double apart = 1e-3;  // of exponents: closer ones would leave little of their difference
  const double b = std::max(wall.damping_n_s_per_m, 1e-6), m = wall.mass_kg, t = wall.tick_s,
               k = wall.hand_stiffness_n_per_m;
  if (is_springless(wall)) return held_without_spring(b, m, t);
  const double decay = b / (2 * m), turn = k / m - decay * decay, s = std::sqrt(std::abs(turn));
  if (turn < 0 && s * t > apart) return held_by_strong_damper(k, m, t, k / m / (decay + s), decay + s);
  const double left = std::exp(-decay * t), c = left * (turn > 0 ? std::cos(s * t) : std::cosh(s * t));
  const double x_from_v =
      s * t < 1e-8 ? left * t : left * (turn > 0 ? std::sin(s * t) : std::sinh(s * t)) / s;
  const double x_per_force = (1 - c - decay * x_from_v) / k, v_from_v = c - decay * x_from_v;
  return {x_from_v * x_from_v / m - v_from_v * x_per_force, x_per_force, left * left, -2 * c};
}

/// The polynomial whose roots are the eigenvalues of the loop over one tick; its coefficients, the constant
/// first. The wall answers a held finger by F(z) = -(K + B/T (1 - 1/z)) x(z)/z^d.
std::vector<double> loop_polynomial(const HeldWall& wall, double stiffness_n_per_m) {
  const HeldFinger finger = held_finger(wall);
  const double before = -wall.wall_damping_n_s_per_m / wall.tick_s, now = stiffness_n_per_m - before;
  const auto d = static_cast<std::size_t>(wall.delay_ticks);
  std::vector<double> p(d + 4, 0.0);
  p[0] = finger.n0 * before;
  p[1] = finger.n1 * before + finger.n0 * now;
  p[2] = finger.n1 * now;
  p[d + 1] += finger.m0;
  p[d + 2] += finger.m1;
  p[d + 3] += 1;
  return p;
}

/// Whether all roots lie inside the unit circle: Schur and Cohn's test, by steps each of which lowers the
/// degree by one (Jury, Theory and Application of the z-Transform Method, 1964, chapter 3).
bool has_roots_inside_unit_circle(std::vector<double> p) {
  std::vector<double> lower;
  while (p.size() > 1) {
    const double ratio = p.front() / p.back();
    if (!(std::abs(ratio) < 1)) return false;
    lower.resize(p.size() - 1);
    for (std::size_t k = 0; k < lower.size(); ++k) lower[k] = p[k + 1] - ratio * p[lower.size() - 1 - k];
    p.swap(lower);
  }
  return true;
}

}  // namespace

double stable_stiffness(const HeldWall& wall) {
  return stiffness_border(thumb_stiffness(wall), 1e-12, [&](double stiffness_n_per_m) {
    return has_roots_inside_unit_circle(loop_polynomial(wall, stiffness_n_per_m));
  });
}

double colgate_schenkel_stiffness(const HeldWall& wall) {
  if (wall.delay_ticks > 0) return std::numeric_limits<double>::quiet_NaN();
  return std::max(0.0, 2 * (wall.damping_n_s_per_m - std::abs(wall.wall_damping_n_s_per_m)) / wall.tick_s);
}

double abbott_okamura_stiffness(const HeldWall& wall) {
  if (wall.delay_ticks > 0 || wall.wall_damping_n_s_per_m != 0) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double viscous = 2 * wall.damping_n_s_per_m / wall.tick_s;
  return wall.encoder_m > 0 ? std::min(viscous, 2 * wall.coulomb_n / wall.encoder_m) : viscous;
}

double thumb_stiffness(const HeldWall& wall) {
  return (wall.damping_n_s_per_m + wall.wall_damping_n_s_per_m) / ((wall.delay_ticks + 0.5) * wall.tick_s);
}

}  // namespace fingerpad
