#include "contact/likely_walls.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "contact/proxy_memory_limits.hpp"

namespace fingerpad {

using Limits = ProxyMemoryLimits;

namespace {

/// The triangle over whose face a place lies, going from one to its neighbour across the edge that the place
/// is farthest beyond. The way ends at a triangle without a neighbour there, and at one whose neighbour would
/// lead straight back: over a convex edge a place is beyond both.
int triangle_under(const Part& part, int triangle, const Vec3& q_P, Looks& looks) noexcept {
  int before = -1;
  for (int k = 0; k < Limits::most_walked; ++k) {
    looks.spend(LookCosts::told);
    const TriangleCorners f = corners_of(part, triangle);
    const std::array<Vec3, 3> corners = {f.a, f.b, f.c};
    double farthest_m = 0;
    int next = -1;
    for (int edge = 0; edge < 3; ++edge) {
      const Vec3 &from = corners[edge], along = corners[(edge + 1) % 3] - from;
      const double beyond_m = along.cross(f.normal).dot(q_P - from) / along.norm();
      if (!(beyond_m > farthest_m)) continue;
      farthest_m = beyond_m;
      next = part.neighbours(edge, triangle);
    }
    if (next < 0 || next == before) break;
    before = std::exchange(triangle, next);
  }
  return triangle;
}

}  // namespace

void LikelyWalls::forget() noexcept {
  ahead_goal_O_ = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  ahead_ = {};
}

void LikelyWalls::find(const Vec3& place_O, const Vec3& goal_O, double way_m,
                       const std::array<Blocker, 3>& blockers) noexcept {
  count_ = 0;
  has_one_ahead_ = false;
  // Two at most: the third place is for a wall that is met on the way. Of a corner of three walls it may take
  // steps.
  for (const Blocker& blocker : std::span(blockers).first<2>()) {
    const std::optional<ProxyWall> here = wall_touched(blocker, place_O);
    if (!here) continue;
    const auto is_here = [&](const ProxyWall& wall) {
      return wall.surface == here->surface && wall.triangle == here->triangle;
    };
    if (std::none_of(found().begin(), found().end(), is_here)) add(*here);
  }
  if (const auto ahead = wall_ahead(place_O, goal_O, way_m, blockers[0])) {
    const Vec3 goal = goal_O - place_O, end = goal + std::max(0.0, ahead->lack_m(goal)) * ahead->normal;
    // Over a convex surface a wall here holds the ball off what lies ahead: that is for the next step.
    has_one_ahead_ = std::all_of(found().begin(), found().end(), [&](const ProxyWall& here) {
      return here.lack_m(end) <= world_.touching_m();
    });
    if (has_one_ahead_) add(*ahead);
  }
  if (count_ > 0) return;
  if (const auto below = wall_below(place_O, way_m, blockers[0])) add(*below);
}

/// Of a triangle that held the proxy last, or of the one that the surface goes on to from there under the
/// place, if the ball lies on it.
std::optional<ProxyWall> LikelyWalls::wall_touched(const Blocker& blocker, const Vec3& place_O) noexcept {
  if (blocker.triangle < 0) return std::nullopt;
  const int triangle = triangle_under(world_.part(blocker.surface), blocker.triangle,
                                      world_.in_part(blocker.surface, place_O), looks_);
  const ProxyWall wall = world_.wall_at(blocker.surface, triangle, place_O);
  return std::abs(wall.least_m) <= world_.touching_m() ? std::optional(wall) : std::nullopt;
}

/// Of a triangle that is about the closest to the place.
std::optional<ProxyWall> LikelyWalls::wall_below(const Vec3& place_O, double way_m,
                                                 const Blocker& near) noexcept {
  const Blocker below = about_closest(place_O, world_.clearance_m() + way_m, near);
  if (below.triangle < 0) return std::nullopt;
  return world_.wall_at(below.surface, below.triangle, place_O);
}

/// Of a triangle that is about the closest to the finger, if the ball is in front of it: where it is smooth
/// there the step ends at it.
std::optional<ProxyWall> LikelyWalls::wall_ahead(const Vec3& place_O, const Vec3& goal_O, double way_m,
                                                 const Blocker& near) noexcept {
  if (ahead_goal_O_ != goal_O) {
    ahead_ =
        about_closest(goal_O, std::max(way_m, world_.clearance_m()), ahead_.triangle < 0 ? near : ahead_);
    if (!looks_.are_spent()) ahead_goal_O_ = goal_O;
  }
  if (ahead_.triangle < 0) return std::nullopt;
  const ProxyWall seen = world_.tangent_wall(ahead_.surface, ahead_.triangle, goal_O, place_O);
  if (seen.least_m <= world_.tolerance_m()) return seen;
  // The finger is behind it: its own plane, if the ball is in front of that.
  const TriangleCorners f = corners_of(world_.part(ahead_.surface), ahead_.triangle);
  const Vec3 place_P = world_.in_part(ahead_.surface, place_O);
  const FacetSide facet = facet_side(f, place_P, place_P, world_.clearance_m(), world_.tolerance_m());
  if (facet.side == 0) return std::nullopt;
  return ProxyWall{world_.turned_from_part(ahead_.surface, facet.side * f.normal), -facet.slack_m,
                   ahead_.surface, ahead_.triangle};
}

/// @param near  where to begin, if the surface goes on from there
Blocker LikelyWalls::about_closest(const Vec3& place_O, double reach_m, const Blocker& near) noexcept {
  Blocker closest;
  for (const int i : world_.parts()) {
    const Vec3 place_P = world_.in_part(i, place_O);
    const int seed = near.surface == i ? triangle_under(world_.part(i), near.triangle, place_P, looks_) : -1;
    const ClosestTriangle found =
        world_.surface(i).tree->about_closest(place_P, seed, reach_m, Limits::closest_packets, looks_);
    if (found.triangle < 0) continue;
    closest = {i, found.triangle};
    reach_m = std::sqrt(found.at.distance2_m2);
  }
  return closest;
}

}  // namespace fingerpad
