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
  void add(const char* bytes, std::size_t count) {
    if (kept_ > 0) {
      const std::size_t missing = std::min(count, rest_.size() - kept_);
      std::memcpy(rest_.data() + kept_, bytes, missing);
      kept_ += missing;
      bytes += missing;
      count -= missing;
      if (kept_ < rest_.size()) return;
      mix_block(rest_.data());
      kept_ = 0;
    }
    for (; count >= rest_.size(); bytes += rest_.size(), count -= rest_.size()) mix_block(bytes);
    std::memcpy(rest_.data(), bytes, count);
    kept_ = count;
  }
  std::uint64_t value(std::uint64_t size) const {
    Checksum whole = *this;
    for (std::size_t i = 0, lane = 0; i < kept_; i += 8, ++lane)
      whole.mix(lane, rest_.data() + i, std::min<std::size_t>(8, kept_ - i));
    std::uint64_t all = size;
    for (const std::uint64_t lane : whole.lanes_) all = (std::rotl(all, 23) ^ lane) * prime;
    return all ^ all >> 32;
  }

 private:
  static constexpr std::uint64_t prime = 0x9E3779B97F4A7C15u;
  void mix_block(const char* bytes) {
    for (std::size_t lane = 0; lane < 4; ++lane) mix(lane, bytes + 8 * lane, 8);
  }
  void mix(std::size_t lane, const char* bytes, std::size_t count) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes, count);
    const std::uint64_t mixed = (lanes_[lane] ^ word) * prime;
    lanes_[lane] = mixed ^ mixed >> 29;
  }
  std::array<std::uint64_t, 4> lanes_ = {1, 2, 3, 4};
  std::array<char, 32> rest_ = {};  // of what was added, what is no whole block yet
  std::size_t kept_ = 0;
};

/// What tells a file's contents from others'.
struct FileSum {
  std::uint64_t size = 0, checksum = 0;
};

}  // namespace fingerpad
