#pragma once

#include <array>
#include <bit>
#include <optional>

#include "contact/winding_number.hpp"

namespace fingerpad {

/// The packets that may come within a radius of a point, or of what is about a point, and perhaps some more;
/// in the part's order, so that a search can be broken off anywhere and gone on with. No cluster is looked at
/// twice.
class WindingNumber::NearPackets {
 public:
  /// What is about the point.
  enum class About {
    box,  ///< from `at - half` to `at + half`
    way,  ///< the diagonal of that box
  };

  /// @param at, radius, half  scaled
  /// @param from              the first packet that is asked for
  /// @pre `clusters` outlives this
  NearPackets(const WindingNumber& clusters, const Vec3& at, double radius, const Vec3& half = Vec3::Zero(),
              About about = About::box, std::size_t from = 0) noexcept;

  /// From now on those within a smaller radius alone, but for what has been looked at.
  /// @pre a point, or what is about it: of a way no less would be looked at
  void shrink(double radius) noexcept {
    if (is_far_) return;
    around_.shrink(radius);
  }

  /// False when there is no more.
  bool next(std::size_t& packet) noexcept {
    for (;;) {
      while (near_[level_] == 0) {
        if (level_ == clusters_->top()) return false;
        ++level_;
      }
      const std::size_t index = first_[level_] + static_cast<unsigned>(std::countr_zero(near_[level_]));
      near_[level_] &= near_[level_] - 1;
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
  static constexpr std::size_t most_levels = 33;  // four to the 32nd packets

  void look_into(std::size_t first) noexcept {
    ++tests_;
    first_[level_] = first;
    const Four& four = clusters_->four(level_, first);
    near_[level_] = around_.near(four);
    if (!along_ || near_[level_] == 0) return;
    ++tests_;
    near_[level_] &= along_->near(four);
  }

  const WindingNumber* clusters_;
  bool is_far_;  // than floats go: all packets count as near
  Around around_;
  std::optional<Along> along_;
  std::size_t level_;
  long tests_ = 0;
  std::array<std::size_t, most_levels> first_;  // of the four clusters that are open on each level
  std::array<unsigned, most_levels> near_;      // those of them that are still to be gone into, a bit each
};

}  // namespace fingerpad
