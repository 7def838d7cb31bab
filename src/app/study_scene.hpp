#pragma once

#include <string>

namespace fingerpad {

/// `study scene SCENE --out DIR`: every choice over the scene's own motion, into a table, a chart and the
/// lines to paste. @returns the exit code
int study_one_scene(const std::string& scene_path, const std::string& out_dir);

}  // namespace fingerpad
