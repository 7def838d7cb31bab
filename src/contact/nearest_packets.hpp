#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "contact/winding_number.hpp"

namespace fingerpad {

/// The packets of a part, those first whose boxes are nearest to a point. The order is the part's alone.
class WindingNumber::NearestPackets {
 public:
  /// @param at  scaled
  NearestPackets(const WindingNumber& clusters, const Vec3& at) noexcept : clusters_(&clusters), at_(at) {
    look_into(clusters.top(), 0);
  }

  /// The next packet whose box comes within the radius (scaled, up to rounding); false when there is none.
  bool next(std::size_t& packet, double radius) noexcept {
    while (count_ > 0) {
      const Open nearest = open_[0];
      if (!(nearest.beyond2 <= radius * radius)) return false;
      std::pop_heap(open_.begin(), open_.begin() + count_, is_farther);
      --count_;
      if (nearest.level == 0) {
        packet = nearest.index;
        return true;
      }
      look_into(nearest.level - 1, branching * std::size_t{nearest.index});
    }
    return false;
  }

  long tests() const noexcept { return tests_; }  ///< of four clusters

 private:
  /// A cluster that was seen but not gone into, with the square of its box's distance.
  struct Open {
    double beyond2;
    std::uint32_t level, index;
  };
  /// More are open only where thousands are about as near; those that do not fit are left out.
  static constexpr std::ptrdiff_t most_open = 1024;

  static bool is_farther(const Open& a, const Open& b) noexcept {
    if (a.beyond2 != b.beyond2) return a.beyond2 > b.beyond2;
    return a.level != b.level ? a.level > b.level : a.index > b.index;
  }

  void look_into(std::size_t level, std::size_t first) noexcept {
    ++tests_;
    const Four& four = clusters_->four(level, first);
    for (std::size_t k = 0; k < branching; ++k) {
      double beyond2 = 0;
      for (int i = 0; i < 3; ++i) {
        const double beyond = std::max(0.0, std::abs(at_[i] - static_cast<double>(four.middle[i][k])) -
                                                static_cast<double>(four.half[i][k]));
        beyond2 += beyond * beyond;
      }
      if (!(beyond2 < std::numeric_limits<double>::infinity()) || count_ == most_open) continue;
      open_[static_cast<std::size_t>(count_++)] = {beyond2, static_cast<std::uint32_t>(level),
                                                   static_cast<std::uint32_t>(first + k)};
      std::push_heap(open_.begin(), open_.begin() + count_, is_farther);
    }
  }

  const WindingNumber* clusters_;
  Vec3 at_;
  long tests_ = 0;
  std::ptrdiff_t count_ = 0;
  std::array<Open, most_open> open_;  // a heap, the nearest first
};

}  // namespace fingerpad
