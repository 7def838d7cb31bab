#pragma once

#include "motion/finger_path.hpp"
#include "scene/scene.hpp"

namespace fingerpad {

/// The finger path that a scene's [motion] names: a motion table, a trace (HDF5 or CSV), or a scripted
/// motion. Throws Error (refused) if the scene has none or it cannot be read.
FingerPath load_finger_path(const Scene& scene);

}  // namespace fingerpad
