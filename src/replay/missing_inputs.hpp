#pragma once

#include "scene/scene.hpp"

namespace fingerpad {

/// Throws Error (refused, with the scene's file before that of the input) where a mesh or the motion that the
/// scene names is not there: among many scenes the file's name alone does not tell whose it is.
void refuse_missing_inputs(const Scene& scene);

}  // namespace fingerpad
