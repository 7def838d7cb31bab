#pragma once

#include "part/part.hpp"

namespace fingerpad {

/// Whether a part is open: some edge has a triangle on one side alone. Such a surface has no inside.
inline bool has_border(const Part& part) noexcept {
  return (part.neighbours.array() < 0).any();
}

}  // namespace fingerpad
