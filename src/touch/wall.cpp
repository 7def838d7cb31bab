#include "touch/wall.hpp"

#include <utility>

namespace fingerpad {
namespace {

constexpr double cos_one_wall = 0.8660254037844387;  // 30 degrees, as creases are told by default

/// v turned by the smallest rotation that takes `from` onto `to` (both unit): two reflections.
Vec3 turned(const Vec3& v, const Vec3& from, const Vec3& to) noexcept {
  const double cosine = from.dot(to);
  if (cosine < -0.999) return v;
  const Vec3 sum = from + to;
  return v - sum * (sum.dot(v) / (1 + cosine)) + to * (2 * from.dot(v));
}

void add(Walls& walls, const ContactHold& hold, const Vec3& push_m) noexcept {
  const Vec3 normal_W = push_m.normalized();
  for (int i = 0; i < walls.count; ++i) {
    Wall& wall = walls.walls[static_cast<std::size_t>(i)];
    if (wall.surface != hold.surface || wall.normal_W.dot(normal_W) < cos_one_wall) continue;
    wall.share_m += push_m.norm();
    wall.push_m += push_m;
    wall.normal_W = wall.push_m.normalized();
    return;
  }
  walls.walls[static_cast<std::size_t>(walls.count++)] = {
      hold.surface, hold.triangle, hold.point_W, normal_W, push_m.norm(), push_m, 0};
}

void be_one_wall(const Contact& contact, Walls& walls) noexcept {
  const ContactHold& greatest = contact.holds[0];
  walls.count = 1;
  walls.walls[0] = {greatest.surface,
                    greatest.triangle,
                    contact.point_W,
                    contact.normal_W,
                    contact.depth_m,
                    contact.depth_m * contact.normal_W,
                    0};
}

/// Greatest first; std::stable_sort would allocate.
void sort_by_share(Walls& walls) noexcept {
  for (Wall* wall = walls.begin(); wall != walls.end(); ++wall) {
    for (Wall* at = wall; at != walls.begin() && at->share_m > at[-1].share_m; --at) std::swap(*at, at[-1]);
  }
}

}  // namespace

void find_walls(const Contact& contact, Walls& walls) noexcept {
  const ContactHold& greatest = contact.holds[0];
  if (contact.hold_count == 1) return be_one_wall(contact, walls);
  Vec3 sum_m = Vec3::Zero();
  const auto holds = static_cast<std::size_t>(contact.hold_count);
  for (std::size_t i = 0; i < holds; ++i) sum_m += contact.holds[i].share_m * contact.holds[i].normal_W;
  const double sum_length_m = sum_m.norm();
  if (!(sum_length_m > 1e-6 * greatest.share_m)) return be_one_wall(contact, walls);
  walls.count = 0;
  const Vec3 way_W = sum_m / sum_length_m;
  const double scale = contact.depth_m / sum_length_m;
  for (std::size_t i = 0; i < holds; ++i) {
    const ContactHold& hold = contact.holds[i];
    if (!(hold.share_m > 0)) continue;
    add(walls, hold, scale * hold.share_m * turned(hold.normal_W, way_W, contact.normal_W));
  }
  sort_by_share(walls);
}

}  // namespace fingerpad
