#pragma once

#include <string>

#include "scene/scene.hpp"
#include "scene/toml_tree.hpp"

namespace fingerpad {

/// What a scene may lack because its set puts it in.
enum class Missing { nothing, mesh };

/// Reads a scene (without a set) from its TOML. Throws Error (refused, `file:line:column`).
/// `text` of the result is left empty.
/// @param path  of the scene file as given: the place in messages, and what relative paths start from
Scene read_scene(const TomlNode& root, const std::string& path, Missing missing);

/// Throws Error (refused, at `place`) for a hand so light, or with a spring or damper so strong, that it does
/// a great many turns in a tick: what its matrix exponential loses by rounding grows with their number.
void refuse_hand_too_quick(const HandSettings& hand, double rate_hz, const std::string& place);

/// How deep a motion laid on the first part presses the finger in.
/// @pre scene.motion.laid, and there is a part
double pressed_depth_m(const Scene& scene);

}  // namespace fingerpad
