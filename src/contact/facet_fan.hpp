#pragma once

#include "contact/proxy_limits.hpp"
#include "contact/proxy_world.hpp"

namespace fingerpad {

/// The neighbours of a facet that holds the proxy: facets that share a corner with it, reached over edges
/// that are no creases, and that lie behind its plane. Where the mesh stands for a smooth surface, the finger
/// may be nearer to one of them.
class FacetFan {
 public:
  /// Goes around the corners of the wall's triangle; a plane has no neighbours.
  void gather(const ProxyWorld& world, const ProxyWall& wall_O) noexcept;
  std::span<const ProxyWall> neighbours_O() const noexcept {
    return {neighbours_O_.data(), static_cast<std::size_t>(count_)};
  }
  /// How many triangles the last gathering looked at.
  int looks() const noexcept { return looks_; }
  /// The neighbour with the finger's foot on it that is nearest to the finger; null where none is nearer than
  /// the wall, to within the tolerance.
  const ProxyWall* nearest_to(const ProxyWorld& world, const ProxyWall& wall_O,
                              const Vec3& goal_O) const noexcept;

 private:
  struct Middle;
  bool go_around(const Middle& middle, int corner, int first_edge) noexcept;
  bool is_met_already(const Middle& middle, int t) const noexcept;
  void add_if_behind(const Middle& middle, int t) noexcept;

  std::array<ProxyWall, ProxyLimits::most_neighbours> neighbours_O_;
  int count_ = 0, looks_ = 0;
};

}  // namespace fingerpad
