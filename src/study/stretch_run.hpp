#pragma once

#include <memory>
#include <vector>

#include "base/types.hpp"
#include "motion/finger_path.hpp"
#include "study/touch_choice.hpp"

namespace fingerpad {

/// A part of a motion, by its own clock. The finger goes from `start_s` on, but only ticks from `counted_s`
/// on count: by then a proxy stands where it would, and the friction has its stretch.
struct MotionStretch {
  double start_s = 0;
  double counted_s = 0;  ///< a whole number of the slowest rate's ticks after start_s
  double end_s = 0;      ///< not counted itself
};

/// What one choice answers over a stretch, one entry a counted tick: tick k is at counted_s + k/rate.
struct StretchRun {
  double rate_hz = 0;
  std::vector<Vec3> force_W_n;       ///< whole, on the finger
  std::vector<Vec3> friction_W_n;    ///< its friction part
  std::vector<float> normal_n;       ///< sum of the normal forces; 0 while free
  std::vector<unsigned char> broke;  ///< whether stick gave way in the tick
  std::vector<float> tick_ns;        ///< how long each tick took
  long ruptures = 0, pop_throughs = 0;

  std::size_t tick_count() const noexcept { return force_W_n.size(); }
};

/// Touches a world along a stretch of a path in one way. Everything but `tick_ns` is the same at every run.
/// The finger follows the path exactly: a [hand] of the scene does not act.
/// @param path  at any rate: the choice's counts
StretchRun run_stretch(const std::shared_ptr<const World>& world, const Scene& scene, const FingerPath& path,
                       const TouchChoice& choice, const MotionStretch& stretch);

}  // namespace fingerpad
