#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "scene/set_axis.hpp"
#include "scene/toml_tree.hpp"

namespace fingerpad {

/// One [[set]] entry: its keys in the order written. Its jobs are their product, last key fastest; with
/// `zip = true` its lists go side by side, and a key of one value that is no list goes with all of them.
struct SetEntry {
  std::vector<SetAxis> axes;
  bool zip = false;
};

/// The jobs that an entry has, or max_jobs + 1 where it has more.
std::size_t job_count(const SetEntry& entry) noexcept;

/// Which value of each axis a job of an entry has. @param job  from 0
std::vector<std::size_t> choice_of_job(const SetEntry& entry, std::size_t job);

/// Reads the `set` of a scene file and expands globs against the scene's folder. Throws Error (refused,
/// `file:line:column`) for keys that no scene has, keys given twice, lists without values, globs that
/// match nothing, and lists of several lengths where they go side by side.
std::vector<SetEntry> read_set(const TomlEntry& set, const std::string& path);

/// Throws Error (refused, at the key) where an entry has a key of the first [[part]] or [[plane]], the scene
/// has none, and the entry does not give what such a table needs (`mesh`; `point_m` and `normal`).
/// @param root  the scene without its set
void refuse_keys_without_table(const TomlNode& root, const std::vector<SetEntry>& entries,
                               const std::string& path);

/// Puts a value at a full dotted name. `part.` and `plane.` name the first one; tables that are missing are
/// made; a motion file drives out the keys of a scripted motion and the other way round.
void put_value(TomlNode& root, const std::string& target, const TomlNode& value);

}  // namespace fingerpad
