#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>

namespace fingerpad {

/// A colour with its opacity, 0 .. 1.
struct Colour {
  std::uint8_t red = 0, green = 0, blue = 0;
  double opacity = 1;

  constexpr Colour with_opacity(double value) const { return {red, green, blue, value}; }
};

/// The colours of Okabe & Ito (2008), told apart with every common kind of colour blindness, and greys.
namespace colours {
inline constexpr Colour black{0, 0, 0}, orange{230, 159, 0}, sky_blue{86, 180, 233},
    bluish_green{0, 158, 115}, yellow{240, 228, 66}, blue{0, 114, 178}, vermillion{213, 94, 0},
    reddish_purple{204, 121, 167};
inline constexpr Colour white{255, 255, 255}, ink{34, 38, 44}, grey{120, 126, 134}, pale_grey{218, 222, 227},
    metal{196, 204, 214}, skin{224, 172, 140};
}  // namespace colours

/// The eight colours that a chart's curves count through: those that show on white.
namespace palette {
enum Index : int { blue, vermillion, bluish_green, reddish_purple, orange, ink, sky_blue, grey };

constexpr Colour colour(int index) {
  constexpr Colour in_order[] = {colours::blue,           colours::vermillion, colours::bluish_green,
                                 colours::reddish_purple, colours::orange,     colours::ink,
                                 colours::sky_blue,       colours::grey};
  return in_order[static_cast<std::size_t>(index) % std::size(in_order)];
}
}  // namespace palette

}  // namespace fingerpad
