#pragma once

#include "fingerpad/finger.hpp"
#include "scene/scene.hpp"

namespace fingerpad {

/// The scene of a finger's options: its contact, friction, finger and rate. Read by the reader of scene
/// files, so that what may stand there is said in one place. Throws Error (refused) as that does.
Scene scene_of(const FingerOptions& options);

/// Throws Error (refused) for properties that no scene may have.
void refuse_impossible(const SurfaceProperties& properties);

}  // namespace fingerpad
