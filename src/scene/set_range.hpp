#pragma once

#include <optional>
#include <string>

#include "scene/scene_set.hpp"

namespace fingerpad {

/// Whether a table of a [[set]] is a range of values, and not a table of a scene: one with `from`, `to`,
/// `steps` or `values`.
bool is_set_range(const TomlNode& table) noexcept;

/// The values of `{ from = 0.2, to = 0.4, steps = 5 }`, ends included and evenly apart, each rounded to 12
/// digits so that it reads as it is meant; or the list of `{ values = [...] }`. Of whole numbers come whole
/// ones where they fall so. Throws Error (refused, at its place) for anything else.
/// @param key           as written, for messages
/// @param wants_wholes  the key takes whole numbers alone
/// @returns             an array
TomlNode range_values(const TomlNode& table, const std::string& key, bool wants_wholes,
                      const std::string& path);

}  // namespace fingerpad
