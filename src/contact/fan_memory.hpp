#pragma once

#include "contact/facet_fan.hpp"
#include "contact/looks.hpp"

namespace fingerpad {

/// The fan about the facet that holds a proxy, and how far the finger may go before a neighbour can be
/// nearer to it. For speed alone: FacetFan, gathered and asked each time anew, answers the same.
class FanMemory {
 public:
  /// @param wall_O  the facet's
  void remember(const ProxyWorld& world, const ProxyWall& wall_O, Looks& looks) noexcept;
  /// FacetFan::nearest_to of the wall that was remembered last.
  const ProxyWall* nearest_to(const ProxyWorld& world, const ProxyWall& wall_O, const Vec3& goal_O) noexcept;

 private:
  FacetFan fan_;
  int surface_ = -1, triangle_ = -1;
  Vec3 normal_ = Vec3::Zero();  // from the side to which its wall's normal points
  std::array<double, ProxyLimits::most_neighbours> per_slope_{};  // 1/|a neighbour's normal - the wall's|
  Vec3 certain_goal_O_ = Vec3::Zero();  // no neighbour of it is nearer to a finger ...
  double certain_m_ = -1;               // ... that is within so much of here
};

}  // namespace fingerpad
