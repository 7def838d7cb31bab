#pragma once

#include <string_view>

namespace fingerpad {

/// The SI unit that a name of the program's own ends in: "m/s" of v_min_m_per_s, "N m" of tx_n_m. Empty where
/// it ends in none, as that of a pure number does.
std::string_view unit_in_ending(std::string_view name) noexcept;

}  // namespace fingerpad
