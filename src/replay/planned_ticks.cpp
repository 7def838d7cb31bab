#include "replay/planned_ticks.hpp"

#include <algorithm>

#include "replay/motion_key.hpp"
#include "scene/scene_reader.hpp"
#include "trace/motion_source.hpp"

namespace fingerpad {

long PlannedTicks::of(const Scene& scene) {
  // Neither the part nor the law need be looked at for it.
  if (scene.motion.laid && !scene.motion.automatic_rate)
    return tick_count(duration_s(*scene.motion.laid, pressed_depth_m(scene)), scene.motion.rate_hz);
  const std::string key = motion_key(scene);
  if (const auto known = counts_.find(key); known != counts_.end()) return known->second;
  if (const auto known = refusals_.find(key); known != refusals_.end()) throw known->second;
  try {
    const LoadedMotion loaded = load_motion(scene);
    for (const std::string& warning : loaded.warnings) {
      if (std::ranges::find(warnings_, warning) == warnings_.end()) warnings_.push_back(warning);
    }
    return counts_[key] = loaded.path.tick_count();
  } catch (const Error& error) {
    refusals_.emplace(key, error);
    throw;
  }
}

}  // namespace fingerpad
