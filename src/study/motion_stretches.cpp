#include "study/motion_stretches.hpp"

#include <algorithm>
#include <cmath>

#include "base/random_stream.hpp"
#include "scene/scene.hpp"
#include "touch/touch.hpp"

namespace fingerpad {
namespace {

/// Stretches begin and count from ticks that all rates have.
constexpr double grid_hz = 250;
constexpr double longest_lead_s = 2, lead_in_contact_s = 0.5;
/// Another number than that of the scene's own random stream.
constexpr std::uint64_t stretch_stream = 1;

/// The moment to begin at, `counted_s` less a whole number of the slowest ticks.
double begin_s(const std::shared_ptr<const World>& world, const Scene& scene, const FingerPath& path,
               double counted_s) {
  TouchChoice scout = model_choice();
  scout.rate_hz = 1000;
  const double elapsed_s = counted_s - path.start_s();
  const auto lead = [&](double longest_s) {
    return std::floor(std::min(longest_s, elapsed_s) * grid_hz) / grid_hz;
  };
  const double from_s = counted_s - lead(longest_lead_s);
  // The scout starts cold; wherever it says free, it is free of what it began with, too.
  Touch touch(world, touched_by(scene, scout));
  const auto steps_per_grid = static_cast<long>(scout.rate_hz / grid_hz);
  double free_s = counted_s - lead(lead_in_contact_s);
  for (long k = 0; from_s + static_cast<double>(k) / scout.rate_hz < counted_s; ++k) {
    const TickRecord record = touch.tick(path.at_time(from_s + static_cast<double>(k) / scout.rate_hz));
    if (record.phase == Phase::free && k % steps_per_grid == 0)
      free_s = from_s + static_cast<double>(k) / scout.rate_hz;
  }
  return free_s;
}

}  // namespace

std::vector<MotionStretch> motion_stretches(const std::shared_ptr<const World>& world, const Scene& scene,
                                            const FingerPath& path) {
  const double start_s = path.start_s(), whole_s = path.end_s() - start_s;
  if (whole_s <= compared_s) return {{start_s, start_s, path.end_s()}};
  constexpr double each_s = compared_s / stretch_count;
  RandomStream random(scene.seed, stretch_stream);
  std::vector<MotionStretch> stretches;
  for (int i = 0; i < stretch_count; ++i) {
    const double room_s = whole_s / stretch_count - each_s;
    const double drawn_s = i * whole_s / stretch_count + random.uniform() * room_s;
    const double counted_s = start_s + std::floor(drawn_s * grid_hz) / grid_hz;
    stretches.push_back({begin_s(world, scene, path, counted_s), counted_s, counted_s + each_s});
  }
  return stretches;
}

}  // namespace fingerpad
