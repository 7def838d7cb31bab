#pragma once

#include <functional>
#include <vector>

#include "support/worlds.hpp"
#include "touch/touch.hpp"

namespace fingerpad::test {

/// The plane through a point with an outward normal, and the default surface.
inline Surface plane_surface(const Vec3& point_W, const Vec3& normal_W) {
  Surface surface;
  surface.plane_point_W = point_W;
  surface.plane_normal_W = normal_W.normalized();
  return surface;
}

/// Runs a finger through a fresh Touch, given its place at every tick.
inline std::vector<TickRecord> run_finger(const std::shared_ptr<const World>& world, const Scene& scene,
                                          long ticks, const std::function<FingerSample(long)>& sample) {
  Touch touch(world, scene);
  std::vector<TickRecord> rows;
  for (long k = 0; k < ticks; ++k) {
    FingerSample at = sample(k);
    at.t_s = static_cast<double>(k) / scene.motion.rate_hz;
    rows.push_back(touch.tick(at));
  }
  return rows;
}

/// A finger that only moves, pointing as by default.
inline std::vector<TickRecord> run_places(const std::shared_ptr<const World>& world, const Scene& scene,
                                          long ticks, const std::function<Vec3(long)>& place) {
  return run_finger(world, scene, ticks, [&](long k) {
    FingerSample sample;
    sample.p_WQ = place(k);
    return sample;
  });
}

inline long ruptures_of(const std::vector<TickRecord>& rows) {
  long sum = 0;
  for (const TickRecord& row : rows) sum += row.ruptures;
  return sum;
}

/// What friction has given to the finger: with the mean of each tick's two forces, as a spring is charged.
inline double friction_work_j(const std::vector<TickRecord>& rows) {
  double sum = 0;
  for (std::size_t k = 1; k < rows.size(); ++k)
    sum += 0.5 * (rows[k].friction_W_n + rows[k - 1].friction_W_n).dot(rows[k].p_WQ - rows[k - 1].p_WQ);
  return sum;
}

}  // namespace fingerpad::test
