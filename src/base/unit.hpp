#pragma once

#include <optional>
#include <string_view>

namespace fingerpad {

/// Metres in one unit of a CAD file: "m", "mm", "cm" or "in"; nothing for any other name.
/// CAD meshes carry no unit, so a scene or `--unit` names it.
std::optional<double> metres_per_unit(std::string_view name) noexcept;

/// The names above, for messages: "m, mm, cm, in".
inline constexpr std::string_view unit_names = "m, mm, cm, in";

}  // namespace fingerpad
