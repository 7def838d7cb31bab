#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

namespace fingerpad {

/// Numbers between two bounds as 16 bits each, little-endian; 65535 is none (nan).
struct PackedRange {
  double low = 0, span = 0;

  void take(double value) {
    if (!std::isfinite(value)) return;
    if (!has_any_) {
      low = value;
      has_any_ = true;
    }
    if (value < low) {
      span += low - value;
      low = value;
    }
    span = std::max(span, value - low);
  }

  void pack(double value, std::string& bytes) const {
    constexpr double most = 65534;
    std::uint16_t code = 65535;
    if (std::isfinite(value))
      code = static_cast<std::uint16_t>(std::lround(span > 0 ? (value - low) / span * most : 0));
    add_code(code, bytes);
  }

  static void add_code(std::uint16_t code, std::string& bytes) {
    bytes += static_cast<char>(code & 255);
    bytes += static_cast<char>(code >> 8);
  }

 private:
  bool has_any_ = false;
};

}  // namespace fingerpad
