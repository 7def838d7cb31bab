#pragma once

#include <string>

#include "replay/batch.hpp"
#include "replay/motion_store.hpp"
#include "touch/mesh_store.hpp"

namespace fingerpad {

/// What a kind of jobs costs.
struct JobCost {
  double load_s = 0;   ///< its meshes, once for all its jobs
  double s_a_job = 0;  ///< beside its ticks: choosing the contact, beginning and ending a trace
  double s_per_tick = 0;
  double s_per_played_tick = 0;  ///< where another job has touched alike before: ContactStore
  bool may_play = false;         ///< whether that can be
  double bytes = 0;              ///< of a trace without rows
  double bytes_per_tick = 0;
  std::string unwritten = {};  ///< why no trace could be written for the try, whose bytes are not known then
};

/// Runs the beginning of a job, for a fifth of a second at most, and writes its trace to the system's folder
/// for temporary files, from where it is removed again. Where that folder refuses it does without. Throws
/// Error as the job would.
/// @param is_shared  whether other jobs may touch alike: then the same ticks are run once more, as theirs
JobCost try_job(const Scene& scene, MeshStore& meshes, MotionStore& motions, const BatchOptions& options,
                bool is_shared);

}  // namespace fingerpad
