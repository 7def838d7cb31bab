#pragma once

#include "fingerpad/types.hpp"

namespace fingerpad {

/// From where a finger comes down, seen from the place that it is to press on: how far away at most, how far
/// behind it, and how much farther aside than in front [of what the flight keeps from what it flies by].
struct LandingRoom {
  double away, behind, aside;
};
inline constexpr LandingRoom landing_begins{4, 0, 0.5}, landing_goes_on{8, 2, 2};

/// How a finger comes down to a place. noexcept, allocates nothing.
struct LandingWay {
  Vec3 there_W;   ///< from the finger to the place
  Vec3 down_W;    ///< along which it comes down there, unit
  double soft_m;  ///< what a flight keeps from what it flies by
  /// How much the pointer goes on while the finger follows, from 0, at rest, to 1, so far that it must come
  /// down behind it to come down at all.
  double hurry;

  /// Whether it meets the place to press on: it is near the place, in front of it, and not so far aside that
  /// it would go down beside the edge on which the place is.
  bool meets_place(const LandingRoom& room) const noexcept;
  /// Whether it is not far behind the place.
  bool is_in_front() const noexcept;
  /// Unit. To the place itself, and through it only from above it: the place may be on an edge, and beside
  /// that is nothing. A pointer that goes on is come down behind.
  Vec3 unit_W() const noexcept;
};

}  // namespace fingerpad
