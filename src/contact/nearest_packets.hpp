#pragma once

#include <algorithm>
#include <array>
#include <utility>

#include "contact/winding_number.hpp"

namespace fingerpad {

/// The packets of a part, those first that are likely nearest to a point: on each level of the clusters the
/// nearest box is gone into first. The order is the part's alone.
class WindingNumber::NearestPackets {
 public:
  /// @param at  scaled
  NearestPackets(const WindingNumber& clusters, const Vec3& at) noexcept
      : clusters_(&clusters), at_(at), level_(clusters.top()) {
    look_into(0);
  }

  /// The next packet whose box comes within the radius (scaled, up to rounding); false when there is none.
  bool next(std::size_t& packet, double radius) noexcept {
    for (;;) {
      Open& open = open_[level_];
      if (open.next == branching || !(open.nearest[open.next].first <= radius * radius)) {
        if (level_ == clusters_->top()) return false;
        ++level_;
        continue;
      }
      const std::size_t index = open.nearest[open.next++].second;
      if (level_ == 0) {
        packet = index;
        return true;
      }
      --level_;
      look_into(branching * index);
    }
  }

  long tests() const noexcept { return tests_; }  ///< of four clusters

 private:
  static constexpr std::size_t most_levels = 33;

  /// Four clusters, the nearest first, each with the square of its box's distance.
  struct Open {
    std::array<std::pair<double, std::size_t>, branching> nearest;
    std::size_t next;
  };

  void look_into(std::size_t first) noexcept {
    ++tests_;
    Open& open = open_[level_];
    open.next = 0;
    const Four& four = clusters_->four(level_, first);
    for (std::size_t k = 0; k < branching; ++k) {
      double beyond2 = 0;
      for (int i = 0; i < 3; ++i) {
        const double beyond = std::max(0.0, std::abs(at_[i] - static_cast<double>(four.middle[i][k])) -
                                                static_cast<double>(four.half[i][k]));
        beyond2 += beyond * beyond;
      }
      open.nearest[k] = {beyond2, first + k};
    }
    std::sort(open.nearest.begin(), open.nearest.end());
  }

  const WindingNumber* clusters_;
  Vec3 at_;
  std::size_t level_;
  long tests_ = 0;
  std::array<Open, most_levels> open_;
};

}  // namespace fingerpad
