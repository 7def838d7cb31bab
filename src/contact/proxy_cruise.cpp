#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "contact/proxy.hpp"

// What the proxy may do without a look around: fly in a ball that is free, or slide along the walls that
// hold it.

namespace fingerpad {

bool Proxy::cruise(const Vec3& goal) noexcept {
  if (cruise_.kind == Cruise::Kind::none) return false;
  if (cruise_.kind == Cruise::Kind::slide)
    return cruise_.wall_count == 1 ? slide_on_one(goal) : slide_on_several(goal);
  if (!cruise_.has_room(goal) || !around_.is_clear_of_planes(goal, -1)) return false;
  place_ = goal;
  contact_.touching = false;
  return true;
}

bool Proxy::slide_on_one(const Vec3& goal) noexcept {
  const ProxyWall& wall = cruise_.walls[0];
  const double lack_m = wall.least_m - wall.normal.dot(goal);
  const Vec3 place = lack_m > 0 ? Vec3(goal + lack_m * wall.normal) : goal;
  if (!around_.is_clear_of_planes(place, wall.surface)) return false;
  Vec3 weights = Vec3::Zero();
  if (lack_m > 0 && wall.triangle >= 0) {
    weights = cruise_.facets[0].at(place);
    if (!(weights.minCoeff() > 0) || nearer_neighbour(goal) != nullptr) return false;
  }
  if (!cruise_.has_room(place) && !(lack_m > 0 && extend_slide(place))) return false;
  place_ = place;
  contact_.touching = false;
  if (!(lack_m > around_.skin_m() + std::ldexp(around_.tolerance_m(), -2))) return true;  // as report sees it
  hold_place_ = place;
  hold_.wall_count = 1;
  hold_.walls[0] = wall;
  hold_.walls[0].least_m = 0;
  ProxyProjection skinless;
  skinless.active_count = 1;
  skinless.share_m[0] = lack_m - around_.skin_m();
  contact_.holds[0] =
      wall.triangle < 0 ? hold_at(wall, skinless.share_m[0]) : hold_over(wall, skinless.share_m[0], weights);
  report_held(goal, skinless);
  return true;
}

/// In the valley or corner of two or three facets, as long as all of them hold.
bool Proxy::slide_on_several(const Vec3& goal) noexcept {
  std::array<ProxyWall, 3> walls = cruise_.walls;
  const std::span holding(walls.data(), static_cast<std::size_t>(cruise_.wall_count));
  for (ProxyWall& wall : holding) wall.least_m -= wall.normal.dot(place_);
  const ProxyProjection p = project_onto_every(goal - place_, holding);
  if (!p.found) return false;
  const Vec3 place = place_ + p.z;
  if (!cruise_.has_room(place) || !around_.is_clear_of_planes(place, -1)) return false;
  std::array<Vec3, 3> weights;
  for (std::size_t k = 0; k < holding.size(); ++k) {
    weights[k] = cruise_.facets[k].at(place);
    if (!(weights[k].minCoeff() > 0)) return false;
  }
  for (ProxyWall& wall : holding) wall.least_m -= around_.skin_m();
  const ProxyProjection skinless = project_onto_every(goal - place_, holding);
  if (!skinless.found) return false;
  for (ProxyWall& wall : holding) wall.least_m += around_.skin_m() - wall.normal.dot(p.z);
  hold_place_ = place_ = place;
  hold_.wall_count = cruise_.wall_count;
  hold_.walls = walls;
  hold_.share_m = p.share_m;
  for (std::size_t k = 0; k < holding.size(); ++k)
    contact_.holds[k] = hold_over(walls[k], skinless.share_m[k], weights[k]);
  report_held(goal, skinless);
  return true;
}

/// Whether a place lies in the room in front of the one wall that holds the proxy.
bool Proxy::is_in_room(const Vec3& place) const noexcept {
  if (cruise_.kind != Cruise::Kind::slide || cruise_.wall_count != 1) return false;
  const ProxyWall& wall = cruise_.walls[0];
  return cruise_.has_room(place) && wall.normal.dot(place) >= wall.least_m - around_.tolerance_m() &&
         around_.is_clear_of_planes(place, -1);
}

/// Goes from a place to another, both on a facet's wall, and slides on there, if the room in front of it
/// holds both; nothing is changed where it does not.
/// @param wall  seen from the proxy's place
bool Proxy::land(const ProxyWall& wall, const Vec3& from, const Vec3& to) noexcept {
  Cruise next;
  next.kind = Cruise::Kind::slide;
  next.wall_count = 1;
  next.walls[0] = wall;
  next.walls[0].least_m += wall.normal.dot(place_);
  next.facets[0] = weights_of(wall);
  if (!(next.facets[0].at(to).minCoeff() > 0)) return false;
  ProxyWall seen = next.walls[0];
  seen.least_m -= wall.normal.dot(around_.place());
  next.centre = around_.search_place();
  next.room_m = around_.room_in_front_of(std::span(&seen, 1), next.centre);
  if (!next.has_room(from) || !next.has_room(to) || !around_.is_clear_of_planes(to, -1)) return false;
  cruise_ = next;
  remember_neighbours();
  contact_.settled = true;
  place_ = hold_place_ = to;
  hold_ = {};
  hold_.wall_count = 1;
  hold_.walls[0] = wall;
  hold_.walls[0].least_m = 0;
  return true;
}

/// Makes a ball of free room in front of these walls (seen from the place last looked around from), if it
/// holds the proxy and a place where it shall go.
bool Proxy::make_room(std::span<const ProxyWall> walls, const Vec3& centre, const Vec3& place) noexcept {
  cruise_.centre = centre;
  cruise_.room_m = around_.room_in_front_of(walls, centre);
  return cruise_.has_room(place_) && cruise_.has_room(place);
}

/// At the end of its room the slide goes on where a new look, ahead, shows more.
bool Proxy::extend_slide(const Vec3& place) noexcept {
  const Vec3 way = place - place_;
  const double way_m = way.norm(), lead_m = lead * reach_m_;
  if (!(way_m < lead_m)) return false;
  if (around_.look_ahead(place_, way_m, reach_m_, lead_m / way_m * way)) suit_view();
  ProxyWall wall = cruise_.walls[0];
  wall.least_m -= wall.normal.dot(place_);
  const std::span walls(&wall, 1);
  return make_room(walls, around_.search_place(), place) || make_room(walls, place_, place);
}

bool Proxy::fly(const Vec3& goal) noexcept {
  constexpr int most_flights = 8;
  for (int k = 0; k < most_flights; ++k) {
    const double way_m = (goal - place_).norm();
    const double room_m = around_.room_m(place_, way_m + around_.extent_m());
    if (room_m >= way_m) {
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

/// Notes how far the walls that hold the proxy let it slide, where it is not sliding yet.
void Proxy::remember() noexcept {
  if (cruise_.kind == Cruise::Kind::slide) return;  // it landed there
  if (hold_.wall_count == 0 || hold_.stuck || around_.place() != hold_place_) return;
  const std::span walls(hold_.walls.data(), static_cast<std::size_t>(hold_.wall_count));
  for (const ProxyWall& wall : walls) {
    if (wall.triangle < 0 && walls.size() == 1) continue;
    if (wall.triangle < 0) return;
    const Part& part = around_.surfaces()[static_cast<std::size_t>(wall.surface)].tree->part();
    const auto foot = approach_triangle(part, wall.triangle, around_.in_part(wall.surface, place_));
    if (foot.at.feature != Feature::face) return;
  }
  cruise_.wall_count = hold_.wall_count;
  cruise_.walls = hold_.walls;
  for (ProxyWall& wall : cruise_.walls) wall.least_m += wall.normal.dot(hold_place_);
  if (!make_room(walls, around_.search_place(), place_) && !make_room(walls, hold_place_, place_)) {
    // Something stands close in front of the walls: no room to slide, but a neighbour may yet be nearer.
    cruise_.centre = place_;
    cruise_.room_m = 0;
  }
  cruise_.kind = Cruise::Kind::slide;
  for (std::size_t k = 0; k < walls.size(); ++k) cruise_.facets[k] = weights_of(walls[k]);
  if (cruise_.wall_count == 1) remember_neighbours();
}

Proxy::FacetWeights Proxy::weights_of(const ProxyWall& wall) const noexcept {
  FacetWeights result;
  if (wall.triangle < 0) return result;
  const ProxySurface& surface = around_.surfaces()[static_cast<std::size_t>(wall.surface)];
  const TriangleCorners f = corners_of(surface.tree->part(), wall.triangle);
  const Vec3 ab = f.b - f.a, ac = f.c - f.a;
  const double area = f.normal.dot(ab.cross(ac));
  result.corner = around_.from_part(wall.surface, f.a);
  result.weights.row(1) = surface.R_WP * (ac.cross(f.normal) / area);
  result.weights.row(2) = surface.R_WP * (f.normal.cross(ab) / area);
  result.weights.row(0) = -result.weights.row(1) - result.weights.row(2);
  return result;
}

void Proxy::remember_neighbours() noexcept {
  const ProxyWall& wall = cruise_.walls[0];
  if (wall.triangle < 0 || normals_->shade == nullptr) {
    fan_ = {};
    return;
  }
  const ProxySurface& surface = around_.surfaces()[static_cast<std::size_t>(wall.surface)];
  const Vec3 outer = surface.R_WP * surface.tree->part().facet_normals.col(wall.triangle);
  const double side = side_of(outer, wall.normal);
  if (fan_.surface == wall.surface && fan_.triangle == wall.triangle && fan_.side == side) return;
  fan_.surface = wall.surface;
  fan_.triangle = wall.triangle;
  fan_.side = side;
  fan_.count = 0;
  fan_.clear_m = -1;
  for (int corner = 0; corner < 3; ++corner) remember_fan(corner);
}

/// Goes around a corner of the wall's triangle, both ways as far as no crease is crossed.
void Proxy::remember_fan(int corner) noexcept {
  constexpr int most_turns = 64;
  const ProxyWall& wall = cruise_.walls[0];
  const ProxySurface& surface = around_.surfaces()[static_cast<std::size_t>(wall.surface)];
  const Part& part = surface.tree->part();
  const Vec3 centre_P = around_.in_part(wall.surface, Vec3::Zero());
  PartWall behind{surface.R_WP.transpose() * wall.normal, 0};
  behind.offset_m =
      wall.least_m - around_.clearance_m() + around_.tolerance_m() + behind.normal.dot(centre_P);
  const int vertex = part.welded(corner, wall.triangle);
  for (const int first_edge : {corner, (corner + 2) % 3}) {
    int t = wall.triangle, edge = first_edge;
    for (int turn = 0; turn < most_turns; ++turn) {
      const int next = part.neighbours(edge, t);
      if (next < 0 || (part.creases[static_cast<std::size_t>(t)] >> edge & 1) != 0) break;
      if (next == wall.triangle || fan_.count == static_cast<int>(fan_.neighbours.size())) return;
      int at = 0;
      while (at < 2 && part.welded(at, next) != vertex) ++at;
      // Of the two edges at the vertex, the one not come by.
      edge = part.neighbours(at, next) == t ? (at + 2) % 3 : at;
      t = next;
      NearTriangle near;
      near.corners = corners_of(part, t);
      const Vec3 normal_P = fan_.side * near.corners.normal;
      if (!(normal_P.dot(behind.normal) > 0) || !near.is_behind(behind)) continue;
      const auto k = static_cast<std::size_t>(fan_.count++);
      fan_.neighbours[k] = {surface.R_WP * normal_P,
                            around_.clearance_m() + normal_P.dot(near.corners.a - centre_P), wall.surface, t};
      fan_.per_slope[k] = 1 / (normal_P - behind.normal).norm();
    }
  }
}

/// The neighbour with the finger's foot on it that is nearest to the finger, if it is nearer than the wall.
const ProxyWall* Proxy::nearer_neighbour(const Vec3& goal) noexcept {
  if ((goal - fan_.clear_goal).squaredNorm() < fan_.clear_m * std::abs(fan_.clear_m)) return nullptr;
  const ProxyWall* nearest = nullptr;
  const double wall_depth_m =
      cruise_.walls[0].least_m - cruise_.walls[0].normal.dot(goal) - around_.tolerance_m();
  double least_depth_m = wall_depth_m, clear_m = std::numeric_limits<double>::infinity();
  for (int k = 0; k < fan_.count; ++k) {
    const ProxyWall& wall = fan_.neighbours[static_cast<std::size_t>(k)];
    const double depth_m = wall.least_m - wall.normal.dot(goal);
    // Both depths change evenly with the goal.
    clear_m = std::min(clear_m, (depth_m - wall_depth_m) * fan_.per_slope[static_cast<std::size_t>(k)]);
    if (!(depth_m < least_depth_m)) continue;
    const Part& part = around_.surfaces()[static_cast<std::size_t>(wall.surface)].tree->part();
    const auto foot = approach_triangle(part, wall.triangle, around_.in_part(wall.surface, goal));
    // The finger's foot on the plane lies on the facet where the facet is no farther than the plane.
    if (foot.distance_m > std::abs(depth_m - around_.clearance_m()) + around_.tolerance_m()) continue;
    least_depth_m = depth_m;
    nearest = &wall;
  }
  fan_.clear_goal = goal;
  fan_.clear_m = clear_m;
  return nearest;
}

}  // namespace fingerpad
