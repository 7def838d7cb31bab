#include "view/view_input.hpp"

#include <filesystem>

#include "base/error.hpp"
#include "scene/scene_file.hpp"

namespace fingerpad {

ViewInput view_of_trace(Trace trace, const std::string& path) {
  ViewInput input;
  input.title =
      trace.info.scene_name.empty() ? std::filesystem::path(path).stem().string() : trace.info.scene_name;
  input.world = std::move(trace.world);
  input.rows = std::move(trace.rows);
  if (trace.info.scene_text.empty()) return input;
  // The trace was recorded elsewhere perhaps: a scene whose files are gone costs its labels, not the picture.
  try {
    input.scene = read_recorded_scene(trace.info.scene_text, trace.info.profile_text, path);
    if (!input.world) input.world = load_world(*input.scene);
  } catch (const Error&) {
  }
  return input;
}

}  // namespace fingerpad
