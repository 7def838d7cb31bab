#pragma once

#include <fmt/format.h>

#include <numbers>
#include <string>

#include "contact/part_measures.hpp"

namespace fingerpad {

// What the rows of the table of normals say of a part where `auto` asks them.

inline std::string turn_text(const PartMeasures& part) {
  return fmt::format("its facets turn by {:.2g} degrees where they stand for a smooth surface",
                     180 / std::numbers::pi * part.largest_smooth_turn_rad);
}

inline std::string sag_text(const PartMeasures& part) {
  return fmt::format("its facets cut {:.3g} mm into a smooth surface", 1e3 * part.largest_sag_m);
}

}  // namespace fingerpad
