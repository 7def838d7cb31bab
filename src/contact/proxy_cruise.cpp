#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "contact/proxy.hpp"

// What the proxy may do without a look around: fly in a ball that is free, or slide along one wall.

namespace fingerpad {

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

}  // namespace fingerpad
