#include "touch/finger_room.hpp"

#include <algorithm>
#include <cmath>

#include "contact/triangle_tree.hpp"

namespace fingerpad {

NearestSurface nearest_surface(const World& world, const Vec3& p_W, Normals normals, double reach_m,
                               Looks& looks) noexcept {
  bool is_sure = true;
  const auto find = [&](std::size_t i) {
    BriefSearch brief{std::max(1L, looks.left())};
    const WorldPoint at = nearest_point(world.surfaces[i], p_W, normals, brief, reach_m);
    looks.spend(brief.spent);
    is_sure = is_sure && !brief.broken_off;
    return at;
  };
  NearestSurface nearest = nearest_of(world, reach_m, find, [&](std::size_t i) {
    return i < world.verdicts.size() && world.verdicts[i].closed;
  });
  nearest.is_sure = is_sure;
  return nearest;
}

/// Each time by as much as is free, until hardly anything is.
Vec3 stopped_on_line(const World& world, const Vec3& spot_W, const Vec3& up_W, double from_m, double radius_m,
                     double hardly_m, Looks& looks) noexcept {
  constexpr int most_searches = 40;
  double up_m = std::max(0.0, from_m);
  for (int i = 0; i < most_searches && up_m > 0; ++i) {
    const Vec3 place_W = spot_W + up_m * up_W;
    const NearestSurface nearest = nearest_surface(world, place_W, Normals::facet, radius_m + up_m, looks);
    const double free_m = nearest.clear_m - radius_m;
    if (!nearest.is_sure || free_m < hardly_m) break;
    up_m = std::max(0.0, up_m - free_m);
  }
  return spot_W + up_m * up_W;
}

namespace {

/// What stops a ball on its line.
struct Stop {
  Vec3 place_W;
  NearestSurface by;
  bool is_stopped;
};

Stop stop_on_line(const World& world, const Vec3& to_W, const Vec3& up_W, double from_m, double radius_m,
                  Looks& looks) noexcept {
  constexpr double hardly_share = 0.01, inside_share = 0.5;
  const Vec3 place_W = stopped_on_line(world, to_W, up_W, from_m, radius_m, hardly_share * radius_m, looks);
  const NearestSurface by =
      nearest_surface(world, place_W, Normals::facet, (1 + 2 * hardly_share) * radius_m, looks);
  return {place_W, by, by.is_sure && by.surface >= 0 && by.clear_m > inside_share * radius_m};
}

}  // namespace

std::optional<RimPlace> rim_on_line(const World& world, const Vec3& from_W, const Vec3& to_W, double radius_m,
                                    Looks& looks) noexcept {
  const Vec3 line_W = from_W - to_W;
  const double length_m = line_W.norm();
  if (!(radius_m > 0) || !(length_m > 0)) return std::nullopt;
  const Vec3 up_W = line_W / length_m;
  const double from_m = length_m + 2 * radius_m;
  const Stop stop = stop_on_line(world, to_W, up_W, from_m, radius_m, looks);
  if (!stop.is_stopped) return std::nullopt;
  const Vec3 out_W = stop.place_W - stop.by.at.point_W, aside_W = out_W - out_W.dot(up_W) * up_W;
  const double aside_m = aside_W.norm();
  const Vec3 gives_way_W = aside_m > 0 ? Vec3(aside_W * (radius_m / aside_m)) : Vec3::Zero();
  if (!stop_on_line(world, to_W + gives_way_W, up_W, from_m, radius_m, looks).is_stopped) return std::nullopt;
  return RimPlace{stop.place_W, stop.by.surface};
}

namespace {

/// Whether a ball gets from a place to another, straight on where it is free and else along what is in its
/// way, ever nearer; or whether the looks do not tell.
/// @param there_m  as near as this it is there
bool may_slide_to(const World& world, Vec3 from_W, const Vec3& to_W, double there_m, double radius_m,
                  Looks& looks) noexcept {
  constexpr int most_pushes = 6;
  constexpr double hardly_share = 0.02, step_share = 0.3;
  const double hardly_m = hardly_share * radius_m, touching_m = radius_m + hardly_m;
  while (looks.left() > 0) {
    Vec3 way_W = to_W - from_W;
    const double left_m = way_W.norm();
    if (left_m <= there_m) return true;
    const NearestSurface nearest = nearest_surface(world, from_W, Normals::facet, radius_m + left_m, looks);
    if (!nearest.is_sure) return true;  // nothing is known to be in its way
    const double free_m = nearest.clear_m - radius_m;
    if (free_m >= left_m) return true;
    const Vec3 out_W = (from_W - nearest.at.point_W).normalized();
    if (free_m < 2 * hardly_m) way_W -= std::min(0.0, way_W.dot(out_W)) * out_W;
    const double along_m = way_W.norm();
    if (!(along_m > 0)) return false;
    Vec3 next_W = from_W + std::min(1.0, std::max(free_m, step_share * radius_m) / along_m) * way_W;
    bool is_clear = false;
    for (int k = 0; k < most_pushes; ++k) {
      const NearestSurface by = nearest_surface(world, next_W, Normals::facet, 2 * radius_m, looks);
      if (!by.is_sure) return true;
      is_clear = by.clear_m >= radius_m - hardly_m;
      if (is_clear) break;
      if (by.clear_m <= 0) return false;
      next_W = by.at.point_W + touching_m * (next_W - by.at.point_W).normalized();
    }
    if (!is_clear || !((to_W - next_W).norm() < left_m - hardly_m)) return false;
    from_W = next_W;
  }
  return true;
}

}  // namespace

std::optional<RimPlace> rim_before(const World& world, const Vec3& from_W, const Vec3& spot_W,
                                   const Vec3& normal_W, double radius_m, Looks& looks) noexcept {
  // Less than this over the spot is a part of its own surface; in coarse facets it goes so far in.
  constexpr double over_share = 0.5, room_share = 0.75;
  // How near to the spot the ball is there; where the spot has no room itself, in a corner, that is not so
  // near.
  constexpr double there_share = 0.5, corner_share = 2.5;
  const Vec3 line_W = from_W - spot_W;
  const double length_m = line_W.norm();
  if (!(radius_m > 0) || !(length_m > 0)) return std::nullopt;
  const Vec3 up_W = line_W / length_m, place_W = spot_W + radius_m * normal_W;
  const bool has_room =
      nearest_surface(world, place_W, Normals::facet, radius_m, looks).clear_m >= room_share * radius_m;
  const Stop stop = stop_on_line(world, spot_W, up_W, length_m + 2 * radius_m, radius_m, looks);
  if (!stop.is_stopped || (stop.by.at.point_W - spot_W).dot(normal_W) < over_share * radius_m)
    return std::nullopt;
  const double there_m = (has_room ? there_share : corner_share) * radius_m;
  if (may_slide_to(world, stop.place_W, place_W, there_m, radius_m, looks)) return std::nullopt;
  return RimPlace{stop.place_W, stop.by.surface};
}

}  // namespace fingerpad
