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
    weights = cruise_.weights * (place - cruise_.corner) + Vec3::UnitX();
    if (!(weights.minCoeff() > 0) || nearer_neighbour(goal) != nullptr) return false;
  }
  if (!cruise_.has_room(place) && !(lack_m > 0 && extend_slide(place))) return false;
  place_ = place;
  contact_.touching = false;
  if (!(lack_m > around_.skin_m())) return true;
  hold_place_ = place;
  hold_.wall_count = 1;
  hold_.walls[0] = wall;
  hold_.walls[0].least_m = 0;
  if (wall.triangle < 0) {
    report(goal);
  } else {
    report_slide(goal, lack_m - around_.skin_m(), weights);
  }
  return true;
}

/// In the valley or corner of two or three walls, as long as all of them hold.
bool Proxy::slide_on_several(const Vec3& goal) noexcept {
  ProxyStep step;
  step.wall_count = cruise_.wall_count;
  step.walls = cruise_.walls;
  const std::span walls(step.walls.data(), static_cast<std::size_t>(step.wall_count));
  for (ProxyWall& wall : walls) wall.least_m -= wall.normal.dot(place_);
  const double rounding_m = 4e-16 * (goal - place_).cwiseAbs().maxCoeff();
  const ProxyProjection p =
      project_onto_walls(goal - place_, walls, std::ldexp(around_.tolerance_m(), -2) + rounding_m);
  if (!p.found || p.active_count != step.wall_count) return false;
  const Vec3 old_place = place_, place = place_ + p.z;
  if (!cruise_.has_room(place) || !around_.is_clear_of_planes(place, -1)) return false;
  for (ProxyWall& wall : walls) wall.least_m -= wall.normal.dot(p.z);
  place_ = place;
  if (!is_at_rest(step)) {
    place_ = old_place;
    return false;
  }
  step.share_m = p.share_m;
  hold_place_ = place;
  hold_ = step;
  report(goal);
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

/// Notes how far the walls that hold the proxy let it slide.
void Proxy::remember() noexcept {
  cruise_.kind = Cruise::Kind::none;
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
  if (cruise_.wall_count > 1) return;
  remember_weights();
  remember_neighbours();
}

/// How the weights of the corners of the wall's triangle change with the place; 1, 0, 0 at its first corner.
void Proxy::remember_weights() noexcept {
  const ProxyWall& wall = cruise_.walls[0];
  if (wall.triangle < 0) return;
  const ProxySurface& surface = around_.surfaces()[static_cast<std::size_t>(wall.surface)];
  const TriangleCorners f = corners_of(surface.tree->part(), wall.triangle);
  const Vec3 ab = f.b - f.a, ac = f.c - f.a;
  const double area = f.normal.dot(ab.cross(ac));
  cruise_.corner = around_.from_part(wall.surface, f.a);
  cruise_.weights.row(1) = surface.R_WP * (ac.cross(f.normal) / area);
  cruise_.weights.row(2) = surface.R_WP * (f.normal.cross(ab) / area);
  cruise_.weights.row(0) = -cruise_.weights.row(1) - cruise_.weights.row(2);
}

void Proxy::remember_neighbours() noexcept {
  const ProxyWall& wall = cruise_.walls[0];
  if (wall.triangle < 0 || normals_ == Normals::facet) {
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
  const double behind_m = wall.least_m - around_.clearance_m() + around_.tolerance_m() -
                          wall.normal.dot(around_.from_part(wall.surface, Vec3::Zero()));
  for (int corner = 0; corner < 3; ++corner) remember_fan(corner, behind_m);
}

/// Goes around a corner of the wall's triangle, both ways as far as no crease is crossed.
/// @param behind_m  the wall's plane, seen from the part's centre
void Proxy::remember_fan(int corner, double behind_m) noexcept {
  constexpr int most_turns = 64;
  const ProxyWall& wall = cruise_.walls[0];
  const ProxySurface& surface = around_.surfaces()[static_cast<std::size_t>(wall.surface)];
  const Part& part = surface.tree->part();
  const PartWall behind{surface.R_WP.transpose() * wall.normal, behind_m};
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
      if (fan_.side * near.corners.normal.dot(behind.normal) > 0 && near.is_behind(behind))
        fan_.neighbours[static_cast<std::size_t>(fan_.count++)] =
            around_.facet_wall(wall.surface, t, fan_.side, Vec3::Zero());
    }
  }
}

/// The neighbour with the finger's foot on it that is nearest to the finger, if it is nearer than the wall.
const ProxyWall* Proxy::nearer_neighbour(const Vec3& goal) const noexcept {
  const ProxyWall* nearest = nullptr;
  double least_depth_m = cruise_.walls[0].least_m - cruise_.walls[0].normal.dot(goal) - around_.tolerance_m();
  for (int k = 0; k < fan_.count; ++k) {
    const ProxyWall& wall = fan_.neighbours[static_cast<std::size_t>(k)];
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

}  // namespace fingerpad
