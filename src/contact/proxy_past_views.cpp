#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "contact/proxy_limits.hpp"
#include "contact/proxy_views.hpp"

// Steps that go farther than views reach. Where facets are much smaller than a tick's way a view shows a
// little of it, and steps from view to view would take more looks than a tick has.

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

/// Of a step that ended where its rich view did. A view that was cut to less than `hopeless_share` does
/// not count: the richest view comes next, which shows more.
void ProxyViews::note_short_step(const ProxyStep& step, long looks) noexcept {
  if (!falls_short_ || step.end == StepEnd::broken_off || near_.count() <= Limits::rich_view) return;
  if (is_cut_ && reach_m_ < Limits::hopeless_share * world_.clearance_m()) return;
  short_step_m_ = step.z.norm();
  short_step_looks_ = looks;
}

bool ProxyViews::is_outrun(const Vec3& place_O, double way_m) const noexcept {
  return is_crowded_about(place_O) || Limits::eager * way_m * static_cast<double>(short_step_looks_) >
                                          short_step_m_ * static_cast<double>(looks_.left());
}

/// Whether the richest view found too many not far from there: it would again.
bool ProxyViews::is_crowded_about(const Vec3& place_O) const noexcept {
  const double near_m = Limits::crowded_share * world_.clearance_m();
  return (place_O - crowded_place_O_).squaredNorm() <= near_m * near_m;
}

/// A step that the trees are asked for along its whole way, as the plain sight does; but it begins with the
/// walls that likely hold it, since nearly all facets that the straight way to the finger meets stand behind
/// these.
ProxyStep ProxyViews::step_past_views(const Vec3& place_O, const Vec3& goal_O,
                                      const StepTerms& terms) noexcept {
  const double way_m = std::min((goal_O - place_O).norm(), terms.most_m);
  double bent_m = terms.bent_m;
  std::array<ProxyWall, 3> first;
  std::size_t count = 0;
  // Two at most: the third place is for a wall that is met on the way. Of a corner of three walls it may take
  // steps.
  for (const Blocker& blocker : std::span(blockers_).first<2>()) {
    const std::optional<ProxyWall> here = wall_touched(blocker, place_O);
    if (!here) continue;
    const auto is_here = [&](const ProxyWall& wall) {
      return wall.surface == here->surface && wall.triangle == here->triangle;
    };
    if (std::none_of(first.data(), first.data() + count, is_here)) first[count++] = *here;
  }
  if (const auto ahead = wall_ahead(place_O, goal_O, way_m)) {
    const Vec3 goal = goal_O - place_O, end = goal + std::max(0.0, ahead->lack_m(goal)) * ahead->normal;
    // Over a convex surface a wall here holds the ball off what lies ahead: that is for the next step.
    if (std::all_of(first.data(), first.data() + count,
                    [&](const ProxyWall& here) { return here.lack_m(end) <= world_.touching_m(); })) {
      first[count++] = *ahead;
      bent_m = 0;  // which is for a wall that stands for where the step begins
    }
  }
  if (count == 0) {
    if (const auto below = wall_below(place_O, way_m)) first[count++] = *below;
  }
  if (looks_.are_spent()) return broken_off_step();
  place_O_ = place_O;
  reach_m_ = way_m * (1 + Limits::rounding);
  is_past_views_ = goes_past_views_ = true;
  falls_short_ = false;
  making_.begin(*this, goal_O, reach_m_, bent_m);
  for (std::size_t k = 0; k < count; ++k) making_.guess(first[k]);
  const ProxyStep step = making_.go_on(*this);
  note_blockers(step);
  return step;
}

/// Of a step that was broken off some walls may be missing: it stays where those of before hold it.
void ProxyViews::note_blockers(const ProxyStep& step) noexcept {
  if (step.wall_count == 0 || step.end == StepEnd::broken_off) return;
  blockers_ = {};
  std::transform(step.held_by().begin(), step.held_by().end(), blockers_.begin(), [](const ProxyWall& wall) {
    return Blocker{wall.surface, wall.triangle};
  });
}

/// Of a triangle that held the proxy last, or of the one that the surface goes on to from there under the
/// place, if the ball lies on it.
std::optional<ProxyWall> ProxyViews::wall_touched(const Blocker& blocker, const Vec3& place_O) noexcept {
  if (blocker.triangle < 0) return std::nullopt;
  const int triangle = triangle_under(world_.part(blocker.surface), blocker.triangle,
                                      world_.in_part(blocker.surface, place_O), looks_);
  const ProxyWall wall = world_.wall_at(blocker.surface, triangle, place_O);
  return std::abs(wall.least_m) <= world_.touching_m() ? std::optional(wall) : std::nullopt;
}

/// Of a triangle that is about the closest to the place.
std::optional<ProxyWall> ProxyViews::wall_below(const Vec3& place_O, double way_m) noexcept {
  const Blocker below = about_closest(place_O, world_.clearance_m() + way_m, blockers_[0]);
  if (below.triangle < 0) return std::nullopt;
  return world_.wall_at(below.surface, below.triangle, place_O);
}

/// Of a triangle that is about the closest to the finger, if the ball is in front of it: where it is smooth
/// there the step ends at it.
std::optional<ProxyWall> ProxyViews::wall_ahead(const Vec3& place_O, const Vec3& goal_O,
                                                double way_m) noexcept {
  if (ahead_goal_O_ != goal_O) {
    ahead_ = about_closest(goal_O, std::max(way_m, world_.clearance_m()),
                           ahead_.triangle < 0 ? blockers_[0] : ahead_);
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
Blocker ProxyViews::about_closest(const Vec3& place_O, double reach_m, const Blocker& near) noexcept {
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
