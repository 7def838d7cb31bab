#pragma once

namespace fingerpad {

/// What a look costs, in some eight nanoseconds: fitted to the time that ticks took on the machine of the
/// charts.
struct LookCosts {
  static constexpr long search = 60;      ///< the trees are asked for what is near
  static constexpr long packet = 5;       ///< a float filter looks at eight triangles at once
  static constexpr long held = 2;         ///< what is known of a packet is held against a way, or a wall
  static constexpr long tangents = 5;     ///< half spaces are made for a packet's triangles
  static constexpr long swept = 12;       ///< a way is swept past a packet's half spaces
  static constexpr long fetched = 4;      ///< a triangle's corners are fetched, and its distance told
  static constexpr long sweep = 9;        ///< the way is swept past a triangle
  static constexpr long closest = 40;     ///< what is left of a packet's triangles is told exactly
  static constexpr long dipole = 2;       ///< the angle under which a cluster is seen, from afar
  static constexpr long angle = 8;        ///< that under which a triangle is seen
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
