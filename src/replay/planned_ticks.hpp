#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "scene/scene.hpp"

namespace fingerpad {

class MeshStore;

/// How many ticks the jobs of a batch will have: each motion is made once for all the jobs that follow it.
class PlannedTicks {
 public:
  /// Throws Error (refused) as load_motion() does: again for each scene whose motion is refused. Of a motion
  /// laid on a part at a given rate they are reckoned without the part, which need not be loaded for it.
  /// @param meshes  where the part comes from on which a motion is laid
  long of(const Scene& scene, MeshStore& meshes);
  /// Whether of() does not lay the motion, and so does not see whether it can be laid.
  static bool is_reckoned(const Scene& scene) noexcept;
  /// Of a scene whose ticks are reckoned: lays its motion. Throws Error (refused) where it cannot be laid.
  /// Nothing where so many others have been laid that further ones would take too long.
  std::optional<long> laid(const Scene& scene, MeshStore& meshes);
  /// What is odd in the motions that were made, each line once.
  const std::vector<std::string>& warnings() const noexcept { return warnings_; }

 private:
  long made(const std::string& key, const Scene& scene, MeshStore& meshes);

  std::vector<std::string> warnings_;
  std::map<std::string, long> counts_;
  std::map<std::string, Error> refusals_;
  int laid_ = 0;
};

}  // namespace fingerpad
