#pragma once

namespace fingerpad {

/// What a look costs, where one at a triangle that is at hand and was seen before counts once.
struct LookCosts {
  static constexpr long packet = 6;       ///< a float filter looks at eight triangles at once
  static constexpr long fetched = 8;      ///< a triangle's corners are fetched, and its distance told
  static constexpr long sweep = 20;       ///< the way is swept past a triangle; nothing in a small view
  static constexpr long closest = 30;     ///< what is left of a packet's triangles is told exactly
  static constexpr long angle = 6;        ///< the angle under which a triangle is seen
  static constexpr long projection = 32;  ///< onto four walls
  static constexpr long hop = 64;         ///< the way over an edge
};

/// How much may still be looked at in a tick, in triangles: a bound on its work that is the same on every
/// machine, as a clock would not be. What looks pays for what it does, and stops where nothing is left.
class Looks {
 public:
  static constexpr long unlimited = 1L << 60;

  explicit Looks(long most) noexcept : most_(most), left_(most) {}

  bool is_unlimited() const noexcept { return most_ == unlimited; }
  bool are_spent() const noexcept { return left_ <= 0; }
  bool are_half_spent() const noexcept { return left_ < most_ / 2; }
  long left() const noexcept { return left_; }
  long spent() const noexcept { return most_ - left_; }
  void spend(long triangles) noexcept { left_ -= triangles; }
  /// The next tick's.
  void renew() noexcept { left_ = most_; }

 private:
  long most_, left_;
};

}  // namespace fingerpad
