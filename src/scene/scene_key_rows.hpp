#pragma once

#include <initializer_list>
#include <vector>

#include "scene/scene_key.hpp"

// The rows of scene_tables() that stand in a file of their own.

namespace fingerpad {

/// All rows of several lists, in their order.
inline std::vector<SceneKey> joined_keys(std::initializer_list<std::vector<SceneKey>> lists) {
  std::vector<SceneKey> all;
  for (const std::vector<SceneKey>& keys : lists) all.insert(all.end(), keys.begin(), keys.end());
  return all;
}

/// Of [motion]: a file and how it is read, or a motion made by its kind.
std::vector<SceneKey> motion_keys();
/// Of `columns` of [motion]. Read as one value, read_recording_columns.
std::vector<SceneKey> recording_column_keys();

}  // namespace fingerpad
