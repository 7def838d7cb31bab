#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scene/scene.hpp"

namespace fingerpad {

/// One job of a scene file: the scene with its set keys put in.
struct SceneJob {
  Scene scene;
  int number = 0;                                             ///< from 1 in a set; 0 for a plain scene
  std::vector<std::pair<std::string, std::string>> set_keys;  ///< dotted key and value as written, in order
  std::string error;  ///< why this job's scene is refused (for example a value out of range); empty if good
};

/// A scene file read whole.
struct SceneFile {
  Scene scene;  ///< without its set
  bool is_set = false;
  std::vector<SceneJob> jobs;  ///< one for a plain scene; a product per [[set]] entry, last key fastest
};

/// What becomes of keys that no job of a file reads, such as a number of another law than the chosen one.
enum class Unread { refused, passed_over };

/// Reads a scene file. Throws Error (refused) at `file:line:column` for anything that the contract does not
/// know: syntax, unknown keys, wrong types, values out of range, unknown law or method names, keys that no
/// job reads. Mesh and motion files are resolved but not opened (a glob in a set is expanded; one that
/// matches nothing is refused). A file that is not there is told with the name beside it that is spelled most
/// like it.
SceneFile read_scene_file(const std::string& path);

/// Throws Error (refused) where a file is the profile of a finger pad, or no TOML.
void refuse_profile(const std::string& path);

/// As above from text; relative paths are resolved against `path`'s folder. The text of a set's job, which a
/// trace keeps, may hold keys that only other jobs of its set read: pass them over.
SceneFile read_scene_text(const std::string& text, const std::string& path, Unread unread = Unread::refused);

/// The crease angle of each [[part]] of a scene kept as text, in order. Looks at nothing else in it, so that
/// it needs none of the scene's files; text that is no scene has no parts.
std::vector<double> part_crease_degs(const std::string& text);

/// The scene of a trace: its text, with the profile that the trace keeps in place of the profile's file, so
/// that no file has to be where it was. An empty `profile_text` means that the scene had none.
Scene read_recorded_scene(const std::string& scene_text, const std::string& profile_text,
                          const std::string& path);

/// A scene for a mesh alone, with every default: `touch MESH` and `view MESH`.
Scene scene_of_mesh(const std::string& mesh_path, double metres_per_unit);

}  // namespace fingerpad
