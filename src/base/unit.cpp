#include "base/unit.hpp"

namespace fingerpad {

std::optional<double> metres_per_unit(std::string_view name) noexcept {
  for (const LengthUnit& unit : length_units) {
    if (unit.name == name) return unit.metres;
  }
  return std::nullopt;
}

}  // namespace fingerpad
