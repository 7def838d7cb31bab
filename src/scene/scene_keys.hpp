#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fingerpad {

/// The keys of one table of a scene file. Tables: "" (the file itself), "part", "part.rotation", "plane",
/// "contact", "friction" (with the parameters of every law), "friction.vibration", "finger", "motion",
/// "hand".
std::vector<std::string> scene_keys(std::string_view table);

/// The full dotted name of a key of a set: "part.mesh" for `mesh`, "motion.file" for `motion`, the key itself
/// for any other that a scene has ("seed", "part.mu_static", "friction.vibration.amplitude"); nothing for one
/// that it has not.
std::optional<std::string> set_key_target(std::string_view key);

/// All keys that a set may have, for messages.
std::vector<std::string> set_keys();

/// True where the key's value is a list of three numbers ("finger.direction").
bool is_vector_key(std::string_view dotted_key);

}  // namespace fingerpad
