#pragma once

#include "scene/scene_key.hpp"

namespace fingerpad {

/// The keys of [friction]: the law, the numbers of all laws as their rows tell them, and what is chosen by a
/// word. A number keeps the limits that the chosen law gives it.
std::vector<SceneKey> friction_keys();

}  // namespace fingerpad
