#include "contact/fan_memory.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fingerpad {

void FanMemory::remember(const ProxyWorld& world, const ProxyWall& wall_O, Looks& looks) noexcept {
  if (!world.is_shaded()) return;
  if (surface_ == wall_O.surface && triangle_ == wall_O.triangle && normal_.dot(wall_O.normal) > 0) return;
  surface_ = wall_O.surface;
  triangle_ = wall_O.triangle;
  normal_ = wall_O.normal;
  fan_.gather(world, wall_O);
  looks.spend(LookCosts::fetched * fan_.looks());
  certain_m_ = -1;
  std::size_t k = 0;
  for (const ProxyWall& wall : fan_.neighbours_O())
    per_slope_[k++] = 1 / (wall.normal - wall_O.normal).norm();
}

const ProxyWall* FanMemory::nearest_to(const ProxyWorld& world, const ProxyWall& wall_O,
                                       const Vec3& goal_O) noexcept {
  if ((goal_O - certain_goal_O_).squaredNorm() < certain_m_ * std::abs(certain_m_)) return nullptr;
  const ProxyWall* nearest = fan_.nearest_to(world, wall_O, goal_O);
  certain_goal_O_ = goal_O;
  certain_m_ = std::numeric_limits<double>::infinity();
  // The depths behind the planes change evenly with the goal.
  const double wall_depth_m = wall_O.lack_m(goal_O) - world.tolerance_m();
  std::size_t k = 0;
  for (const ProxyWall& wall : fan_.neighbours_O())
    certain_m_ = std::min(certain_m_, (wall.lack_m(goal_O) - wall_depth_m) * per_slope_[k++]);
  return nearest;
}

}  // namespace fingerpad
