#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fingerpad {

/// What one unit of a CAD file may be. CAD meshes carry no unit, so a scene or `--unit` names it.
struct LengthUnit {
  std::string_view name;
  double metres;
};
inline constexpr std::array<LengthUnit, 4> length_units{
    {{"m", 1}, {"mm", 1e-3}, {"cm", 1e-2}, {"in", 25.4e-3}}};

/// What one unit of a recording's clock may be.
struct TimeUnit {
  std::string_view name;
  double seconds;
};
inline constexpr std::array<TimeUnit, 3> time_units{{{"s", 1}, {"ms", 1e-3}, {"us", 1e-6}}};

/// The names of length_units, in that order.
std::vector<std::string> length_unit_names();

/// Metres in the unit of that name; nothing for any other name.
std::optional<double> metres_per_unit(std::string_view name) noexcept;

}  // namespace fingerpad
