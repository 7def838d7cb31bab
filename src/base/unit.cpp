#include "base/unit.hpp"

namespace fingerpad {

std::vector<std::string> length_unit_names() {
  std::vector<std::string> names;
  names.reserve(std::size(length_units));
  for (const LengthUnit& unit : length_units) names.emplace_back(unit.name);
  return names;
}

std::optional<double> metres_per_unit(std::string_view name) noexcept {
  for (const LengthUnit& unit : length_units) {
    if (unit.name == name) return unit.metres;
  }
  return std::nullopt;
}

}  // namespace fingerpad
