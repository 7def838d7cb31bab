#pragma once

#include <string>

#include "base/input_file.hpp"
#include "friction/pad_profile.hpp"

namespace fingerpad {

struct TomlNode;

/// A profile is a few lines, so a large file is some other file.
inline constexpr InputKind profile_file{"a finger-pad profile", 1 << 20};

/// Reads a profile file (TOML, keys as the members). Throws Error (refused, file:line:column) on unknown
/// keys, wrong types, missing axes, axes that vanish for some inclination in 0..90 deg, and a scene.
PadProfile read_profile(const std::string& path);

/// As read_profile, of a text that was read before (a trace keeps it); `path` is for messages.
PadProfile read_profile_text(const std::string& text, const std::string& path);

/// Whether a file has keys of a profile and no table of a scene.
bool is_profile(const TomlNode& file);

}  // namespace fingerpad
