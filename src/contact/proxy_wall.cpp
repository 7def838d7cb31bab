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
  int end;  ///< beyond the last of them
};
/// Fewer walls first, so that one that adds nothing is not named.
constexpr Choice choices[] = {{0, {}, 0},        {1, {0}, 1},       {1, {1}, 2},      {1, {2}, 3},
                              {1, {3}, 4},       {2, {0, 1}, 2},    {2, {0, 2}, 3},   {2, {1, 2}, 3},
                              {2, {0, 3}, 4},    {2, {1, 3}, 4},    {2, {2, 3}, 4},   {3, {0, 1, 2}, 3},
                              {3, {0, 1, 3}, 4}, {3, {0, 2, 3}, 4}, {3, {1, 2, 3}, 4}};

/// The multipliers that put the point onto every chosen wall; false where the walls do not fix them.
bool multipliers(const Vec3& goal, std::span<const ProxyWall> walls, const std::array<int, 3>& choice,
                 int count, std::array<double, 3>& share) noexcept {
  std::array<Vec3, 3> n;
  std::array<double, 3> missing{};
  for (int i = 0; i < count; ++i) {
    const ProxyWall& wall = walls[static_cast<std::size_t>(choice[i])];
    n[i] = wall.normal;
    missing[i] = wall.lack_m(goal);
  }
  if (count == 1) share[0] = missing[0];
  if (count == 2) {
    const double sine2 = n[0].cross(n[1]).squaredNorm();
    if (!(sine2 > ProxyLimits::parallel2)) return false;
    // The 2 x 2 system, written so that nearly equal normals cancel nothing but the missing lengths.
    const double cosine = n[0].dot(n[1]), turn = cosine < 0 ? -1 : 1;
    const double common = 1 / (1 + turn * cosine), apart = (missing[0] - turn * missing[1]) / sine2;
    share[0] = apart + turn * missing[1] * common;
    share[1] = turn * (missing[0] * common - apart);
  }
  if (count == 3) {
    const Vec3 c12 = n[1].cross(n[2]), c20 = n[2].cross(n[0]), c01 = n[0].cross(n[1]);
    const double volume = n[0].dot(c12);
    if (!(std::abs(volume) > ProxyLimits::flat_volume)) return false;
    const Vec3 shift = (missing[0] * c12 + missing[1] * c20 + missing[2] * c01) / volume;
    share = {shift.dot(c12) / volume, shift.dot(c20) / volume, shift.dot(c01) / volume};
  }
  return true;
}

}  // namespace

std::optional<Vec3> on_both_walls(const Vec3& near, const ProxyWall& a, const ProxyWall& b) noexcept {
  const std::array<ProxyWall, 2> walls{a, b};
  std::array<double, 3> share{};
  if (!multipliers(near, walls, {0, 1, 0}, 2, share)) return std::nullopt;
  return near + share[0] * a.normal + share[1] * b.normal;
}

ProxyProjection project_onto_walls(const Vec3& goal, std::span<const ProxyWall> walls,
                                   double tolerance_m) noexcept {
  ProxyProjection best;
  double best_distance_m = 0;
  const int count = static_cast<int>(std::min<std::size_t>(walls.size(), 4));
  for (const Choice& choice : choices) {
    if (best.found && choice.count > 0 && best.active_count == 0) return best;
    if (choice.end > count) continue;
    ProxyProjection p;
    p.active = choice.walls;
    p.active_count = choice.count;
    if (!multipliers(goal, walls, p.active, p.active_count, p.share_m)) continue;
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

ProxyProjection project_onto_every(const Vec3& goal, std::span<const ProxyWall> walls) noexcept {
  ProxyProjection p;
  p.active = {0, 1, 2};
  p.active_count = static_cast<int>(walls.size());
  if (!multipliers(goal, walls, p.active, p.active_count, p.share_m)) return p;
  p.z = goal;
  p.found = true;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    p.z += p.share_m[i] * walls[i].normal;
    p.found &= p.share_m[i] > 0;
  }
  return p;
}

}  // namespace fingerpad
