#include "contact/facet_fan.hpp"

#include <cmath>

#include "contact/worst_wall.hpp"

namespace fingerpad {

void FacetFan::gather(const ProxyWorld& world, const ProxyWall& wall_O) noexcept {
  count_ = looks_ = 0;
  for (int corner = 0; corner < 3 && wall_O.triangle >= 0; ++corner) {
    for (const int first_edge : {corner, (corner + 2) % 3}) {
      if (!go_around(world, wall_O, corner, first_edge)) break;
    }
  }
}

/// Goes around a corner over one of its two edges, as far as no crease is crossed. False where that led all
/// the way around, or the fan is full: there is nothing left to find the other way.
bool FacetFan::go_around(const ProxyWorld& world, const ProxyWall& wall_O, int corner,
                         int first_edge) noexcept {
  const int surface = wall_O.surface, triangle = wall_O.triangle;
  const Part& part = world.part(surface);
  const Vec3 origin_P = world.in_part(surface, Vec3::Zero());
  const Vec3 wall_normal_P = world.surface(surface).R_WP.transpose() * wall_O.normal;
  const double side = side_of(part.facet_normals.col(triangle), wall_normal_P);
  const PartWalls behind(world, surface, std::span(&wall_O, 1), origin_P);
  const int vertex = part.welded(corner, triangle);
  int t = triangle, edge = first_edge;
  for (int turn = 0; turn < ProxyLimits::most_turns; ++turn) {
    const int next = part.neighbours(edge, t);
    if (next < 0 || (part.creases[static_cast<std::size_t>(t)] >> edge & 1) != 0) break;
    if (next == triangle || count_ == ProxyLimits::most_neighbours) return false;
    int at = 0;
    while (at < 2 && part.welded(at, next) != vertex) ++at;
    // Of the two edges at the vertex, the one not come by.
    edge = part.neighbours(at, next) == t ? (at + 2) % 3 : at;
    t = next;
    ++looks_;
    const TriangleCorners corners = corners_of(part, t);
    const Vec3 normal_P = side * corners.normal;
    if (!(normal_P.dot(wall_normal_P) > 0) || !behind.hide(corners)) continue;
    neighbours_O_[static_cast<std::size_t>(count_++)] = {
        world.surface(surface).R_WP * normal_P, world.clearance_m() + normal_P.dot(corners.a - origin_P),
        surface, t};
  }
  return true;
}

const ProxyWall* FacetFan::nearest_to(const ProxyWorld& world, const ProxyWall& wall_O,
                                      const Vec3& goal_O) const noexcept {
  const ProxyWall* nearest = nullptr;
  double least_depth_m = wall_O.lack_m(goal_O) - world.tolerance_m();
  for (const ProxyWall& wall : neighbours_O()) {
    const double depth_m = wall.lack_m(goal_O);
    if (!(depth_m < least_depth_m)) continue;
    // The finger's foot on the plane lies on the facet where the facet is no farther than the plane.
    const double distance_m = world.approach(wall.surface, wall.triangle, goal_O).distance_m;
    if (distance_m > std::abs(depth_m - world.clearance_m()) + world.tolerance_m()) continue;
    least_depth_m = depth_m;
    nearest = &wall;
  }
  return nearest;
}

}  // namespace fingerpad
