#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "base/unit.hpp"

namespace fingerpad {

/// How much a unit is of the one that an option's plain numbers are in; nothing for any other word.
using UnitFactor = std::function<std::optional<double>(std::string_view)>;

/// Of a quantity, for an option in a unit of so many s, m, N..
UnitFactor factors_of(Quantity quantity, double own_si = 1);
UnitFactor factors_of_hertz();
UnitFactor factors_of_percent();

/// The number of "7.3", "7.3ms" or "7.3 ms", in the option's own unit; nothing for any other text.
std::optional<double> number_with_unit(std::string_view text, const UnitFactor& factor);

/// Lets each number of an option have its unit behind it. Refuses what is no such number.
/// @param units  for people: "ms, s"
CLI::Option* take_units(CLI::Option* option, const UnitFactor& factor, const std::string& units);

/// What an option's numbers may be, in its own unit.
struct NumberLimits {
  double least = 0, most = 0;
  std::string unit;  ///< for people: "ms"
};
/// As take_units(), of numbers within limits: another is refused as it was given, unit and all.
CLI::Option* take_units_within(CLI::Option* option, const UnitFactor& factor, const std::string& units,
                               const NumberLimits& limits);

}  // namespace fingerpad
