#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace fingerpad {

/// Four lanes of multiply and xor-shift over words: against damage, not against forgery, and several times
/// faster than the disk.
class Checksum {
 public:
  /// @pre every call but the last adds a multiple of 32 bytes
  void add(const char* bytes, std::size_t count) {
    std::size_t i = 0;
    for (; i + 32 <= count; i += 32) {
      for (std::size_t lane = 0; lane < 4; ++lane) mix(lane, bytes + i + 8 * lane, 8);
    }
    for (std::size_t lane = 0; i < count; i += 8, ++lane)
      mix(lane, bytes + i, std::min<std::size_t>(8, count - i));
  }
  std::uint64_t value(std::uint64_t size) const {
    std::uint64_t all = size;
    for (const std::uint64_t lane : lanes_) all = (std::rotl(all, 23) ^ lane) * prime;
    return all ^ all >> 32;
  }

 private:
  static constexpr std::uint64_t prime = 0x9E3779B97F4A7C15u;
  void mix(std::size_t lane, const char* bytes, std::size_t count) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes, count);
    const std::uint64_t mixed = (lanes_[lane] ^ word) * prime;
    lanes_[lane] = mixed ^ mixed >> 29;
  }
  std::array<std::uint64_t, 4> lanes_ = {1, 2, 3, 4};
};

}  // namespace fingerpad
