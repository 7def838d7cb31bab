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

/// A way over a part's surface.
struct Slide {
  enum class End { under, held, cut };

  int triangle;        ///< where it ends
  Vec3 at_P;           ///< on it
  End end = End::cut;  ///< under the place; at a rim, or an edge beyond which it would lead straight back; or
                       ///< it was cut short
};

/// The way from there towards a place, in each triangle straight to the foot of the place on its plane: that
/// of a point that is drawn to the place and cannot leave the surface.
Slide slide_under(const Part& part, Slide slide, const Vec3& to_P, Looks& looks) noexcept {
  int before = -1;
  for (int k = 0; k < Limits::most_walked; ++k) {
    looks.spend(LookCosts::told);
    const TriangleCorners f = corners_of(part, slide.triangle);
    const std::array<Vec3, 3> corners = {f.a, f.b, f.c};
    const Vec3 straight = to_P - slide.at_P, way = straight - f.normal.dot(straight) * f.normal;
    double share = 1;
    int leaves_by = -1;
    for (int edge = 0; edge < 3; ++edge) {
      const Vec3 &from = corners[edge], along = corners[(edge + 1) % 3] - from;
      const Vec3 out = along.cross(f.normal);
      const double speed = out.dot(way), room = out.dot(from - slide.at_P);
      if (!(speed > 0 && room < share * speed)) continue;
      share = std::max(0.0, room / speed);
      leaves_by = edge;
    }
    slide.at_P += share * way;
    if (leaves_by < 0) {
      slide.end = Slide::End::under;
      return slide;
    }
    const int next = part.neighbours(leaves_by, slide.triangle);
    if (next < 0 || next == before) {
      slide.end = Slide::End::held;
      return slide;
    }
    before = std::exchange(slide.triangle, next);
  }
  return slide;
}

}  // namespace

/// Where the straight way meets a part.
struct LikelyWalls::Met {
  int surface = -1, triangle = -1;
  Vec3 at_P = Vec3::Zero();
};

void LikelyWalls::let_go() noexcept {
  ahead_goal_O_ = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
}

void LikelyWalls::forget() noexcept {
  let_go();
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
  if (count_ > 0 || looks_.are_spent()) return;
  if (const auto below = wall_below(place_O, goal_O, way_m, blockers[0])) add(*below);
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

/// The wall that a triangle sets to the straight way; none where the ball goes past it. A way that meets
/// nothing may not be held by a guess: it leads somewhere else.
std::optional<ProxyWall> LikelyWalls::wall_in_way(const Blocker& triangle, const Vec3& place_O,
                                                  const Vec3& goal_O) noexcept {
  if (triangle.triangle < 0) return std::nullopt;
  const PartWay way(world_, triangle.surface, world_.in_part(triangle.surface, place_O), goal_O - place_O);
  const TriangleCorners corners = corners_of(world_.part(triangle.surface), triangle.triangle);
  WorstWall worst = LookRound(world_.tolerance_m()).worst;
  worst.offer_triangle(world_, way, corners, triangle.triangle,
                       FirstApproach(approach_triangle(corners, way.from_P)));
  looks_.spend(LookCosts::told + worst.looks);
  return worst.wall;
}

/// Of a triangle that is about the closest to the place; where the way meets no surface, if it is in the way.
std::optional<ProxyWall> LikelyWalls::wall_below(const Vec3& place_O, const Vec3& goal_O, double way_m,
                                                 const Blocker& near) noexcept {
  const Blocker below = about_closest(place_O, world_.clearance_m() + way_m, near);
  if (below.triangle < 0 || (!ahead_.is_met && !wall_in_way(below, place_O, goal_O))) return std::nullopt;
  return world_.wall_at(below.surface, below.triangle, place_O);
}

/// Of the triangle that the step likely ends at, if the ball is in front of it.
std::optional<ProxyWall> LikelyWalls::wall_ahead(const Vec3& place_O, const Vec3& goal_O, double way_m,
                                                 const Blocker& near) noexcept {
  if (ahead_goal_O_ != goal_O) {
    ahead_ = triangle_ahead(place_O, goal_O, way_m, ahead_.at.triangle < 0 ? near : ahead_.at);
    // What is looked at in part may lead to the wrong side.
    if (looks_.are_spent()) return std::nullopt;
    ahead_goal_O_ = goal_O;
  }
  const auto [at, is_met] = ahead_;
  if (at.triangle < 0) return std::nullopt;
  if (!is_met) return wall_in_way(at, place_O, goal_O);
  const ProxyWall seen = world_.tangent_wall(at.surface, at.triangle, goal_O, place_O);
  if (seen.least_m <= world_.tolerance_m()) return seen;
  // The finger is behind it: its own plane, if the ball is in front of that.
  const TriangleCorners f = corners_of(world_.part(at.surface), at.triangle);
  const Vec3 place_P = world_.in_part(at.surface, place_O);
  const FacetSide facet = facet_side(f, place_P, place_P, world_.clearance_m(), world_.tolerance_m());
  if (facet.side == 0) return std::nullopt;
  return ProxyWall{world_.turned_from_part(at.surface, facet.side * f.normal), -facet.slack_m, at.surface,
                   at.triangle};
}

/// The one that the surface leads to from where the straight way meets it: what is closer to the finger may
/// belong to another side of the part, on which the step does not end. None where the ball touches something
/// else first. Of a way that meets nothing the one about the closest to the finger.
LikelyWalls::Ahead LikelyWalls::triangle_ahead(const Vec3& place_O, const Vec3& goal_O, double way_m,
                                               const Blocker& near) noexcept {
  const double reach_m = std::max(way_m, world_.clearance_m());
  const Met met = first_met(place_O, goal_O);
  if (looks_.are_spent()) return {};
  if (met.triangle < 0) return {about_closest(goal_O, reach_m, near)};
  const Part& part = world_.part(met.surface);
  const Vec3 goal_P = world_.in_part(met.surface, goal_O);
  if (!is_touched_first(met, world_.in_part(met.surface, place_O), goal_P)) return {{}, true};
  const Slide slide = slide_under(part, {met.triangle, met.at_P}, goal_P, looks_);
  if (slide.end != Slide::End::cut) return {{met.surface, slide.triangle}, true};
  // It is farther than one goes from triangle to triangle. A surface that has turned so far may turn on.
  const Blocker closest = about_closest(goal_O, reach_m, near);
  if (closest.surface != met.surface || closest.triangle < 0) return {{met.surface, slide.triangle}, true};
  const auto turn_cosine = [&](int from, int to) {
    return part.facet_normals.col(from).dot(part.facet_normals.col(to));
  };
  const bool may_lead_there = turn_cosine(met.triangle, slide.triangle) < Limits::turning_cosine ||
                              turn_cosine(slide.triangle, closest.triangle) > Limits::same_side_cosine;
  return {may_lead_there ? closest : Blocker{met.surface, slide.triangle}, true};
}

/// The triangle that the straight way to the finger meets first, about, and where.
LikelyWalls::Met LikelyWalls::first_met(const Vec3& place_O, const Vec3& goal_O) noexcept {
  Met first;
  double along = std::numeric_limits<double>::infinity();
  for (const int i : world_.parts()) {
    const Vec3 place_P = world_.in_part(i, place_O), way_P = world_.turned_into_part(i, goal_O - place_O);
    const TriangleMet met = world_.surface(i).tree->about_first_met(place_P, way_P, looks_);
    if (!(met.along < along)) continue;
    along = met.along;
    first = {i, met.triangle, place_P + along * way_P};
  }
  return first;
}

/// Whether the ball comes to lie on the surface there before anything else, as far as that tells: from where
/// its centre's way meets the surface this leads under where it lies on the triangle's plane. Else an edge is
/// in its way.
bool LikelyWalls::is_touched_first(const Met& met, const Vec3& place_P, const Vec3& goal_P) noexcept {
  const Part& part = world_.part(met.surface);
  const Vec3 normal = part.facet_normals.col(met.triangle);
  const double from_m = normal.dot(place_P - met.at_P), to_m = normal.dot(goal_P - met.at_P);
  const double lies_at_m = std::copysign(world_.clearance_m(), from_m);
  if (!(std::abs(from_m) > world_.clearance_m())) return true;  // it lies there, or all but
  const Vec3 lies_P = place_P + (from_m - lies_at_m) / (from_m - to_m) * (goal_P - place_P);
  return slide_under(part, {met.triangle, met.at_P}, lies_P, looks_).end != Slide::End::held;
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
