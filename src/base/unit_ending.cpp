#include "base/unit_ending.hpp"

namespace fingerpad {

std::string_view unit_in_ending(std::string_view name) noexcept {
  struct Ending {
    std::string_view ending, unit;
  };
  // A longer ending before one that it ends in.
  constexpr Ending endings[] = {{"_n_per_m", "N/m"}, {"_m_per_s", "m/s"}, {"_per_deg", "1/deg"},
                                {"_per_m", "1/m"},   {"_n_m", "N m"},     {"_hz", "Hz"},
                                {"_s", "s"},         {"_m", "m"},         {"_n", "N"}};
  for (const Ending& one : endings)
    if (name.ends_with(one.ending)) return one.unit;
  return {};
}

}  // namespace fingerpad
