#pragma once

#include <cstdint>

#include "friction/law.hpp"

namespace fingerpad {

/// A colour with its opacity, 0 .. 1.
struct Colour {
  std::uint8_t red = 0, green = 0, blue = 0;
  double opacity = 1;

  constexpr Colour with_opacity(double value) const { return {red, green, blue, value}; }
};

/// The palette of Okabe & Ito (2008), told apart with every common kind of colour blindness, and greys.
namespace colours {
inline constexpr Colour black{0, 0, 0}, orange{230, 159, 0}, sky_blue{86, 180, 233},
    bluish_green{0, 158, 115}, yellow{240, 228, 66}, blue{0, 114, 178}, vermillion{213, 94, 0},
    reddish_purple{204, 121, 167};
inline constexpr Colour white{255, 255, 255}, ink{34, 38, 44}, grey{120, 126, 134}, pale_grey{218, 222, 227},
    metal{196, 204, 214}, skin{224, 172, 140};
}  // namespace colours

/// One colour a phase, in every picture and chart.
constexpr Colour phase_colour(Phase phase) {
  switch (phase) {
    case Phase::stick:
      return colours::bluish_green;
    case Phase::slip:
      return colours::orange;
    case Phase::free:
      break;
  }
  return {150, 156, 164};
}

}  // namespace fingerpad
