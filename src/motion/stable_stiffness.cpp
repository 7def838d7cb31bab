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

/// Between the hand's spring and none there is no gap: so soft a one moves nothing within a tick.
bool is_springless(const HeldWall& wall) {
  return !(wall.hand_stiffness_n_per_m * wall.tick_s * wall.tick_s > 1e-9 * wall.mass_kg);
}

HeldFinger held_finger(const HeldWall& wall) {
  const double b = std::max(wall.damping_n_s_per_m, 1e-6), m = wall.mass_kg, t = wall.tick_s;
  if (is_springless(wall)) {
    const double gone = -std::expm1(-b * t / m), a = 1 - gone;
    const double v_per_force = gone / b, x_per_force = (t - m / b * gone) / b;
    return {m / b * gone * v_per_force - a * x_per_force, x_per_force, a, -(1 + a)};
  }
  // x and v after a tick as the matrix exponential of [[0, 1], [-k/m, -b/m]] t gives them.
  const double k = wall.hand_stiffness_n_per_m, decay = b / (2 * m), turn = k / m - decay * decay;
  const double s = std::sqrt(std::abs(turn)), left = std::exp(-decay * t);
  const double c = left * (turn > 0 ? std::cos(s * t) : std::cosh(s * t));
  const double sine = s * t < 1e-8 ? left * t : left * (turn > 0 ? std::sin(s * t) : std::sinh(s * t)) / s;
  const double xx = c + decay * sine, xv = sine, vv = c - decay * sine;
  const double x_per_force = (1 - xx) / k, v_per_force = sine / m;
  return {xv * v_per_force - vv * x_per_force, x_per_force, left * left, -2 * c};
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
