#include "study/stick_buzz.hpp"

#include <cmath>
#include <limits>

#include "study/bench_scene.hpp"
#include "study/ringing.hpp"

namespace fingerpad {
namespace {

constexpr double surface_n_per_m = 1000;

bool is_quiet(const StuckFinger& finger, double load_n) {
  constexpr double seconds = 6, push_share = 0.1;
  BenchScene bench(finger.rate_hz, finger.law);
  bench.scene().friction.settings = finger.settings;
  bench.scene().finger.direction =
      Vec3(0, std::cos(finger.inclination_rad), -std::sin(finger.inclination_rad));
  // All laws are to have the same limits here.
  const LawEntry& law = *find_law(finger.law);
  const double raise = law.mu_raise != nullptr ? law.mu_raise(load_n) : 1;
  bench.surface() = {surface_n_per_m, 0, raise * finger.mu_static, raise * finger.mu_dynamic};
  HandSettings& hand =
      bench.hold({.mass_kg = 0.072, .damping_n_s_per_m = 0.5, .stiffness_n_per_m = 20, .encoder_m = 0});
  const int axis = finger.push_along_finger ? 1 : 0;
  for (int i = 0; i < 3; ++i) hand.free_axis[i] = i == axis;
  const double pushed_m = push_share * finger.mu_dynamic * load_n / hand.stiffness_n_per_m;
  ClosedLoop loop = bench.loop(seconds, [&](double t_s) {
    Vec3 p(0, 0, -load_n / surface_n_per_m);
    if (t_s > 0) p[axis] = pushed_m;
    return p;
  });
  // A push of a tenth of the sliding force overshoots to a fifth at most where stick is quiet.
  const double most_n = 0.3 * finger.mu_dynamic * load_n;
  // The change of speed from tick to tick: a finger that creeps steadily does not buzz.
  Ringing ringing(loop.tick_count());
  double last_m = 0, last_step_m = 0;
  while (!ringing.is_complete()) {
    const TickRecord record = loop.next();
    if (record.friction_W_n.norm() > most_n) return false;
    const double x_m = record.p_WQ[axis];
    ringing.observe(x_m - last_m - last_step_m);
    last_step_m = x_m - last_m;
    last_m = x_m;
  }
  return ringing.dies_out();
}

}  // namespace

double quiet_load_n(const StuckFinger& finger) {
  double low = 1e-3, high = 100;
  if (is_quiet(finger, high)) return std::numeric_limits<double>::infinity();
  if (!is_quiet(finger, low)) return 0;
  while (high / low > 1.005) {
    const double middle = std::sqrt(low * high);
    (is_quiet(finger, middle) ? low : high) = middle;
  }
  return std::sqrt(low * high);
}

}  // namespace fingerpad
