#pragma once

#include <cmath>
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

/// How much of a box is not the same in two pictures of one size: of squares of 6 pixels the mean of a
/// channel is off by more than 32 of 255. Edges that are smooth in one of them alone count for nothing then.
inline double share_that_differs(const Pixels& a, const Pixels& b, const Box& box) {
  constexpr int side = 6;
  const auto mean = [](const Pixels& pixels, const Box& square, int channel) {
    double sum = 0, count = 0;
    for_pixels(pixels, square, [&](const std::uint8_t* rgb) {
      sum += rgb[channel];
      ++count;
    });
    return count > 0 ? sum / count : 0;
  };
  double differ = 0, all = 0;
  for (double y = box.bottom; y + side <= box.top(); y += side) {
    for (double x = box.left; x + side <= box.right(); x += side) {
      const Box square{x, y, side, side};
      bool off = false;
      for (int i = 0; i < 3; ++i) off |= std::abs(mean(a, square, i) - mean(b, square, i)) > 32;
      ++all;
      differ += off ? 1 : 0;
    }
  }
  return all > 0 ? differ / all : 1;
}

}  // namespace fingerpad::test
