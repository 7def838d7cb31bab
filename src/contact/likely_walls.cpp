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

struct TriangleUnder {
  int triangle;
  bool is_whole;  ///< the way has come to its end
};

/// The triangle over whose face a place lies, going from one to its neighbour across the edge that the place
/// is farthest beyond. The way ends at a triangle without a neighbour there, and at one whose neighbour would
/// lead straight back: over a convex edge a place is beyond both.
TriangleUnder triangle_under(const Part& part, int triangle, const Vec3& q_P, Looks& looks) noexcept {
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
    if (next < 0 || next == before) return {triangle, true};
    before = std::exchange(triangle, next);
  }
  return {triangle, false};
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
                                      world_.in_part(blocker.surface, place_O), looks_)
                           .triangle;
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

/// Of the triangle that the step likely ends at, if the ball is in front of it.
std::optional<ProxyWall> LikelyWalls::wall_ahead(const Vec3& place_O, const Vec3& goal_O, double way_m,
                                                 const Blocker& near) noexcept {
  if (ahead_goal_O_ != goal_O) {
    ahead_ = triangle_ahead(place_O, goal_O, way_m, ahead_.triangle < 0 ? near : ahead_);
    // What is looked at in part may lead to the wrong side.
    if (looks_.are_spent()) return std::nullopt;
    ahead_goal_O_ = goal_O;
  }
  const Blocker& ahead = ahead_;
  if (ahead.triangle < 0) return std::nullopt;
  const ProxyWall seen = world_.tangent_wall(ahead.surface, ahead.triangle, goal_O, place_O);
  if (seen.least_m <= world_.tolerance_m()) return seen;
  // The finger is behind it: its own plane, if the ball is in front of that.
  const TriangleCorners f = corners_of(world_.part(ahead.surface), ahead.triangle);
  const Vec3 place_P = world_.in_part(ahead.surface, place_O);
  const FacetSide facet = facet_side(f, place_P, place_P, world_.clearance_m(), world_.tolerance_m());
  if (facet.side == 0) return std::nullopt;
  return ProxyWall{world_.turned_from_part(ahead.surface, facet.side * f.normal), -facet.slack_m,
                   ahead.surface, ahead.triangle};
}

/// The one under the finger, where the surface leads there from where the straight way meets it: what is
/// closer to the finger may belong to another side of the part, on which the step does not end. Else one that
/// is about the closest.
Blocker LikelyWalls::triangle_ahead(const Vec3& place_O, const Vec3& goal_O, double way_m,
                                    const Blocker& near) noexcept {
  const double reach_m = std::max(way_m, world_.clearance_m());
  const Blocker met = first_met(place_O, goal_O);
  if (met.triangle < 0) return about_closest(goal_O, reach_m, near);
  const Part& part = world_.part(met.surface);
  const TriangleUnder under = triangle_under(part, met.triangle, world_.in_part(met.surface, goal_O), looks_);
  if (under.is_whole) return {met.surface, under.triangle};
  // It is farther than one goes from triangle to triangle. A surface that has turned so far may turn on.
  const Blocker closest = about_closest(goal_O, reach_m, near);
  if (closest.surface != met.surface || closest.triangle < 0) return {met.surface, under.triangle};
  const auto turn_cosine = [&](int from, int to) {
    return part.facet_normals.col(from).dot(part.facet_normals.col(to));
  };
  const bool may_lead_there = turn_cosine(met.triangle, under.triangle) < Limits::turning_cosine ||
                              turn_cosine(under.triangle, closest.triangle) > Limits::same_side_cosine;
  return may_lead_there ? closest : Blocker{met.surface, under.triangle};
}

/// The triangle that the straight way to the finger meets first, about.
Blocker LikelyWalls::first_met(const Vec3& place_O, const Vec3& goal_O) noexcept {
  Blocker first;
  double along = std::numeric_limits<double>::infinity();
  for (const int i : world_.parts()) {
    const TriangleMet met = world_.surface(i).tree->about_first_met(
        world_.in_part(i, place_O), world_.turned_into_part(i, goal_O - place_O), looks_);
    if (!(met.along < along)) continue;
    first = {i, met.triangle};
    along = met.along;
  }
  return first;
}

/// @param near  where to begin, if the surface goes on from there
Blocker LikelyWalls::about_closest(const Vec3& place_O, double reach_m, const Blocker& near) noexcept {
  Blocker closest;
  for (const int i : world_.parts()) {
    const Vec3 place_P = world_.in_part(i, place_O);
    const int seed =
        near.surface == i ? triangle_under(world_.part(i), near.triangle, place_P, looks_).triangle : -1;
    const ClosestTriangle found =
        world_.surface(i).tree->about_closest(place_P, seed, reach_m, Limits::closest_packets, looks_);
    if (found.triangle < 0) continue;
    closest = {i, found.triangle};
    reach_m = std::sqrt(found.at.distance2_m2);
  }
  return closest;
}

}  // namespace fingerpad
