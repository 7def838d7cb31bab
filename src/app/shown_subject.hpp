#pragma once

#include <string>
#include <vector>

#include "app/progress_bar.hpp"
#include "view/view_input.hpp"

namespace fingerpad {

/// A scene, mesh or trace made ready to be shown. A scene with a motion is replayed first; one without shows
/// its parts.
/// @param metres_per_unit  for a mesh
/// @param bar  shows how the meshes' loading goes; finished before anything is told
/// Throws Error (refused) as loading and replaying do.
ViewInput load_subject(const std::string& path, double metres_per_unit, LoadBar& bar);

/// The files that showing a subject reads: itself, and what a scene names.
std::vector<std::string> subject_files(const std::string& path);

}  // namespace fingerpad
