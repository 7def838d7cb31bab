#pragma once

#include <string>
#include <vector>

#include "motion/finger_path.hpp"
#include "scene/scene.hpp"
#include "scene/scene_change.hpp"

namespace fingerpad {

class MeshStore;

/// What a scene's finger follows, read and made ready.
struct LoadedMotion {
  FingerPath path;                         ///< at the scene's rate, or at the recording's own
  std::vector<std::string> notes = {};     ///< how the file was read and what was made of it, for people
  std::vector<SceneChange> changes = {};   ///< of the scene, made while a trace was recorded live
  std::vector<std::string> warnings = {};  ///< what in it is not as it should be
};

/// Reads what a scene's [motion] names: a motion table, a trace (HDF5 or CSV), or a scripted motion, puts it
/// where the scene says, or lays it on the first part; finds its own rate where the scene has none, and
/// estimates velocities and smooths it where the scene asks for that. Throws Error (refused) if the scene has
/// no motion, it cannot be read, or does not go with what is asked.
/// @param meshes  where the part comes from on which a motion is laid
LoadedMotion load_motion(const Scene& scene, MeshStore& meshes);
/// As above, with a mesh of its own.
LoadedMotion load_motion(const Scene& scene);

/// The finger's way alone.
FingerPath load_finger_path(const Scene& scene);

}  // namespace fingerpad
