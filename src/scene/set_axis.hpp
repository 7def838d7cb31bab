#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scene/toml_tree.hpp"

namespace fingerpad {

/// One value of a set's key.
struct SetValue {
  TomlNode value;
  std::string written;  ///< as the file writes it: a text without its quotes; for a glob, the file found
};

/// At most so many jobs are run from one file.
inline constexpr std::size_t max_jobs = 100000;

/// One key of a [[set]] entry with its values.
struct SetAxis {
  std::string key;               ///< as written, dotted
  std::string target;            ///< full dotted name in the scene
  Place place;                   ///< of the key
  std::vector<SetValue> values;  ///< no more than max_jobs + 1: that many are too many whatever they are
  bool is_list = false;          ///< written as a list, a range or a glob, and not as one value
};

/// A key of a set with its dots written out.
struct SetLeaf {
  std::string key;
  Place place;
  const TomlNode* value = nullptr;
};

/// Reads a key of a set with its values, and expands globs against the scene's folder. Throws Error (refused,
/// `file:line:column`) for a key that no scene has, lists without values, fractions where whole numbers are
/// taken, words that a key does not know, and globs that match nothing.
SetAxis read_axis(const SetLeaf& leaf, const std::string& path);

}  // namespace fingerpad
