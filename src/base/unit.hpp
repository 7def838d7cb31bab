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
inline constexpr std::array<LengthUnit, 5> length_units{
    {{"m", 1}, {"mm", 1e-3}, {"cm", 1e-2}, {"in", 25.4e-3}, {"um", 1e-6}}};

/// What one unit of a recording's clock may be.
struct TimeUnit {
  std::string_view name;
  double seconds;
};
inline constexpr std::array<TimeUnit, 5> time_units{
    {{"s", 1}, {"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}, {"min", 60}}};

/// What one unit of a measured force may be.
struct ForceUnit {
  std::string_view name;
  double newtons;
};
inline constexpr std::array<ForceUnit, 7> force_units{{{"N", 1},
                                                       {"mN", 1e-3},
                                                       {"kN", 1e3},
                                                       {"gf", 9.80665e-3},
                                                       {"kgf", 9.80665},
                                                       {"cN", 1e-2},
                                                       {"lbf", 4.4482216152605}}};

/// What one unit of a measured torque may be.
struct TorqueUnit {
  std::string_view name;
  double newton_metres;
};
inline constexpr std::array<TorqueUnit, 2> torque_units{{{"N.m", 1}, {"N.mm", 1e-3}}};

/// What a column of a measurement may hold.
enum class Quantity { time, length, force, torque, speed };
inline constexpr std::size_t quantities = 5;
std::string_view quantity_words(Quantity quantity) noexcept;
/// How much of s, m, N, N m or m/s a unit is that a table names, as those above or as people write them
/// ("sec", "N mm"; of a speed a length in a time, "mm/s", "m s^-1"); nothing for any other word.
std::optional<double> si_per_unit(Quantity quantity, std::string_view word);
/// What units above call the unit that people write so: "us" of a time's "µs"; any other word as it is.
std::string_view listed_unit(Quantity quantity, std::string_view word);
/// Whether a word is a unit that people measure in and none that si_per_unit knows: "ft", "V", "pixels".
bool is_other_unit(std::string_view word);
/// "s, ms, us, ns, min".
std::string unit_list(Quantity quantity);

/// The names of length_units, in that order.
std::vector<std::string> length_unit_names();

/// Metres in the unit of that name; nothing for any other name.
std::optional<double> metres_per_unit(std::string_view name) noexcept;

}  // namespace fingerpad
