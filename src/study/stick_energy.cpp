#include "study/stick_energy.hpp"

#include <algorithm>
#include <cmath>

#include "study/bench_scene.hpp"

namespace fingerpad {
namespace {

constexpr double stage_s = 0.01;
constexpr double cycle_rate_hz = 100000;

/// 0 before stage `from` (counted from 0), 1 after it, linear within.
double ramp(double t_s, int from) {
  return std::clamp(t_s / stage_s - from, 0.0, 1.0);
}

}  // namespace

double energy_of_cycle(const StickCycle& cycle) {
  BenchScene bench(cycle_rate_hz, cycle.law);
  const double stiffness = bench.surface().stiffness_n_per_m;
  Touch touch(load_world(bench.scene()), bench.scene());
  const auto ticks = static_cast<long>(4 * stage_s * cycle_rate_hz);
  double work_j = 0, last_x_m = 0, last_force_n = 0;
  for (long k = 0; k <= ticks; ++k) {
    // Stages: rest, stretch, change at rest, back.
    const double t_s = static_cast<double>(k) / cycle_rate_hz;
    const double x_m = cycle.stretch_m * (ramp(t_s, 1) - ramp(t_s, 3));
    const double load_n = cycle.stretched_n + (cycle.released_n - cycle.stretched_n) * ramp(t_s, 2);
    const double angle = cycle.stretched_rad + (cycle.released_rad - cycle.stretched_rad) * ramp(t_s, 2);
    FingerSample sample;
    sample.t_s = t_s;
    sample.p_WQ = Vec3(x_m, 0, -load_n / stiffness);
    sample.direction_W = Vec3(0, std::cos(angle), -std::sin(angle));
    const double force_n = touch.tick(sample).friction_W_n.x();
    work_j += (force_n + last_force_n) / 2 * (x_m - last_x_m);
    last_x_m = x_m;
    last_force_n = force_n;
  }
  return work_j;
}

}  // namespace fingerpad
