#pragma once

#include <map>
#include <string>

#include "touch/mesh_store.hpp"

namespace fingerpad {

/// The meshes of a batch that is planned, and how long they took to load.
class TimedMeshes {
 public:
  /// @param keep, progress  as MeshStore's
  explicit TimedMeshes(std::size_t keep, LoadProgress progress = {}) : store_(keep, std::move(progress)) {}

  /// Loads those of a scene that are not there. Throws Error (refused) for one that cannot be touched.
  void load(const Scene& scene);
  /// What they took the first time: to the first who asks, as of all jobs over them one loads them; 0 later.
  double take_load_s(const Scene& scene);
  MeshStore& store() noexcept { return store_; }

 private:
  MeshStore store_;
  std::map<std::string, double> load_s_;  // by meshes_of()
};

}  // namespace fingerpad
