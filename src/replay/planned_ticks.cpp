#include "replay/planned_ticks.hpp"

#include <algorithm>

#include "base/number_text.hpp"
#include "replay/job_order.hpp"
#include "replay/motion_key.hpp"
#include "scene/scene_reader.hpp"
#include "scene/toml_tree.hpp"
#include "touch/mesh_store.hpp"
#include "trace/motion_source.hpp"

namespace fingerpad {
namespace {

/// Of two scenes with the same key the same motion is laid at a given rate, or refused in the same words.
std::string laid_key(const Scene& scene) {
  const TomlNode root = parse_toml(scene.text, scene.path);
  const TomlEntry* motion = find_entry(root, "motion");
  return "laid\n" + scene.path + "\n" + (motion == nullptr ? "" : write_toml(motion->value)) + "\n" +
         number_text(scene.finger.radius_m) + " " + number_text(pressed_depth_m(scene)) + "\n" +
         meshes_of(scene);
}

}  // namespace

bool PlannedTicks::is_reckoned(const Scene& scene) noexcept {
  return scene.motion.laid && !scene.motion.automatic_rate;
}

long PlannedTicks::of(const Scene& scene, MeshStore& meshes) {
  if (is_reckoned(scene))
    return tick_count(duration_s(*scene.motion.laid, pressed_depth_m(scene)), scene.motion.rate_hz);
  return made(motion_key(scene), scene, meshes);
}

std::optional<long> PlannedTicks::laid(const Scene& scene, MeshStore& meshes) {
  constexpr int most_laid = 256;
  const std::string key = laid_key(scene);
  const bool is_known = counts_.contains(key) || refusals_.contains(key);
  if (!is_known && laid_ == most_laid) return std::nullopt;
  if (!is_known) ++laid_;
  return made(key, scene, meshes);
}

long PlannedTicks::made(const std::string& key, const Scene& scene, MeshStore& meshes) {
  if (const auto known = counts_.find(key); known != counts_.end()) return known->second;
  if (const auto known = refusals_.find(key); known != refusals_.end()) throw known->second;
  try {
    const LoadedMotion loaded = load_motion(scene, meshes);
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
