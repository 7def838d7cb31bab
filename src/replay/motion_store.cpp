#include "replay/motion_store.hpp"

#include <algorithm>

#include "replay/motion_key.hpp"
#include "trace/trace_info.hpp"

namespace fingerpad {
namespace {

std::shared_ptr<const StoredMotion> read_motion(const Scene& scene) {
  return std::make_shared<const StoredMotion>(StoredMotion{load_motion(scene), motion_hash_of(scene)});
}

}  // namespace

std::shared_ptr<const StoredMotion> MotionStore::load(const Scene& scene, MeshStore& meshes) {
  if (scene.motion.file_path.empty())
    return std::make_shared<const StoredMotion>(StoredMotion{load_motion(scene, meshes), ""});
  if (scene.motion.automatic_rate) return read_motion(scene);
  const std::string key = motion_key(scene);
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
