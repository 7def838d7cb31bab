#include "base/unit.hpp"

namespace fingerpad {

std::optional<double> metres_per_unit(std::string_view name) noexcept {
  if (name == "m") return 1.0;
  if (name == "mm") return 1e-3;
  if (name == "cm") return 1e-2;
  if (name == "in") return 25.4e-3;
  return std::nullopt;
}

}  // namespace fingerpad
