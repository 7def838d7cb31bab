#include "contact/proxy_wall.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "contact/proxy_limits.hpp"

namespace fingerpad {
namespace {

/// At most three of at most four walls.
struct Choice {
  int count;
  std::array<int, 3> walls;
  std::size_t end;  ///< beyond the last of them
};
/// Fewer walls first, so that one that adds nothing is not named.
constexpr Choice choices[] = {{0, {}, 0},        {1, {0}, 1},       {1, {1}, 2},      {1, {2}, 3},
                              {1, {3}, 4},       {2, {0, 1}, 2},    {2, {0, 2}, 3},   {2, {1, 2}, 3},
                              {2, {0, 3}, 4},    {2, {1, 3}, 4},    {2, {2, 3}, 4},   {3, {0, 1, 2}, 3},
                              {3, {0, 1, 3}, 4}, {3, {0, 2, 3}, 4}, {3, {1, 2, 3}, 4}};

/// The multipliers that put a point onto every chosen wall; nothing where the walls do not fix them.
/// @param lack_m  how far the point is behind each of the walls
std::optional<std::array<double, 3>> shares_m(const Choice& choice, std::span<const ProxyWall> walls,
                                              const std::array<double, 4>& lack_m) noexcept {
  std::array<Vec3, 3> normals;
  std::array<double, 3> chosen_m{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(choice.count); ++i) {
    normals[i] = walls[static_cast<std::size_t>(choice.walls[i])].normal;
    chosen_m[i] = lack_m[static_cast<std::size_t>(choice.walls[i])];
  }
  const WallsTogether together(normals, choice.count);
  if (!together.fix_shares()) return std::nullopt;
  return together.shares_m(chosen_m);
}

}  // namespace

WallsTogether::WallsTogether(const std::array<Vec3, 3>& normals, int count) noexcept : count_(count) {
  const Vec3 &a = normals[0], &b = normals[1], &c = normals[2];
  if (count == 2) {
    const double sine2 = a.cross(b).squaredNorm(), cosine = a.dot(b);
    fix_shares_ = sine2 > ProxyLimits::parallel2;
    turn_ = cosine < 0 ? -1 : 1;
    common_ = 1 / (1 + turn_ * cosine);
    per_sine2_ = 1 / sine2;
  }
  if (count == 3) {
    const Vec3 bc = b.cross(c);
    const double volume = a.dot(bc);
    fix_shares_ = std::abs(volume) > ProxyLimits::flat_volume;
    dual_ = {bc / volume, c.cross(a) / volume, a.cross(b) / volume};
  }
}

std::optional<Vec3> on_both_walls(const Vec3& near, const ProxyWall& a, const ProxyWall& b) noexcept {
  const WallsTogether together({a.normal, b.normal, Vec3::Zero()}, 2);
  if (!together.fix_shares()) return std::nullopt;
  const std::array<double, 3> share_m = together.shares_m({a.lack_m(near), b.lack_m(near), 0});
  return near + share_m[0] * a.normal + share_m[1] * b.normal;
}

ProxyProjection project_onto_walls(const Vec3& goal, std::span<const ProxyWall> walls,
                                   double tolerance_m) noexcept {
  ProxyProjection best;
  double best_distance_m = 0;
  std::array<double, 4> lack_m{};
  for (std::size_t i = 0; i < walls.size(); ++i) lack_m[i] = walls[i].lack_m(goal);
  for (const Choice& choice : choices) {
    if (choice.end > walls.size()) continue;
    const auto share_m = shares_m(choice, walls, lack_m);
    if (!share_m) continue;
    Vec3 z = goal;
    for (std::size_t i = 0; i < static_cast<std::size_t>(choice.count); ++i)
      z += (*share_m)[i] * walls[static_cast<std::size_t>(choice.walls[i])].normal;
    const bool is_free = std::all_of(walls.begin(), walls.end(), [&](const ProxyWall& wall) {
      return wall.normal.dot(z) >= wall.least_m - tolerance_m;
    });
    if (!is_free) continue;
    const double distance_m = (z - goal).norm();
    if (best.found && !(distance_m < best_distance_m * (1 - ProxyLimits::reach_rounding))) continue;
    best.found = true;
    best.z = z;
    best.wall_count = choice.count;
    for (std::size_t i = 0; i < best.held_by().size(); ++i) {
      best.walls[i] = walls[static_cast<std::size_t>(choice.walls[i])];
      best.share_m[i] = std::max(0.0, (*share_m)[i]);
    }
    best_distance_m = distance_m;
    if (choice.count == 0) break;  // nothing is nearer to the goal than itself
  }
  return best;
}

std::optional<Vec3> HoldingWalls::project(const Vec3& goal, const std::optional<ProxyWall>& more,
                                          double tolerance_m) noexcept {
  std::array<ProxyWall, 4> all;
  std::size_t count = held_by().size();
  std::copy(held_by().begin(), held_by().end(), all.begin());
  if (more) all[count++] = *more;
  const ProxyProjection p = project_onto_walls(goal, std::span(all.data(), count), tolerance_m);
  if (!p.found) return std::nullopt;
  *this = p;
  return p.z;
}

}  // namespace fingerpad
