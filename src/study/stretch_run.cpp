#include "study/stretch_run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "replay/pop_throughs.hpp"
#include "scene/scene.hpp"
#include "touch/touch.hpp"

namespace fingerpad {
namespace {

using Clock = std::chrono::steady_clock;

float nanoseconds(Clock::duration took) {
  return static_cast<float>(std::chrono::duration<double, std::nano>(took).count());
}

/// What reading the clock itself adds to a time.
float clock_ns() {
  constexpr int readings = 100;
  Clock::duration least = Clock::duration::max();
  for (int i = 0; i < readings; ++i) {
    const auto before = Clock::now();
    least = std::min(least, Clock::now() - before);
  }
  return nanoseconds(least);
}

long ticks_between(double from_s, double to_s, double rate_hz) {
  return std::lround(std::floor((to_s - from_s) * rate_hz + 1e-6));
}

}  // namespace

StretchRun run_stretch(const std::shared_ptr<const World>& world, const Scene& scene, const FingerPath& path,
                       const TouchChoice& choice, const MotionStretch& stretch) {
  const long lead_ticks = ticks_between(stretch.start_s, stretch.counted_s, choice.rate_hz);
  const long ticks = ticks_between(stretch.counted_s, stretch.end_s, choice.rate_hz);
  StretchRun run;
  run.rate_hz = choice.rate_hz;
  run.force_W_n.reserve(static_cast<std::size_t>(ticks));
  run.friction_W_n.reserve(static_cast<std::size_t>(ticks));
  run.normal_n.reserve(static_cast<std::size_t>(ticks));
  run.broke.reserve(static_cast<std::size_t>(ticks));
  run.tick_ns.reserve(static_cast<std::size_t>(ticks));
  Touch touch(world, touched_by(scene, choice));
  PopThroughs pop_throughs(world, scene.finger.radius_m);
  long led_pop_throughs = 0;
  const float reading_ns = clock_ns();
  for (long k = 0; k < lead_ticks + ticks; ++k) {
    const FingerSample sample = path.at_time(stretch.start_s + static_cast<double>(k) / choice.rate_hz);
    const auto before = Clock::now();
    const TickRecord record = touch.tick(sample);
    const auto took = Clock::now() - before;
    if (k == lead_ticks) led_pop_throughs = pop_throughs.count();
    pop_throughs.observe(record);
    if (k < lead_ticks) continue;
    run.force_W_n.push_back(record.force_W_n);
    run.friction_W_n.push_back(record.friction_W_n);
    run.normal_n.push_back(static_cast<float>(record.normal_force_n));
    run.broke.push_back(record.ruptures > 0 ? 1 : 0);
    run.tick_ns.push_back(std::max(0.0F, nanoseconds(took) - reading_ns));
    run.ruptures += record.ruptures;
  }
  run.pop_throughs = pop_throughs.count() - led_pop_throughs;
  return run;
}

}  // namespace fingerpad
