#pragma once

#include "scene/scene_key.hpp"

namespace fingerpad {

// The keys whose value takes more than one step from the file into the scene: SceneKey::read of their rows,
// or the rows themselves. All throw Error (refused) at the key.

/// A path of a scene: absolute as it is, or beside the scene file.
std::string resolved_path(const std::string& scene_path, const std::string& written);

/// The scene's name where the file does not say it: its stem, made fit to name files.
std::string name_of_file(const std::string& path);

/// The text of a key. Throws where it is empty.
std::string text_that_is_there(const SceneKey& row, const TomlTable& table);

void read_name(const SceneKey& row, const TomlTable& top, Scene& scene);
void read_mesh(const SceneKey& row, const TomlTable& part, Scene& scene);
void read_rotation(const SceneKey& row, const TomlTable& part, Scene& scene);
void read_motion_rotation(const SceneKey& row, const TomlTable& motion, Scene& scene);
void read_device_rotation(const SceneKey& row, const TomlTable& device, Scene& scene);
void read_vibration(const SceneKey& row, const TomlTable& friction, Scene& scene);
void read_profile_key(const SceneKey& row, const TomlTable& finger, Scene& scene);
void read_axes(const SceneKey& row, const TomlTable& hand, Scene& scene);

/// @param word  a method's name, or `auto`
void take_method(Scene& scene, std::string_view word);
/// @param word  the name of normals, or `auto`
void take_normals(Scene& scene, std::string_view word);

SceneKey unit_key(std::string_view key);

}  // namespace fingerpad
