#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace fingerpad {

/// "1 tick", "2 ticks".
inline std::string count_words(std::size_t count, std::string_view one) {
  return std::to_string(count) + " " + std::string(one) + (count == 1 ? "" : "s");
}

}  // namespace fingerpad
