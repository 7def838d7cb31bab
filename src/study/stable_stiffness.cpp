#include "study/stable_stiffness.hpp"

#include "motion/stiffness_border.hpp"
#include "study/bench_scene.hpp"
#include "study/ringing.hpp"

namespace fingerpad {
namespace {

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

double measured_stable_stiffness(const HeldWall& wall) {
  return stiffness_border(thumb_stiffness(wall), 2e-3, [&](double k) { return settles(wall, k); });
}

}  // namespace fingerpad
