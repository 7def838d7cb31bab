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

/// Reads the [motion] of a scene into it.
void read_motion_settings(const TomlNode& table, Scene& scene);

}  // namespace fingerpad
