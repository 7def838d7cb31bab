#include "contact/proxy_memory.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "contact/proxy_limits.hpp"
#include "contact/proxy_report.hpp"

namespace fingerpad {

using Limits = ProxyMemoryLimits;

void ProxyMemory::let_go() noexcept {
  ProxyViews::let_go();
  room_.kind = Room::Kind::none;
}

void ProxyMemory::forget() noexcept {
  ProxyViews::forget();
  let_go();
}

bool ProxyMemory::carry(ProxyState& state) noexcept {
  view_.note_finger(state.finger_m);
  return slide(state) || (!state.contact.touching() && fly(state));
}

/// Flies or slides on in the room that is known.
bool ProxyMemory::slide(ProxyState& state) noexcept {
  if (room_.kind == Room::Kind::none) return false;
  if (room_.kind == Room::Kind::slide)
    return room_.wall_count == 1 ? slide_on_one(state) : slide_on_several(state);
  if (!room_.holds(state.goal_O) || !is_clear_of_planes(state.goal_O, -1)) return false;
  state.place_O = state.goal_O;
  state.contact.settled = true;
  state.contact.hold_count = 0;
  return true;
}

/// Flies from one free ball to the next. False near a surface, where the proxy then is.
bool ProxyMemory::fly(ProxyState& state) noexcept {
  const Vec3& goal_O = state.goal_O;
  for (int k = 0; k < Limits::most_flights; ++k) {
    const double way_m = (goal_O - state.place_O).norm();
    const double free_m =
        room_m(state.place_O, std::min(way_m, view_.next_reach_m()), way_m + world_.extent_m());
    if (free_m >= way_m) {
      room_.kind = Room::Kind::flight;
      room_.centre_O = state.place_O;
      room_.radius_m = free_m * (1 - Limits::rounding);
      state.place_O = goal_O;
      state.contact.settled = true;
      return true;
    }
    if (!(free_m > view_.next_reach_m())) return false;
    let_go();
    state.place_O += (goal_O - state.place_O) * (free_m / way_m * Limits::flight_share);
  }
  return false;
}

bool ProxyMemory::slide_on_one(ProxyState& state) noexcept {
  const Vec3& goal_O = state.goal_O;
  const ProxyWall& wall_O = room_.walls_O[0];
  const double lack_m = wall_O.lack_m(goal_O);
  const Vec3 place_O = lack_m > 0 ? Vec3(goal_O + lack_m * wall_O.normal) : goal_O;
  if (!is_clear_of_planes(place_O, wall_O.surface)) return false;
  Vec3 weights = Vec3::Zero();
  if (lack_m > 0 && wall_O.triangle >= 0) {
    weights = room_.facets[0].at(place_O);
    if (!(weights.minCoeff() > 0) || fan_.nearest_to(world_, wall_O, goal_O) != nullptr) return false;
  }
  if (!room_.holds(place_O) && !(lack_m > 0 && extend_slide(state.place_O, place_O))) return false;
  state.place_O = place_O;
  state.contact.hold_count = 0;
  const HoldingWalls skinless = held_by_one(world_, wall_O, lack_m - world_.skin_m());
  if (skinless.wall_count == 0) return true;
  state.hold.from_O = place_O;
  state.hold.wall_count = 1;
  state.hold.walls[0] = wall_O;
  state.hold.walls[0].least_m = 0;
  state.contact.holds[0] = wall_O.triangle < 0 ? hold_at(world_, wall_O, skinless.share_m[0], place_O)
                                               : hold_over(wall_O, skinless.share_m[0], place_O, weights);
  report_held(world_, skinless, state);
  return true;
}

/// In the valley or corner of two or three facets, as long as all of them hold.
bool ProxyMemory::slide_on_several(ProxyState& state) noexcept {
  const std::span walls_O(room_.walls_O.data(), static_cast<std::size_t>(room_.wall_count));
  const ProxyProjection p = room_.every.project(state.goal_O, walls_O);
  if (!p.found || !room_.holds(p.z) || !is_clear_of_planes(p.z, -1)) return false;
  std::array<Vec3, 3> weights;
  for (std::size_t k = 0; k < walls_O.size(); ++k) {
    weights[k] = room_.facets[k].at(p.z);
    if (!(weights[k].minCoeff() > 0)) return false;
  }
  // Without its skin the ball's walls stand nearer by that.
  const ProxyProjection skinless = room_.every.with_walls_nearer(p, world_.skin_m());
  if (!skinless.found) return false;
  state.hold.from_O = state.place_O = p.z;
  state.hold.wall_count = room_.wall_count;
  state.hold.share_m = p.share_m;
  for (std::size_t k = 0; k < walls_O.size(); ++k) {
    state.hold.walls[k] = walls_O[k].seen_from(p.z);
    state.contact.holds[k] = hold_over(walls_O[k], skinless.share_m[k], p.z, weights[k]);
  }
  report_held(world_, skinless, state);
  return true;
}

/// At the end of its room the slide goes on where a new look, ahead, shows more.
bool ProxyMemory::extend_slide(const Vec3& from_O, const Vec3& to_O) noexcept {
  const Vec3 way = to_O - from_O;
  const double way_m = way.norm(), lead_m = Limits::lead * view_.next_reach_m();
  if (!(way_m < lead_m) || view_.is_left()) return false;
  view_.look_ahead(from_O, way_m, lead_m / way_m * way);
  const ProxyWall wall = room_.walls_O[0].seen_from(from_O);
  const std::span walls(&wall, 1);
  return make_room(walls, view_.search_place_O(), from_O, to_O) || make_room(walls, from_O, from_O, to_O);
}

/// A ball about a place in view and in front of these walls (seen from the place last looked around from), if
/// it holds the proxy and a place where it shall go.
bool ProxyMemory::make_room(std::span<const ProxyWall> walls, const Vec3& centre_O, const Vec3& from_O,
                            const Vec3& to_O) noexcept {
  room_.centre_O = centre_O;
  room_.radius_m = view_.room_in_front_of(walls, centre_O);
  return room_.holds(from_O) && room_.holds(to_O);
}

std::optional<ProxyStep> ProxyMemory::step_over(const WayOver& way) noexcept {
  if (!is_way_free(way)) return no_way();
  if (!land(way)) return look_and_step_from_edge(way);
  ProxyStep there;
  there.from_O = way.place_O + way.far;
  there.goal_O = way.goal_O;
  there.wall_count = 1;
  there.walls[0] = way.walls.there;
  there.walls[0].least_m = 0;
  there.end = StepEnd::at_rest;
  return there;
}

/// Besides what the view shows: whether the way ends in the room in front of the one wall that holds the
/// proxy.
bool ProxyMemory::is_way_free(const WayOver& way) noexcept {
  if (is_outrun(way.place_O, way.far.norm())) return false;
  view_.look_over_edge(way);
  const Vec3 edge_O = way.place_O + way.edge;
  const bool is_in_room =
      room_.is_slide_on_one() && room_.holds(edge_O) &&
      room_.walls_O[0].normal.dot(edge_O) >= room_.walls_O[0].least_m - world_.tolerance_m() &&
      is_clear_of_planes(edge_O, -1);
  return is_in_room || is_seen_free(way);
}

/// Slides on from the way's far end, where the second wall alone holds the proxy, if the room in front of
/// that wall holds the edge too; else nothing is changed.
bool ProxyMemory::land(const WayOver& way) noexcept {
  if (!(way.depth_m > 0 && way.depth_m < way.must_beat_m)) return false;
  const ProxyWall& there = way.walls.there;
  const Vec3 edge_O = way.place_O + way.edge, to_O = way.place_O + way.far;
  const FacetWeights facet(world_, there);
  if (!(facet.at(to_O).minCoeff() > 0)) return false;
  const ProxyWall wall_O = there.seen_from(-way.place_O), seen = wall_O.seen_from(at_.place_O);
  Ball room{view_.search_place_O(), 0};
  room.radius_m = view_.room_in_front_of(std::span(&seen, 1), room.centre_O);
  if (!room.holds(edge_O) || !room.holds(to_O) || !is_clear_of_planes(to_O, -1)) return false;
  static_cast<Ball&>(room_) = room;
  room_.kind = Room::Kind::slide;
  room_.wall_count = 1;
  room_.walls_O[0] = wall_O;
  room_.facets[0] = facet;
  view_.note_blockers(std::span(&there, 1));
  fan_.remember(world_, wall_O, looks_);
  return true;
}

/// Notes how far the walls that hold the proxy let it slide, where it is not sliding yet.
void ProxyMemory::note_rest(const ProxyState& state) noexcept {
  const ProxyStep& hold = state.hold;
  if (room_.kind == Room::Kind::slide || view_.is_left())
    return;  // it landed there; what is in view is not here
  if (hold.wall_count == 0 || hold.end == StepEnd::stuck || at_.place_O != hold.from_O) return;
  const auto walls = hold.held_by();
  for (const ProxyWall& wall : walls) {
    if (wall.triangle < 0 && walls.size() == 1) continue;
    if (wall.triangle < 0) return;
    if (world_.approach(wall.surface, wall.triangle, state.place_O).at.feature != Feature::face) return;
  }
  room_.wall_count = hold.wall_count;
  for (std::size_t k = 0; k < walls.size(); ++k) {
    room_.walls_O[k] = walls[k].seen_from(-hold.from_O);
    room_.facets[k] = FacetWeights(world_, walls[k]);
  }
  room_.every = EveryWall(walls);
  if (!make_room(walls, view_.search_place_O(), state.place_O, state.place_O) &&
      !make_room(walls, hold.from_O, state.place_O, state.place_O)) {
    // Something stands close in front of the walls: no room to slide, but a neighbour may yet be nearer.
    room_.centre_O = state.place_O;
    room_.radius_m = 0;
  }
  room_.kind = Room::Kind::slide;
  if (room_.wall_count == 1) fan_.remember(world_, room_.walls_O[0], looks_);
}

/// What holds the proxy where it stands over a facet, with these weights of its corners.
ContactHold ProxyMemory::hold_over(const ProxyWall& wall, double share_m, const Vec3& place_O,
                                   const Vec3& weights) const noexcept {
  TrianglePoint at;
  at.barycentric = weights;
  return hold_on_facet(world_, wall, share_m, place_O - world_.clearance_m() * wall.normal, at);
}

std::optional<WallPair> ProxyMemory::nearer_neighbour(const ProxyState& state) noexcept {
  if (!world_.is_shaded() || !room_.is_slide_on_one() || room_.walls_O[0].triangle < 0) return std::nullopt;
  const ProxyWall& wall_O = room_.walls_O[0];
  const ProxyWall* nearest_O = fan_.nearest_to(world_, wall_O, state.goal_O);
  if (nearest_O == nullptr) return std::nullopt;
  return WallPair{wall_O.seen_from(state.place_O), nearest_O->seen_from(state.place_O)};
}

}  // namespace fingerpad
