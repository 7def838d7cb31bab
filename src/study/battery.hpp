#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "study/bench_scene.hpp"

namespace fingerpad {

/// One motion of the friction study: the finger point against time, pressed into the plane z = 0 of 1000 N/m.
struct BatteryCase {
  std::string_view name;
  std::string_view motion;  ///< in words, for the chart
  double seconds;
  Vec3 (*position_W)(double t_s);
};

/// Slow drag, sine, reversal, circle, varying load, presliding oscillation; mu is 0.3 and 0.2, v_min 0.1 m/s.
std::span<const BatteryCase> battery() noexcept;

/// A law run over a case at a rate.
struct BatteryRun {
  Points friction_W_n;  ///< 3 x ticks, on the finger
  double work_j = 0;    ///< taken from the finger, trapezium rule
  double mean_load_n = 0;
  std::vector<int> ruptures;  ///< of each tick

  long rupture_count() const noexcept;
};
BatteryRun run_battery(const BatteryCase& c, const std::string& law, double rate_hz, Events events);

/// How far a run is off a finer one, compared at the coarser ticks. As shares of mu_s times the mean load,
/// and of the finer run's work.
struct BatteryError {
  double rms = 0, worst = 0, work = 0;
};
/// @param every  finer ticks per coarse tick
BatteryError battery_error(const BatteryRun& coarse, const BatteryRun& fine, long every);

/// Mean time of one tick of a law over a case, by itself (on a plane, without contact search) and as a whole
/// tick through touch [ns]; the best of several runs.
struct TickCost {
  double law_ns = 0, whole_ns = 0;
};
TickCost tick_cost(const BatteryCase& c, const std::string& law);

}  // namespace fingerpad
