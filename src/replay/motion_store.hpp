#pragma once

#include <deque>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "scene/scene.hpp"
#include "trace/motion_source.hpp"

namespace fingerpad {

/// A motion as a job of a batch needs it.
struct StoredMotion {
  LoadedMotion motion;
  std::string hash;  ///< file_hash of its file; empty for a motion made from a formula
};

/// Reads and hashes each motion once for all the jobs that follow it alike, however many ask at the same
/// time, and keeps those used last, up to a bound. Thread-safe.
class MotionStore {
 public:
  /// @param most_bytes  of recordings that stay in memory when nobody uses them; the newest stays whatever
  /// its size
  explicit MotionStore(std::size_t most_bytes) : most_bytes_(most_bytes) {}

  /// Throws as load_motion does, to everyone who asks.
  std::shared_ptr<const StoredMotion> load(const Scene& scene, MeshStore& meshes);
  /// How many were read so far.
  long read_count() const;

 private:
  using Pending = std::shared_future<std::shared_ptr<const StoredMotion>>;
  void drop_oldest();

  std::size_t most_bytes_, bytes_ = 0;
  long read_count_ = 0;
  mutable std::mutex mutex_;
  std::map<std::string, Pending> motions_;
  std::map<std::string, std::size_t> sizes_;  // of those that were read
  std::deque<std::string> last_used_;         // newest in front
};

}  // namespace fingerpad
