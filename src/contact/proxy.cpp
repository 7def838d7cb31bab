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
constexpr std::size_t poor_view = 12, rich_view = 48;
/// Sine of the angle between a wall and the facet or edge that it stands for, once there is nothing to gain.
constexpr double same_wall = 1e-8;

double side_of(const Vec3& outer_normal, const Vec3& normal) noexcept {
  return outer_normal.dot(normal) < 0 ? -1 : 1;
}

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
  contact_.started = !placed_;
  if (!placed_) start(goal);
  if (!placed_) return contact_;
  const double finger_m = (goal - last_goal_).norm();
  last_goal_ = goal;
  if (cruise(goal)) return contact_;
  double budget_m = std::numeric_limits<double>::infinity();
  if (contact_.touching)
    budget_m =
        std::max(proxy_per_finger * finger_m, (goal - place_).norm() * std::min(1.0, dt_s / release_s));
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

bool Proxy::cruise(const Vec3& goal) noexcept {
  if (cruise_.kind == Cruise::Kind::none) return false;
  const bool slides = cruise_.kind == Cruise::Kind::slide;
  const ProxyWall& wall = cruise_.wall;
  const double lack_m = slides ? cruise_.wall_offset_m - wall.normal.dot(goal) : 0;
  const Vec3 place = lack_m > 0 ? Vec3(goal + lack_m * wall.normal) : goal;
  const bool in_room = (place - cruise_.centre).squaredNorm() <= cruise_.room_m * cruise_.room_m;
  if (!in_room || !around_.is_clear_of_planes(place, slides ? wall.surface : -1)) return false;
  if (lack_m > 0 && wall.triangle >= 0) {
    const Part& part = around_.surfaces()[static_cast<std::size_t>(wall.surface)].tree->part();
    const auto foot = approach_triangle(part, wall.triangle, around_.in_part(wall.surface, place));
    if (foot.at.feature != Feature::face || nearer_neighbour(goal) != nullptr) return false;
  }
  place_ = place;
  contact_.touching = false;
  if (!(lack_m > around_.skin_m())) return true;
  hold_place_ = place;
  hold_.wall_count = 1;
  hold_.walls[0] = wall;
  hold_.walls[0].least_m = 0;
  report(goal);
  return true;
}

bool Proxy::fly(const Vec3& goal) noexcept {
  constexpr int most_flights = 8;
  for (int k = 0; k < most_flights; ++k) {
    const double way_m = (goal - place_).norm();
    const double room_m = around_.room_m(place_, way_m + around_.extent_m());
    if (room_m >= way_m) {
      cruise_ = {};
      cruise_.kind = Cruise::Kind::flight;
      cruise_.centre = place_;
      cruise_.room_m = room_m * (1 - 1e-12);
      place_ = goal;
      return true;
    }
    if (!(room_m > reach_m_)) return false;
    cruise_.kind = Cruise::Kind::none;
    place_ += (goal - place_) * (room_m / way_m * (1 - 1e-9));
  }
  return false;
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
  if (around_.is_cut()) reach_m_ = std::min(reach_m_, around_.reach_m());
  if (around_.view_count() > rich_view) reach_m_ = std::min(reach_m_, 0.7 * around_.reach_m());
  if (around_.view_count() < poor_view && around_.reach_m() >= reach_m_)
    reach_m_ = std::min(1.2 * reach_m_, widest_view());
}

/// Steps until the proxy is as close to the finger as it gets, or the budget is spent.
void Proxy::settle(const Vec3& goal, double budget_m) noexcept {
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
  // Over smooth edges first: what a hop gains is the facets', not the finger's, and costs no budget.
  if (!hop(goal) || hold_.truncated || !is_at_rest(hold_)) settle(goal, budget_m);
  for (int k = 0; k < most_hops && contact_.settled; ++k) {
    remember();
    if (!hop(goal)) break;
    if (hold_.truncated || !is_at_rest(hold_)) settle(goal, std::numeric_limits<double>::infinity());
  }
  report(goal);
}

/// Notes how far the one wall that holds the proxy lets it slide.
void Proxy::remember() noexcept {
  cruise_.kind = Cruise::Kind::none;
  if (hold_.wall_count != 1 || hold_.stuck || around_.place() != hold_place_) return;
  const ProxyWall& wall = hold_.walls[0];
  if (wall.triangle >= 0) {
    const ProxySurface& surface = around_.surfaces()[static_cast<std::size_t>(wall.surface)];
    const Part& part = surface.tree->part();
    const auto foot = approach_triangle(part, wall.triangle, around_.in_part(wall.surface, place_));
    if (foot.at.feature != Feature::face) return;
  }
  cruise_.kind = Cruise::Kind::slide;
  cruise_.centre = hold_place_;
  cruise_.room_m = around_.room_in_front_of(wall);
  cruise_.wall = wall;
  cruise_.wall_offset_m = wall.normal.dot(hold_place_) + wall.least_m;
  remember_neighbours();
}

void Proxy::remember_neighbours() noexcept {
  cruise_.neighbour_count = 0;
  if (cruise_.wall.triangle < 0 || normals_ == Normals::facet) return;
  for (int corner = 0; corner < 3; ++corner) remember_fan(corner);
}

/// Goes around a corner of the wall's triangle, both ways as far as no crease is crossed.
void Proxy::remember_fan(int corner) noexcept {
  constexpr int most_turns = 64;
  const ProxyWall& wall = cruise_.wall;
  const ProxySurface& surface = around_.surfaces()[static_cast<std::size_t>(wall.surface)];
  const Part& part = surface.tree->part();
  const Vec3 outer = surface.R_WP * part.facet_normals.col(wall.triangle);
  const double side = side_of(outer, wall.normal);
  const double behind_m = cruise_.wall_offset_m - around_.clearance_m() + around_.tolerance_m();
  const int vertex = part.welded(corner, wall.triangle);
  for (const int first_edge : {corner, (corner + 2) % 3}) {
    int t = wall.triangle, edge = first_edge;
    for (int turn = 0; turn < most_turns; ++turn) {
      const int next = part.neighbours(edge, t);
      if (next < 0 || (part.creases[static_cast<std::size_t>(t)] >> edge & 1) != 0) break;
      if (next == wall.triangle || cruise_.neighbour_count == static_cast<int>(cruise_.neighbours.size()))
        return;
      int at = 0;
      while (at < 2 && part.welded(at, next) != vertex) ++at;
      // Of the two edges at the vertex, the one not come by.
      edge = part.neighbours(at, next) == t ? (at + 2) % 3 : at;
      t = next;
      const ProxyWall far = around_.facet_wall(wall.surface, t, side, Vec3::Zero());
      bool may_be_nearer = far.normal.dot(wall.normal) > 0;
      for (int c = 0; c < 3 && may_be_nearer; ++c) {
        const Vec3 q = around_.from_part(wall.surface, part.vertices.col(part.triangles(c, t)));
        may_be_nearer = wall.normal.dot(q) <= behind_m;
      }
      if (may_be_nearer) cruise_.neighbours[static_cast<std::size_t>(cruise_.neighbour_count++)] = far;
    }
  }
}

/// The neighbour with the finger's foot on it that is nearest to the finger, if it is nearer than the wall.
const ProxyWall* Proxy::nearer_neighbour(const Vec3& goal) const noexcept {
  const ProxyWall* nearest = nullptr;
  double least_depth_m = cruise_.wall_offset_m - cruise_.wall.normal.dot(goal) - around_.tolerance_m();
  for (int k = 0; k < cruise_.neighbour_count; ++k) {
    const ProxyWall& wall = cruise_.neighbours[static_cast<std::size_t>(k)];
    const double depth_m = wall.least_m - wall.normal.dot(goal);
    if (!(depth_m < least_depth_m)) continue;
    const Part& part = around_.surfaces()[static_cast<std::size_t>(wall.surface)].tree->part();
    const auto foot = approach_triangle(part, wall.triangle, around_.in_part(wall.surface, goal));
    // The finger's foot on the plane lies on the facet where the facet is no farther than the plane.
    if (foot.distance_m > std::abs(depth_m - around_.clearance_m()) + around_.tolerance_m()) continue;
    least_depth_m = depth_m;
    nearest = &wall;
  }
  return nearest;
}

/// Goes over the smooth convex edge to the neighbour that is nearer to the finger, by way of where the ball
/// lies on both. False where there is none, or the way is blocked or no gain.
bool Proxy::hop(const Vec3& goal) noexcept {
  if (cruise_.kind != Cruise::Kind::slide || cruise_.neighbour_count == 0) return false;
  const ProxyWall* nearer = nearer_neighbour(goal);
  if (nearer == nullptr) return false;

  const Vec3 old_place = place_;
  ProxyWall here = cruise_.wall, there = *nearer;
  here.least_m = cruise_.wall_offset_m - here.normal.dot(place_);
  there.least_m -= there.normal.dot(place_);
  const Vec3 far = goal - place_ + (there.least_m - there.normal.dot(goal - place_)) * there.normal;
  const Vec3 middle = 0.5 * far;
  const std::optional<Vec3> over = on_both_walls(middle, here, there);
  if (!over) return false;
  const double way_m = over->norm();
  if (way_m > 1.5 * far.norm()) return false;  // over an edge that is near, not where the planes meet at all
  const double view_m = std::max(reach_m_, way_m);
  if ((around_.look_around(place_, view_m, false) < way_m &&
       around_.look_around(place_, view_m, true) < way_m) ||
      !around_.is_free(*over, std::span(&here, 1)))
    return false;
  const Vec3 edge_place = place_ + *over;
  there.least_m -= there.normal.dot(*over);
  around_.look_around(edge_place, view_m, false);
  const ProxyStep step = around_.step_towards(goal - edge_place, &there);
  const Vec3 new_place = edge_place + step.z;
  if (!((goal - new_place).norm() < (goal - old_place).norm() - around_.tolerance_m())) return false;
  contact_.settled = true;
  cruise_.kind = Cruise::Kind::none;
  place_ = new_place;
  hold_place_ = edge_place;
  hold_ = step;
  return true;
}

ProxyHold Proxy::hold_at(const ProxyWall& wall, double share_m) const noexcept {
  ProxyHold hold;
  hold.surface = wall.surface;
  hold.triangle = wall.triangle;
  hold.share_m = share_m;
  hold.normal_W = wall.normal;
  const ProxySurface& surface = around_.surfaces()[static_cast<std::size_t>(wall.surface)];
  if (wall.triangle < 0) {
    hold.point_W = place_ + around_.plane_wall(wall.surface, place_).least_m * wall.normal -
                   around_.clearance_m() * wall.normal + around_.centre_W();
    return hold;
  }
  const Part& part = surface.tree->part();
  const Vec3 q = around_.in_part(wall.surface, place_);
  const TriangleApproach approach = approach_triangle(part, wall.triangle, q);
  hold.point_W = around_.from_part(wall.surface, approach.at.point) + around_.centre_W();
  const Vec3 normal_P = surface.R_WP.transpose() * wall.normal;
  const double side = side_of(part.facet_normals.col(wall.triangle), normal_P);
  hold.normal_W =
      surface.R_WP * (side * shaded_normal(part, wall.triangle, approach.at, normals_, side * normal_P));
  return hold;
}

void Proxy::report(const Vec3& goal) noexcept {
  const bool started = contact_.started;
  if (!contact_.settled) {
    report_underway(goal);
    return;
  }
  contact_.touching = false;
  if (hold_.wall_count == 0) {
    if (goal != place_) report_underway(goal);
    return;
  }
  contact_ = {};
  contact_.started = started;
  // The ball without its skin: the walls stand nearer by that.
  std::array<ProxyWall, 3> walls = hold_.walls;
  for (ProxyWall& wall : walls) wall.least_m -= around_.skin_m();
  const ProxyProjection p = project_onto_walls(
      goal - hold_place_, std::span(walls.data(), static_cast<std::size_t>(hold_.wall_count)),
      std::ldexp(around_.tolerance_m(), -2));
  if (!p.found) {
    report_underway(goal);
    return;
  }
  Vec3 push = Vec3::Zero(), shaded = Vec3::Zero();
  for (int k = 0; k < p.active_count; ++k) {
    const ProxyWall& wall = walls[static_cast<std::size_t>(p.active[k])];
    ProxyHold& hold = contact_.holds[static_cast<std::size_t>(k)] = hold_at(wall, p.share_m[k]);
    push += hold.share_m * wall.normal;
    shaded += hold.share_m * hold.normal_W;
  }
  contact_.hold_count = p.active_count;
  // By share; std::stable_sort would allocate.
  for (int k = 1; k < p.active_count; ++k) {
    for (int i = k; i > 0 && contact_.holds[i].share_m > contact_.holds[i - 1].share_m; --i)
      std::swap(contact_.holds[i], contact_.holds[i - 1]);
  }
  contact_.depth_m = push.norm();
  contact_.touching = contact_.depth_m > 0;
  if (!contact_.touching) return;
  contact_.direction_W = p.active_count == 1 ? hold_.walls[static_cast<std::size_t>(p.active[0])].normal
                                             : Vec3(push / contact_.depth_m);
  const double shaded_m = shaded.norm();
  contact_.normal_W = p.active_count == 1 ? contact_.holds[0].normal_W
                      : shaded_m > 0      ? Vec3(shaded / shaded_m)
                                          : contact_.direction_W;
  contact_.proxy_W = goal + push + around_.centre_W();
  contact_.point_W = p.active_count == 1 ? contact_.holds[0].point_W
                                         : Vec3(contact_.proxy_W - around_.radius_m() * contact_.direction_W);
}

/// The proxy has not come to rest: on its way it pushes as far as it still has to go.
void Proxy::report_underway(const Vec3& goal) noexcept {
  if (hold_.wall_count > 0) {
    contact_.hold_count = 0;
    for (int k = 0; k < hold_.wall_count; ++k) {
      contact_.holds[static_cast<std::size_t>(contact_.hold_count++)] =
          hold_at(hold_.walls[static_cast<std::size_t>(k)], hold_.share_m[static_cast<std::size_t>(k)]);
    }
  }
  const Vec3 push = place_ - goal;
  const double length_m = push.norm();
  contact_.depth_m = std::max(0.0, length_m - around_.skin_m());
  contact_.touching = contact_.depth_m > 0 && contact_.hold_count > 0;
  if (!contact_.touching) return;
  contact_.settled = false;
  contact_.direction_W = contact_.normal_W = push / length_m;
  contact_.proxy_W = place_ + around_.centre_W();
  contact_.point_W = contact_.proxy_W - around_.radius_m() * contact_.direction_W;
}

}  // namespace fingerpad
