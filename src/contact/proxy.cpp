#include "contact/proxy.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "contact/proxy_start.hpp"

namespace fingerpad {
namespace {

/// Farther than this from the parts, in their extent, the proxy is let go: coordinates there tell nothing.
constexpr double farthest = 1e6;
/// In contact the proxy goes at most so many times as far as the finger ...
constexpr double proxy_per_finger = 2;
/// ... or, where the finger rests, lets the depth go at this pace [s].
constexpr double release_s = 0.5;
constexpr int most_steps = 64;
constexpr int most_hops = 32;
/// A view of about so many triangles pays: more are sorted out for nothing, fewer are soon left behind.
constexpr std::size_t poor_view = 8, rich_view = 32;
/// However rich, it reaches as far as the finger goes in so many ticks, and by this share of the clearance:
/// facets much smaller than either are many at any reach.
constexpr double least_steps = 2, least_share = 1.0 / 32;
/// Sine of the angle between a wall and the facet or edge that it stands for, once there is nothing to gain.
constexpr double same_wall = 1e-8;

}  // namespace

Proxy::Proxy(std::vector<ProxySurface> surfaces, double radius_m, Normals normals)
    : around_(std::move(surfaces), radius_m), normals_(normals) {
  reset();
}

/// Without parts there is nothing to be looked for, however far.
double Proxy::widest_view() const noexcept {
  return around_.extent_m() > 0 ? around_.extent_m() : std::numeric_limits<double>::infinity();
}

void Proxy::reset() noexcept {
  placed_ = false;
  lags_ = false;
  cruise_.kind = Cruise::Kind::none;
  reach_m_ = 0.01 * widest_view();
  contact_ = {};
}

const ProxyContact& Proxy::move(const Vec3& p_WQ, double dt_s) noexcept {
  const Vec3 goal = p_WQ - around_.centre_W();
  const double extent_m = around_.extent_m();
  if (extent_m > 0 && !(goal.cwiseAbs().maxCoeff() <= farthest * extent_m)) {
    reset();
    return contact_;
  }
  last_push_ = contact_.touching ? Vec3(contact_.depth_m * contact_.normal_W) : Vec3::Zero();
  last_direction_ = contact_.direction_W;
  rest_share_ = std::min(1.0, dt_s / release_s);
  hopped_ = false;
  contact_.started = !placed_;
  if (!placed_) start(goal);
  if (!placed_) return contact_;
  finger_m_ = (goal - last_goal_).norm();
  last_goal_ = goal;
  if (cruise(goal)) return contact_;
  double budget_m = std::numeric_limits<double>::infinity();
  if (contact_.touching)
    budget_m = std::max(proxy_per_finger * finger_m_, (goal - place_).norm() * rest_share_);
  if (!contact_.touching && fly(goal)) return contact_;
  follow(goal, budget_m);
  return contact_;
}

void Proxy::start(const Vec3& goal) noexcept {
  cruise_.kind = Cruise::Kind::none;
  contact_ = {};
  contact_.started = true;
  const auto place = proxy_start(around_, goal);
  contact_.placed = placed_ = place.has_value();
  if (!placed_) return;
  place_ = *place;
  last_goal_ = goal;
}

bool Proxy::is_at_rest(const ProxyStep& step) const noexcept {
  for (int k = 0; k < step.wall_count; ++k) {
    const ProxyWall& wall = step.walls[static_cast<std::size_t>(k)];
    if (wall.triangle < 0) continue;
    const ProxySurface& surface = around_.surfaces()[static_cast<std::size_t>(wall.surface)];
    const TriangleApproach approach =
        approach_triangle(surface.tree->part(), wall.triangle, around_.in_part(wall.surface, place_));
    if (approach.distance_m > around_.clearance_m() + 4 * around_.tolerance_m()) return false;
    if ((surface.R_WP * approach.towards - wall.normal).squaredNorm() > same_wall * same_wall) return false;
  }
  return true;
}

/// Goes the step as far as the budget lets it; true where the proxy has come to its end for this tick.
bool Proxy::advance(const ProxyStep& step, const Vec3& goal, double& budget_m) noexcept {
  const double length_m = step.z.norm();
  hold_place_ = place_;
  hold_ = step;
  contact_.settled = !(length_m > budget_m);
  if (!contact_.settled) {
    place_ += step.z * (budget_m / length_m);
    return true;
  }
  budget_m -= length_m;
  place_ += step.z;
  if (step.truncated) return false;
  if (step.wall_count == 0 && !step.stuck) {
    place_ = goal;
    return true;
  }
  return length_m <= around_.tolerance_m() || is_at_rest(step);
}

/// Makes the next views wider or narrower, after what a search has found.
void Proxy::suit_view() noexcept {
  const double seen_m = around_.search_reach_m();
  if (around_.is_cut()) reach_m_ = std::min(reach_m_, seen_m);
  const double least_m = std::max(least_steps * finger_m_, least_share * around_.clearance_m());
  if (around_.view_count() > rich_view) reach_m_ = std::min(reach_m_, std::max(0.7 * seen_m, least_m));
  if (around_.view_count() < poor_view && seen_m >= reach_m_)
    reach_m_ = std::min(1.2 * reach_m_, widest_view());
}

/// Steps until the proxy is as close to the finger as it gets, or the budget is spent.
void Proxy::settle(const Vec3& goal, double& budget_m) noexcept {
  cruise_.kind = Cruise::Kind::none;
  double reach_m = reach_m_;
  bool ended = false, truncated = false;
  for (int k = 0; k < most_steps && !ended; ++k) {
    if (goal == place_) {
      hold_ = {};
      break;
    }
    reach_m = around_.look_around(place_, reach_m, truncated);
    const ProxyStep step = around_.step_towards(goal - place_, nullptr);
    if (around_.is_fresh()) suit_view();
    ended = advance(step, goal, budget_m);
    truncated = step.truncated;
    if (truncated && around_.view_count() <= rich_view) reach_m *= 2;
  }
  if (!ended) contact_.settled = goal == place_;
}

void Proxy::follow(const Vec3& goal, double budget_m) noexcept {
  // Over smooth edges first: what a hop gains is the facets', not the finger's, and costs no budget. What
  // the proxy slides after it does. One hop that is felt is enough for a tick.
  if (!(hop(goal) || roll(goal, budget_m)) || !has_come_to_rest()) settle(goal, budget_m);
  for (int k = 0; k < most_hops && contact_.settled && !is_felt(goal); ++k) {
    remember();
    if (!hop(goal)) break;
    if (!has_come_to_rest()) settle(goal, budget_m);
  }
  if (!cruise(goal)) report(goal);
}

/// After a hop: it landed and slides, or is held as it should be.
bool Proxy::has_come_to_rest() const noexcept {
  return cruise_.kind == Cruise::Kind::slide || (!hold_.truncated && is_at_rest(hold_));
}

/// Sees to a view that shows the way over an edge to `far`, and some more in this direction.
/// @param way_m  to the edge
void Proxy::look_towards(const Vec3& far, double way_m) noexcept {
  const double far_m = far.norm(), need_m = 3 * std::max(far_m, way_m);
  if (need_m < (1 - lead) * reach_m_) {
    if (around_.look_ahead(place_, need_m, reach_m_, lead * reach_m_ / far_m * far)) suit_view();
  } else if (around_.look_around(place_, std::max(reach_m_, way_m), false) < way_m) {
    around_.look_around(place_, std::max(reach_m_, way_m), true);
  }
}

/// The largest change of the push in a tick: the finger's motion and the proxy's.
double Proxy::most_step_m() const noexcept {
  return finger_m_ + std::max(proxy_per_finger * finger_m_, last_push_.norm() * rest_share_);
}

/// Whether the hops of this tick change the push by more than hops may. A first touch may be anything.
bool Proxy::is_felt(const Vec3& goal) const noexcept {
  if (!hopped_ || last_push_.isZero(0)) return false;
  const Vec3 way = place_ - goal, last_way = last_push_.norm() * last_direction_;
  return (way - last_way).norm() > most_step_m() + unfelt_share * way.norm();
}

/// Goes over the smooth convex edge to the neighbour that is nearer to the finger. False where there is none,
/// or the way is blocked or no gain, and while an earlier hop is still on its way to be shown.
bool Proxy::hop(const Vec3& goal) noexcept {
  if (cruise_.kind != Cruise::Kind::slide || cruise_.wall_count != 1 || fan_.count == 0 || lags_)
    return false;
  const ProxyWall* nearer = nearer_neighbour(goal);
  if (nearer == nullptr) return false;
  ProxyWall here = cruise_.walls[0], there = *nearer;
  here.least_m -= here.normal.dot(place_);
  there.least_m -= there.normal.dot(place_);
  if (!go_over(here, there, goal, std::numeric_limits<double>::infinity())) return false;
  hopped_ = true;
  return true;
}

/// Goes on around the one triangle that holds the proxy, to where the finger is now. False where another way
/// of holding it has to be looked for.
bool Proxy::roll(const Vec3& goal, double budget_m) noexcept {
  if (hold_.wall_count != 1 || hold_.walls[0].triangle < 0 || hold_.stuck || !contact_.settled) return false;
  const ProxyWall here =
      around_.tangent_wall(hold_.walls[0].surface, hold_.walls[0].triangle, place_, place_);
  if (std::abs(here.least_m) > 4 * around_.tolerance_m()) return false;
  const ProxyWall there = around_.tangent_wall(here.surface, here.triangle, goal, place_);
  constexpr double least_cosine = 0.5;
  if (!(here.normal.dot(there.normal) > least_cosine)) return false;
  return go_over(here, there, goal, budget_m);
}

/// Goes from one wall to another, by way of where the ball lies on both. False where the way is blocked, no
/// gain, or longer than the budget.
/// @param here, there  seen from the proxy's place
bool Proxy::go_over(const ProxyWall& here, const ProxyWall& there, const Vec3& goal,
                    double budget_m) noexcept {
  const double depth_m = there.least_m - there.normal.dot(goal - place_);
  const Vec3 far = goal - place_ + depth_m * there.normal;
  const Vec3 middle = 0.5 * far;
  const std::optional<Vec3> over = on_both_walls(middle, here, there);
  if (!over) return false;
  const double way_m = over->norm(), rest_m = (far - *over).norm();
  // Over an edge that is near, not where the planes meet at all.
  if (way_m > 1.5 * far.norm() || way_m + rest_m > budget_m) return false;
  look_towards(far, way_m);
  const Vec3 edge_place = place_ + *over;
  if (!is_in_room(edge_place) && (around_.reach_m() < way_m || !around_.is_free(*over, std::span(&here, 1))))
    return false;
  const double gone_m = (goal - place_).norm() - around_.tolerance_m();
  if (depth_m > 0 && depth_m < gone_m && land(there, edge_place, place_ + far)) return true;

  ProxyWall first = there;
  first.least_m -= first.normal.dot(*over);
  around_.look_ahead(edge_place, std::min(rest_m, 0.5 * reach_m_), std::max(reach_m_, rest_m), Vec3::Zero());
  const ProxyStep step = around_.step_towards(goal - edge_place, &first);
  const Vec3 new_place = edge_place + step.z;
  if (!((goal - new_place).norm() < gone_m)) return false;
  contact_.settled = true;
  cruise_.kind = Cruise::Kind::none;
  place_ = new_place;
  hold_place_ = edge_place;
  hold_ = step;
  return true;
}

}  // namespace fingerpad
