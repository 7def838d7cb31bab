#include "study/stable_stiffness.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "study/bench_scene.hpp"
#include "study/ringing.hpp"

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

/// Stiffness at which `stable` ends, sought upwards from well below a guess: with dry friction there may be
/// quiet islands above it.
template <typename Stable>
double border(double guess, double share, Stable stable) {
  constexpr double stride = 1.3;
  double low = guess / 2;
  for (int i = 0; !stable(low); ++i) {
    if (i == 40) return 0;
    low /= 4;
  }
  double high = low * stride;
  while (high < guess * 1e6 && stable(high)) {
    low = high;
    high *= stride;
  }
  while (high / low > 1 + share) {
    const double middle = std::sqrt(low * high);
    (stable(middle) ? low : high) = middle;
  }
  return std::sqrt(low * high);
}

/// Whether a finger pressed by 1 N settles on a wall of this stiffness.
bool settles(const HeldWall& wall, double stiffness_n_per_m) {
  constexpr double press_n = 1, seconds = 10;
  const double rest_m = -press_n / stiffness_n_per_m;
  BenchScene bench(1 / wall.tick_s);
  bench.surface().stiffness_n_per_m = stiffness_n_per_m;
  bench.surface().damping_n_s_per_m = wall.wall_damping_n_s_per_m;
  HandSettings& hand = bench.hold({.mass_kg = wall.mass_kg,
                                   .damping_n_s_per_m = wall.damping_n_s_per_m,
                                   .encoder_m = wall.encoder_m,
                                   .delay_ticks = wall.delay_ticks,
                                   .coulomb_n = wall.coulomb_n});
  // A constant push: the softest of springs, a thousandth of a newton a metre, stretched very far.
  hand.stiffness_n_per_m = 1e-3;
  for (int axis = 0; axis < 2; ++axis) hand.free_axis[axis] = false;
  const double far_m = rest_m - press_n / hand.stiffness_n_per_m;
  // Set down at rest, the push alone rocks it a little; quantum and dry friction hide that, so there it
  // starts twenty quanta too deep.
  const double start_m = rest_m - 20 * wall.encoder_m;
  ClosedLoop loop = bench.loop(seconds, [&](double t_s) { return Vec3(0, 0, t_s > 0 ? far_m : start_m); });
  Ringing ringing(loop.tick_count());
  while (!ringing.is_complete()) {
    const TickRecord record = loop.next();
    // A finger that bounces off has been thrown by the wall: it was set down near its rest.
    if (record.phase == Phase::free && !(wall.encoder_m > 0)) return false;
    ringing.observe(record.p_WQ.z());
  }
  return ringing.dies_out() || (wall.encoder_m > 0 && ringing.final_range() < wall.encoder_m);
}

}  // namespace

double exact_stable_stiffness(const HeldWall& wall) {
  return border(thumb_stiffness(wall), 1e-12, [&](double stiffness_n_per_m) {
    const Eigen::MatrixXd loop = loop_matrix(wall, stiffness_n_per_m);
    return loop.eigenvalues().cwiseAbs().maxCoeff() < 1;
  });
}

double measured_stable_stiffness(const HeldWall& wall) {
  return border(thumb_stiffness(wall), 2e-3, [&](double k) { return settles(wall, k); });
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
