#include "contact/every_wall.hpp"

#include <algorithm>

namespace fingerpad {

EveryWall::EveryWall(std::span<const ProxyWall> walls) noexcept {
  std::array<Vec3, 3> normals;
  for (std::size_t i = 0; i < walls.size(); ++i) normals[i] = walls[i].normal;
  together_ = {normals, static_cast<int>(walls.size())};
  if (together_.fix_shares()) per_metre_nearer_ = together_.shares_m({1, 1, 1});
}

ProxyProjection EveryWall::project(const Vec3& goal, std::span<const ProxyWall> walls) const noexcept {
  ProxyProjection p;
  p.wall_count = static_cast<int>(walls.size());
  std::copy(walls.begin(), walls.end(), p.walls.begin());
  if (!together_.fix_shares()) return p;
  std::array<double, 3> lack_m{};
  for (std::size_t i = 0; i < walls.size(); ++i) lack_m[i] = walls[i].lack_m(goal);
  p.share_m = together_.shares_m(lack_m);
  p.z = goal;
  p.found = true;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    p.z += p.share_m[i] * walls[i].normal;
    p.found &= p.share_m[i] > 0;
  }
  return p;
}

ProxyProjection EveryWall::with_walls_nearer(ProxyProjection onto_every, double nearer_m) const noexcept {
  onto_every.found = true;
  for (std::size_t i = 0; i < static_cast<std::size_t>(onto_every.wall_count); ++i) {
    onto_every.share_m[i] -= nearer_m * per_metre_nearer_[i];
    onto_every.found &= onto_every.share_m[i] > 0;
  }
  return onto_every;
}

}  // namespace fingerpad
