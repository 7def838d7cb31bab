#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"

namespace fingerpad {

/// A change that somebody made while touching: from the tick at t_s on (that one included) a key of the scene
/// has another value. Keys are "part.K.mu_static", "part.K.mu_dynamic", "part.K.stiffness_n_per_m" and
/// "part.K.damping_n_s_per_m", K as in a trace's column `part` (parts, then planes, from 0); "friction.law";
/// "contact.method"; "contact.normals".
struct SceneChange {
  double t_s = 0;
  std::string key, value;
  bool operator==(const SceneChange&) const = default;
};

/// So many are kept of one touch.
inline constexpr std::size_t most_scene_changes = 10000;

/// The properties of what a trace's column `part` calls `surface`.
/// @pre 0 <= surface < parts and planes
SurfaceProperties& surface_properties(Scene& scene, int surface);
const SurfaceProperties& surface_properties(const Scene& scene, int surface);

/// "part.2.mu_static"
std::string surface_key(int surface, std::string_view name);

/// Puts a change into a scene. What of a law's own numbers the new one does not read it passes over. Throws
/// Error (refused) for a key or a value that the scene cannot have, and leaves the scene as it was.
void apply(const SceneChange& change, Scene& scene);

/// A line each behind "t_s,key,value".
std::string scene_changes_text(std::span<const SceneChange> changes);

/// Reads such a text back. Throws Error (refused, `place: line N`) where it is none.
/// @param place  the file it was in, for messages
std::vector<SceneChange> read_scene_changes(const std::string& text, const std::string& place);

}  // namespace fingerpad
