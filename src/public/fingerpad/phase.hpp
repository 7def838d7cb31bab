#pragma once

#include <string_view>

namespace fingerpad {

/// What a finger does on a tick: not touching, held by friction, or sliding.
enum class Phase : unsigned char {
  free = 0,   ///< nothing is touched
  stick = 1,  ///< the skin holds on to the surface
  slip = 2    ///< the skin slides over the surface
};
/// "free", "stick" or "slip".
std::string_view phase_name(Phase phase) noexcept;

}  // namespace fingerpad
