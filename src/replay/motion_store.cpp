#include "replay/motion_store.hpp"

#include <algorithm>

#include "base/content_hash.hpp"
#include "base/number_text.hpp"
#include "scene/toml_tree.hpp"

namespace fingerpad {
namespace {

/// All that load_motion asks a scene for, where the rate is settled: with a rate that is chosen, it asks for
/// the rest too.
std::string key_of(const Scene& scene) {
  const TomlNode root = parse_toml(scene.text, scene.path);
  std::string key = scene.path + "\n" + scene.name + "\n" + scene.motion.file_path + "\n";
  for (const char* table : {"motion", "hand", "finger"}) {
    const TomlEntry* entry = find_entry(root, table);
    if (entry != nullptr) key += std::string(table) + "\n" + write_toml(entry->value);
  }
  if (scene.motion.placement.in_part) {
    const PartEntry& part = scene.parts.front();
    for (const double number : part.rotation.reshaped()) key += number_text(number) + " ";
    for (const double number : part.position_m) key += number_text(number) + " ";
  }
  return key;
}

std::shared_ptr<const StoredMotion> read_motion(const Scene& scene) {
  return std::make_shared<const StoredMotion>(
      StoredMotion{load_motion(scene), file_hash(scene.motion.file_path)});
}

}  // namespace

std::shared_ptr<const StoredMotion> MotionStore::load(const Scene& scene, MeshStore& meshes) {
  if (scene.motion.file_path.empty())
    return std::make_shared<const StoredMotion>(StoredMotion{load_motion(scene, meshes), ""});
  if (scene.motion.automatic_rate) return read_motion(scene);
  const std::string key = key_of(scene);
  std::promise<std::shared_ptr<const StoredMotion>> promise;
  Pending pending;
  bool ours = false;
  {
    const std::lock_guard lock(mutex_);
    std::erase(last_used_, key);
    last_used_.push_front(key);
    ours = !motions_.contains(key);
    if (ours) motions_[key] = promise.get_future().share();
    pending = motions_[key];
  }
  if (!ours) return pending.get();
  try {
    const auto motion = read_motion(scene);
    promise.set_value(motion);
    const std::lock_guard lock(mutex_);
    ++read_count_;
    if (motions_.contains(key)) {
      bytes_ -= sizes_[key];  // of one that was dropped and asked for again meanwhile
      bytes_ += sizes_[key] = motion->motion.path.memory_bytes();
    }
    drop_oldest();
  } catch (...) {
    promise.set_exception(std::current_exception());
  }
  return pending.get();
}

void MotionStore::drop_oldest() {
  while (bytes_ > most_bytes_ && last_used_.size() > 1) {
    const std::string key = last_used_.back();
    last_used_.pop_back();
    bytes_ -= sizes_[key];
    sizes_.erase(key);
    motions_.erase(key);
  }
}

long MotionStore::read_count() const {
  const std::lock_guard lock(mutex_);
  return read_count_;
}

}  // namespace fingerpad
