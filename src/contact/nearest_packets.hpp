#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "contact/winding_number.hpp"

namespace fingerpad {

/// The packets of a part, about in the order of how near their boxes are to a point. It is a hint: where very
/// many are about as near, as from the middle of a ball, no more than a few clusters are gone into for each
/// packet, so that a nearer one may come later, and those of which no more are kept in mind (most_open) not
/// at all. The order depends on the part alone.
class WindingNumber::NearestPackets {
 public:
  /// @param at  scaled
  NearestPackets(const WindingNumber& clusters, const Vec3& at) noexcept : clusters_(&clusters), at_(at) {
    look_into(clusters.top(), 0, false, nowhere);
  }

  /// The next packet; false when there is none. Its box comes within the radius (scaled, up to rounding), but
  /// for one that was found in a cluster which does: that may be farther.
  /// @param radius  no larger than at the last call: what was beyond it then is forgotten
  bool next(std::size_t& packet, double radius) noexcept {
    for (int gone_into = 0; count_ > 0; ++gone_into) {
      Open nearest = open_[0];
      if (!(nearest.beyond2 <= radius * radius)) return false;
      std::pop_heap(open_.begin(), open_.begin() + count_, is_farther);
      --count_;
      while (nearest.level > 0) {
        const bool straight_on = gone_into >= most_gone_into;
        const Open child =
            look_into(nearest.level - 1, branching * std::size_t{nearest.index}, straight_on, radius);
        if (!straight_on) break;
        nearest = child;
      }
      if (nearest.level > 0) continue;
      packet = nearest.index;
      return true;
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
  static constexpr double nowhere = std::numeric_limits<double>::infinity();
  /// Clusters that are kept in mind; those that do not fit are left out.
  static constexpr std::ptrdiff_t most_open = 1024;
  /// Clusters that are gone into one after the other, the nearest first, before the way goes straight down.
  static constexpr int most_gone_into = 16;

  static bool is_farther(const Open& a, const Open& b) noexcept {
    if (a.beyond2 != b.beyond2) return a.beyond2 > b.beyond2;
    return a.level != b.level ? a.level > b.level : a.index > b.index;
  }

  /// Keeps those of four clusters that come within the radius.
  /// @param takes_nearest  the nearest of the four is returned, and not kept among those that are open
  Open look_into(std::size_t level, std::size_t first, bool takes_nearest, double radius) noexcept {
    ++tests_;
    const Four& four = clusters_->four(level, first);
    std::array<Open, branching> seen;
    for (std::size_t k = 0; k < branching; ++k) {
      double beyond2 = 0;
      for (int i = 0; i < 3; ++i) {
        const double beyond = std::max(0.0, std::abs(at_[i] - static_cast<double>(four.middle[i][k])) -
                                                static_cast<double>(four.half[i][k]));
        beyond2 += beyond * beyond;
      }
      seen[k] = {beyond2, static_cast<std::uint32_t>(level), static_cast<std::uint32_t>(first + k)};
    }
    std::size_t kept = 0;
    if (takes_nearest) {
      std::swap(seen[0], *std::min_element(seen.begin(), seen.end(),
                                           [](const Open& a, const Open& b) { return is_farther(b, a); }));
      kept = 1;
    }
    for (; kept < branching; ++kept) {
      // Where the last of a level has fewer than four, those that are not are infinitely far away.
      const bool is_near = seen[kept].beyond2 <= radius * radius && seen[kept].beyond2 < nowhere;
      if (!is_near || count_ == most_open) continue;
      open_[static_cast<std::size_t>(count_++)] = seen[kept];
      std::push_heap(open_.begin(), open_.begin() + count_, is_farther);
    }
    return seen[0];
  }

  const WindingNumber* clusters_;
  Vec3 at_;
  long tests_ = 0;
  std::ptrdiff_t count_ = 0;
  std::array<Open, most_open> open_;  // a heap, the nearest first
};

}  // namespace fingerpad
