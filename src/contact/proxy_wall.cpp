#include "contact/proxy_wall.hpp"

#include <algorithm>
#include <cmath>

#include "contact/proxy_limits.hpp"

namespace fingerpad {
namespace {

/// At most three of at most four walls.
struct Choice {
  int count;
  std::array<int, 3> walls;
  int end;  ///< beyond the last of them
};
/// Fewer walls first, so that one that adds nothing is not named.
constexpr Choice choices[] = {{0, {}, 0},        {1, {0}, 1},       {1, {1}, 2},      {1, {2}, 3},
                              {1, {3}, 4},       {2, {0, 1}, 2},    {2, {0, 2}, 3},   {2, {1, 2}, 3},
                              {2, {0, 3}, 4},    {2, {1, 3}, 4},    {2, {2, 3}, 4},   {3, {0, 1, 2}, 3},
                              {3, {0, 1, 3}, 4}, {3, {0, 2, 3}, 4}, {3, {1, 2, 3}, 4}};

/// The multipliers that put a point onto every chosen wall; false where the walls do not fix them.
/// @param lack_m  how far the point is behind each of the walls
bool multipliers(std::span<const double> lack_m, std::span<const ProxyWall> walls,
                 const std::array<int, 3>& choice, int count, std::array<double, 3>& share_m) noexcept {
  std::array<Vec3, 3> normals;
  std::array<double, 3> chosen_m{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    normals[i] = walls[static_cast<std::size_t>(choice[i])].normal;
    chosen_m[i] = lack_m[static_cast<std::size_t>(choice[i])];
  }
  share_m = chosen_m;
  if (count < 2) return true;
  const WallsTogether together(normals, count);
  if (!together.fix_shares()) return false;
  share_m = together.shares_m(chosen_m);
  return true;
}

}  // namespace

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
  const int count = static_cast<int>(std::min<std::size_t>(walls.size(), 4));
  std::array<double, 4> lack_m{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) lack_m[i] = walls[i].lack_m(goal);
  for (const Choice& choice : choices) {
    if (best.found && choice.count > 0 && best.active_count == 0) return best;
    if (choice.end > count) continue;
    ProxyProjection p;
    p.active = choice.walls;
    p.active_count = choice.count;
    if (!multipliers(lack_m, walls, p.active, p.active_count, p.share_m)) continue;
    p.z = goal;
    for (int i = 0; i < p.active_count; ++i)
      p.z += p.share_m[i] * walls[static_cast<std::size_t>(p.active[i])].normal;
    const bool free = std::all_of(walls.begin(), walls.begin() + count, [&](const ProxyWall& wall) {
      return wall.normal.dot(p.z) >= wall.least_m - tolerance_m;
    });
    const double distance_m = (p.z - goal).norm();
    if (!free || (best.found && !(distance_m < best_distance_m * (1 - ProxyLimits::reach_rounding))))
      continue;
    p.found = true;
    for (double& share : p.share_m) share = std::max(0.0, share);
    best = p;
    best_distance_m = distance_m;
  }
  return best;
}

}  // namespace fingerpad
