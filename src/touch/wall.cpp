#include "touch/wall.hpp"

#include <utility>

namespace fingerpad {
namespace {

constexpr double cos_one_wall = 0.8660254037844387;  // 30 degrees, as creases are told by default

/// The smallest rotation that takes `from` onto `to` (both unit): two reflections.
/// @pre they are not opposite: no rotation is the smallest then
class Turn {
 public:
  Turn(const Vec3& from, const Vec3& to) noexcept
      : from_(from), to_(to), sum_(from + to), cosine_(from.dot(to)) {}

  Vec3 of(const Vec3& v) const noexcept {
    return v - sum_ * (sum_.dot(v) / (1 + cosine_)) + to_ * (2 * from_.dot(v));
  }

 private:
  Vec3 from_, to_, sum_;
  double cosine_;
};

void add(Walls& walls, const ContactHold& hold, const Vec3& push_m) noexcept {
  const double share_m = push_m.norm();
  const Vec3 normal_W = share_m > 0 ? Vec3(push_m / share_m) : push_m;
  for (int i = 0; i < walls.count; ++i) {
    Wall& wall = walls.walls[static_cast<std::size_t>(i)];
    if (wall.surface != hold.surface || wall.normal_W.dot(normal_W) < cos_one_wall) continue;
    wall.share_m += share_m;
    wall.push_m += push_m;
    wall.normal_W = wall.push_m.normalized();
    return;
  }
  walls.walls[static_cast<std::size_t>(walls.count++)] = {
      hold.surface, hold.triangle, hold.point_W, normal_W, share_m, push_m, 0};
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

/// Whether no two of the holds are walls of their own: mostly, where there are several.
bool are_one_wall(const Contact& contact) noexcept {
  const auto holds = static_cast<std::size_t>(contact.hold_count);
  for (std::size_t i = 0; i < holds; ++i) {
    const ContactHold& hold = contact.holds[i];
    if (hold.surface != contact.holds[0].surface || !(hold.share_m > 0)) return false;
    for (std::size_t k = 0; k < i; ++k) {
      if (hold.normal_W.dot(contact.holds[k].normal_W) < cos_one_wall) return false;
    }
  }
  return true;
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
  if (are_one_wall(contact)) {
    // Turned or not, a hold pushes as far; and turned as they are, they add up to the contact's own push.
    double share_m = 0;
    for (std::size_t i = 0; i < holds; ++i) share_m += contact.holds[i].share_m;
    be_one_wall(contact, walls);
    walls.walls[0].point_W = greatest.point_W;
    walls.walls[0].share_m *= share_m / sum_length_m;
    return;
  }
  // Walls that all but face each other: shaded, what is left of their pushes may point the other way.
  constexpr double cos_opposite = -0.999;
  const Vec3 together = sum_m / sum_length_m;
  if (together.dot(contact.normal_W) < cos_opposite) return be_one_wall(contact, walls);
  walls.count = 0;
  const Turn turn(together, contact.normal_W);
  const double scale = contact.depth_m / sum_length_m;
  for (std::size_t i = 0; i < holds; ++i) {
    const ContactHold& hold = contact.holds[i];
    if (!(hold.share_m > 0)) continue;
    add(walls, hold, scale * hold.share_m * turn.of(hold.normal_W));
  }
  sort_by_share(walls);
}

}  // namespace fingerpad
