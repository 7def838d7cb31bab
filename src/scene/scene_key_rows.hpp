#pragma once

#include <vector>

#include "scene/scene_key.hpp"

// The rows of scene_tables() that stand in a file of their own.

namespace fingerpad {

/// Of [motion]: a file and how it is read, or a motion made by its kind.
std::vector<SceneKey> motion_keys();
/// Of `columns` of [motion]. Read as one value, read_recording_columns.
std::vector<SceneKey> recording_column_keys();

}  // namespace fingerpad
