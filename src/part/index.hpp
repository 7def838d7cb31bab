#pragma once

#include <cstddef>

namespace fingerpad {

/// A corner, triangle or half-edge, which are counted in int, as a place in a vector.
inline std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace fingerpad
