#pragma once

#include <cstdint>
#include <vector>

namespace fingerpad {

/// A picture in memory: RGB, rows from the bottom up.
struct Pixels {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;  ///< 3 * width * height
};

}  // namespace fingerpad
