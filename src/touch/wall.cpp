#include "touch/wall.hpp"

#include <utility>

namespace fingerpad {
namespace {

constexpr double cos_one_wall = 0.8660254037844387;  // 30 degrees, as creases are told by default
constexpr double most_wedged = 10;                   // of the push: in a wedge of 5.7 degrees to either side

/// Takes `from` onto `to` (both unit): by the smallest rotation, two reflections. Where that would be more
/// than a right angle, by one: then `from` is what little is left of pushes that all but cancel, and walls
/// that face each other would change places.
class Turn {
 public:
  Turn(const Vec3& from, const Vec3& to) noexcept
      : from_(from), to_(to), sum_(from + to), cosine_(from.dot(to)) {}

  Vec3 of(const Vec3& v) const noexcept {
    const Vec3 apart = from_ - to_;
    if (cosine_ < 0) return v - apart * (apart.dot(v) / (1 - cosine_));
    return v - sum_ * (sum_.dot(v) / (1 + cosine_)) + to_ * (2 * from_.dot(v));
  }

 private:
  Vec3 from_, to_, sum_;
  double cosine_;
};

/// What each hold pushes by, as felt: along its shaded normal, turned and scaled as all of them are, so that
/// they add up to the contact's own push.
///
/// Of walls that all but face each other little is left of the sum, and shading leaves any other little: no
/// scale above two is taken from that, the less of its direction the less there is, and what is then missing
/// is added by shares. So, in a contact that is no deeper than its shares together, no hold pushes by more
/// than four times its own.
///
/// Nor are such walls driven apart without bound: a rigid ball in a wedge of half-angle beta pushes its walls
/// by 1/sin(beta) of what presses it in, a sliver's two sides by a thousand times, and friction with them. A
/// pad gives way there. Where the shares together come to more than `most_wedged` depths, they are scaled
/// down to these, and what then lacks of the contact's push is added by shares too.
class SharedPush {
 public:
  /// @param sum_m  of the holds' shares along their shaded normals
  SharedPush(const Vec3& sum_m, const Contact& contact) noexcept
      : turn_(direction_of(sum_m, contact.normal_W), contact.normal_W) {
    constexpr double largest = 2;
    const double length_m = sum_m.norm(), depth_m = contact.depth_m;
    double shares_m = 0;
    for (int i = 0; i < contact.hold_count; ++i)
      shares_m += contact.holds[static_cast<std::size_t>(i)].share_m;
    const bool is_told = depth_m <= largest * length_m;
    scale_ = is_told ? depth_m / length_m : largest;
    const double wedged = scale_ * shares_m / depth_m;
    if (is_told && wedged <= most_wedged) return;
    told_ = is_told ? 1 : largest * length_m / depth_m;
    scale_ *= std::min(1.0, most_wedged / wedged);
    missing_per_share_ = (depth_m * contact.normal_W - scale_ * turned(sum_m)) / shares_m;
  }

  Vec3 of(const ContactHold& hold) const noexcept {
    return scale_ * hold.share_m * turned(hold.normal_W) + hold.share_m * missing_per_share_;
  }

 private:
  static Vec3 direction_of(const Vec3& v, const Vec3& otherwise) noexcept {
    const double length = v.norm();
    return length > 0 ? Vec3(v / length) : otherwise;
  }
  Vec3 turned(const Vec3& v) const noexcept {
    return told_ < 1 ? Vec3((1 - told_) * v + told_ * turn_.of(v)) : turn_.of(v);
  }

  Turn turn_;
  double scale_ = 1;
  double told_ = 1;  // how much of the turn is made: 1 up to the largest scale, 0 where there is no sum
  Vec3 missing_per_share_ = Vec3::Zero();
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
  if (!(greatest.share_m > 0)) return be_one_wall(contact, walls);
  if (are_one_wall(contact)) {
    // Turned or not, a hold pushes as far; and turned as they are, they add up to the contact's own push.
    double share_m = 0;
    for (std::size_t i = 0; i < holds; ++i) share_m += contact.holds[i].share_m;
    be_one_wall(contact, walls);
    walls.walls[0].point_W = greatest.point_W;
    walls.walls[0].share_m *= share_m / sum_length_m;
    return;
  }
  walls.count = 0;
  const SharedPush push(sum_m, contact);
  for (std::size_t i = 0; i < holds; ++i) {
    const ContactHold& hold = contact.holds[i];
    if (hold.share_m > 0) add(walls, hold, push.of(hold));
  }
  sort_by_share(walls);
}

}  // namespace fingerpad
