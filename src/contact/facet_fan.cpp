#include "contact/facet_fan.hpp"

#include <algorithm>
#include <cmath>

#include "contact/facet_rule.hpp"
#include "contact/worst_wall.hpp"

namespace fingerpad {

/// The facet in the middle of the fan, as its neighbours are looked at from.
struct FacetFan::Middle {
  const ProxyWorld& world;
  const Part& part;
  int surface, triangle;
  Vec3 origin_P, normal_P;  ///< O's origin, and the wall's normal
  double side;
  PartWalls behind;

  Middle(const ProxyWorld& of_world, const ProxyWall& wall_O) noexcept
      : world(of_world),
        part(world.part(wall_O.surface)),
        surface(wall_O.surface),
        triangle(wall_O.triangle),
        origin_P(world.in_part(surface, Vec3::Zero())),
        normal_P(world.turned_into_part(surface, wall_O.normal)),
        side(side_of(part.facet_normals.col(triangle), normal_P)),
        behind(world, surface, std::span(&wall_O, 1), origin_P) {}
};

void FacetFan::gather(const ProxyWorld& world, const ProxyWall& wall_O) noexcept {
  count_ = looks_ = 0;
  if (wall_O.triangle < 0) return;
  const Middle middle(world, wall_O);
  for (int corner = 0; corner < 3; ++corner) {
    for (const int first_edge : {corner, (corner + 2) % 3}) {
      if (!go_around(middle, corner, first_edge)) break;
    }
  }
}

/// Goes around a corner over one of its two edges, as far as no crease is crossed. False where that led all
/// the way around, or the fan is full: there is nothing left to find the other way.
bool FacetFan::go_around(const Middle& middle, int corner, int first_edge) noexcept {
  const Part& part = middle.part;
  VertexTurn at{part.welded(corner, middle.triangle), middle.triangle, first_edge};
  for (int turn = 0; turn < ProxyLimits::most_turns; ++turn) {
    const int next = at.next(part);
    if (next < 0 || has_crease(part, at.triangle, at.edge)) break;
    if (next == middle.triangle || count_ == ProxyLimits::most_neighbours) return false;
    at.go_on(part);
    ++looks_;
    if (!is_met_already(middle, next)) add_if_behind(middle, next);
  }
  return true;
}

/// A facet across an edge is met about both of the edge's corners.
bool FacetFan::is_met_already(const Middle& middle, int t) const noexcept {
  if (!(middle.part.neighbours.col(middle.triangle).array() == t).any()) return false;
  const auto known = neighbours_O();
  return std::any_of(known.begin(), known.end(), [t](const ProxyWall& wall) { return wall.triangle == t; });
}

void FacetFan::add_if_behind(const Middle& middle, int t) noexcept {
  const TriangleCorners corners = corners_of(middle.part, t);
  const Vec3 normal_P = middle.side * corners.normal;
  if (!(normal_P.dot(middle.normal_P) > 0) || !middle.behind.hide(corners)) return;
  neighbours_O_[static_cast<std::size_t>(count_++)] = {
      middle.world.turned_from_part(middle.surface, normal_P),
      middle.world.clearance_m() + normal_P.dot(corners.a - middle.origin_P), middle.surface, t};
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
