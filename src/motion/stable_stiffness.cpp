#include "motion/stable_stiffness.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/stiffness_border.hpp"

namespace fingerpad {
namespace {

/// Loop over one tick on the state (x, v, x of the last tick, forces on the way, oldest last).
Eigen::MatrixXd loop_matrix(const HeldWall& wall, double stiffness_n_per_m) {
  const double b = std::max(wall.damping_n_s_per_m, 1e-6), m = wall.mass_kg, t = wall.tick_s;
  const double gone = -std::expm1(-b * t / m);  // share of a velocity lost over the tick
  const double v_per_force = gone / b, x_per_force = (t - m / b * gone) / b;
  const auto d = static_cast<Eigen::Index>(wall.delay_ticks);
  Eigen::MatrixXd loop = Eigen::MatrixXd::Zero(3 + d, 3 + d);
  loop(0, 0) = 1;
  loop(0, 1) = m / b * gone;
  loop(1, 1) = 1 - gone;
  loop(2, 0) = 1;
  Eigen::RowVectorXd computed = Eigen::RowVectorXd::Zero(3 + d);
  computed(0) = -stiffness_n_per_m - wall.wall_damping_n_s_per_m / t;
  computed(2) = wall.wall_damping_n_s_per_m / t;
  Eigen::RowVectorXd displayed = computed;
  if (d > 0) {
    displayed = Eigen::RowVectorXd::Unit(3 + d, 2 + d);
    loop.row(3) = computed;
    for (Eigen::Index i = 1; i < d; ++i) loop(3 + i, 2 + i) = 1;
  }
  loop.row(0) += x_per_force * displayed;
  loop.row(1) += v_per_force * displayed;
  return loop;
}

}  // namespace

double exact_stable_stiffness(const HeldWall& wall) {
  return stiffness_border(thumb_stiffness(wall), 1e-12, [&](double stiffness_n_per_m) {
    const Eigen::MatrixXd loop = loop_matrix(wall, stiffness_n_per_m);
    return loop.eigenvalues().cwiseAbs().maxCoeff() < 1;
  });
}

double stable_stiffness(const HeldWall& wall) {
  constexpr int longest_exact =
      20;  // the loop's matrix grows with the delay, its eigenvalues' cost with the cube
  return wall.delay_ticks <= longest_exact ? exact_stable_stiffness(wall) : thumb_stiffness(wall);
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
