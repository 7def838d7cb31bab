#pragma once

#include <cstdlib>
#include <map>

#include "view/drawing.hpp"
#include "view/pixels.hpp"

namespace fingerpad::test {

/// Visits the pixels of a box.
template <typename Visit>
void for_pixels(const Pixels& pixels, const Box& box, Visit visit) {
  for (int y = static_cast<int>(box.bottom); y < static_cast<int>(box.top()) && y < pixels.height; ++y) {
    for (int x = static_cast<int>(box.left); x < static_cast<int>(box.right()) && x < pixels.width; ++x) {
      visit(&pixels.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(pixels.width) +
                             static_cast<std::size_t>(x))]);
    }
  }
}

/// How much of a box has a colour, each channel to within 12 of 255.
inline double share_of(const Pixels& pixels, const Box& box, const Colour& colour) {
  double hits = 0, all = 0;
  for_pixels(pixels, box, [&](const std::uint8_t* rgb) {
    ++all;
    hits += std::abs(rgb[0] - colour.red) <= 12 && std::abs(rgb[1] - colour.green) <= 12 &&
                    std::abs(rgb[2] - colour.blue) <= 12
                ? 1
                : 0;
  });
  return all > 0 ? hits / all : 0;
}

/// How much of a box is not of its commonest colour (to 16 levels a channel).
inline double share_drawn(const Pixels& pixels, const Box& box) {
  std::map<int, long> count;
  long all = 0, commonest = 0;
  for_pixels(pixels, box, [&](const std::uint8_t* rgb) {
    ++all;
    commonest = std::max(commonest, ++count[rgb[0] / 16 * 256 + rgb[1] / 16 * 16 + rgb[2] / 16]);
  });
  return all > 0 ? 1 - static_cast<double>(commonest) / static_cast<double>(all) : 0;
}

}  // namespace fingerpad::test
