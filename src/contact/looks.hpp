#pragma once

namespace fingerpad {

/// The prices of looks. The unit is a look at a triangle that is at hand and was seen before: some nine
/// nanoseconds, with room for memory that is slower than a part in a cache.
struct LookCosts {
  static constexpr long packet = 6;           ///< eight triangles are fetched, and looked at all at once
  static constexpr long packet_cold = 8;      ///< the same of a part that no core's own cache holds
  static constexpr long sieved = 2;           ///< ... and a way is held against them
  static constexpr long cluster = 2;          ///< four clusters are held against a ball
  static constexpr long beside = 4;           ///< the same, then against a way: each of both
  static constexpr long passed_over = 3;      ///< the disc around eight triangles is held against a distance
  static constexpr long opened = 4;           ///< four clusters are put among those that are nearest
  static constexpr long further_wall = 2;     ///< a packet, or a triangle, is held against one more wall
  static constexpr long shadowed = 3;         ///< a triangle within reach is held against a shadow
  static constexpr long listed = 1;           ///< one that is found
  static constexpr long fetched = 5;          ///< its corners are fetched
  static constexpr long fetched_cleared = 2;  ///< the same for one that is held against its own plane
  static constexpr long told = 5;             ///< how a place stands before it is told anew
  static constexpr long sweep = 2;            ///< the way is swept past it ...
  static constexpr long sweep_step = 10;      ///< ... with so many of Newton's steps
  static constexpr long of_few = 4;           ///< a pass goes over it in a small view, whatever becomes of it
  static constexpr long too_many = 200;       ///< a search for a few ends where there are more
  static constexpr long closest = 30;         ///< what is left of a packet's triangles is told exactly
  static constexpr long dipole = 2;           ///< a cluster of triangles is seen as one
  static constexpr long angle = 5;            ///< the angle under which a triangle is seen
  static constexpr long projection = 32;      ///< onto four walls
  static constexpr long hop = 64;             ///< the way over an edge
  /// No price: what a start looks at counts so many times. It comes where no tick has been, and finds nothing
  /// at hand.
  static constexpr double of_start = 4.0 / 3;
};

/// How much a tick may still spend on looks, at the prices of LookCosts: a bound on its work that is the same
/// on every machine, as a clock would not be. What looks pays for what it does, and stops where nothing is
/// left.
class Looks {
 public:
  static constexpr long unlimited = 1L << 60;

  explicit Looks(long most) noexcept : most_(most), left_(most) {}

  bool is_unlimited() const noexcept { return most_ == unlimited; }
  bool are_spent() const noexcept { return left_ <= 0; }
  bool are_half_spent() const noexcept { return left_ < most_ / 2; }
  long left() const noexcept { return left_; }
  long spent() const noexcept { return most_ - left_; }
  void spend(long price) noexcept { left_ -= price; }
  /// The next tick's.
  void renew() noexcept { left_ = most_; }

 private:
  long most_, left_;
};

}  // namespace fingerpad
