#pragma once

#include "contact/proxy_wall.hpp"

namespace fingerpad {

/// Walls that hold the proxy, all of them, for many ticks: what their normals fix is worked out once. For
/// speed alone: project_onto_walls, which tries every choice of them, comes to the same.
class EveryWall {
 public:
  EveryWall() = default;
  /// @param walls  at most three; they are read in project() too, with the same normals
  explicit EveryWall(std::span<const ProxyWall> walls) noexcept;

  /// The place where all walls' planes meet, or the one on them that is closest to `goal`. Found where all
  /// multipliers are positive: then no other choice of the walls is closer.
  ProxyProjection project(const Vec3& goal, std::span<const ProxyWall> walls) const noexcept;
  /// What becomes of such a projection's multipliers, and of `found`, where every wall stands nearer by so
  /// much. The place is left as it was.
  ProxyProjection with_walls_nearer(ProxyProjection onto_every, double nearer_m) const noexcept;

 private:
  WallsTogether together_;
  std::array<double, 3> per_metre_nearer_{1, 1, 1};  // how much less each multiplier is where all are nearer
};

}  // namespace fingerpad
