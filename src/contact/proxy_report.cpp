#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "contact/proxy.hpp"

// What the proxy tells of itself: the walls that hold it, and the way from the finger to it.

namespace fingerpad {
namespace {

/// The smallest rotation from one unit vector to another, as axis times the tangent of half the angle
/// (Rodrigues); none where they are opposite. A mean of such turns is no wider than the widest.
Vec3 turn_between(const Vec3& from, const Vec3& to) noexcept {
  const double sum = 1 + from.dot(to);
  return sum > 1e-6 ? Vec3(from.cross(to) / sum) : Vec3::Zero();
}

/// A unit vector after a turn.
Vec3 turned(const Vec3& v, const Vec3& turn) noexcept {
  const Vec3 across = turn.cross(v);
  return v + 2 / (1 + turn.squaredNorm()) * (across + turn.cross(across));
}

/// Greatest first; std::stable_sort would allocate.
void sort_by_share(ProxyContact& contact) noexcept {
  for (std::size_t k = 1; k < static_cast<std::size_t>(contact.hold_count); ++k) {
    for (std::size_t i = k; i > 0 && contact.holds[i].share_m > contact.holds[i - 1].share_m; --i)
      std::swap(contact.holds[i], contact.holds[i - 1]);
  }
}

}  // namespace

/// What holds the proxy where the place under it is looked for.
ProxyHold Proxy::hold_at(const ProxyWall& wall, double share_m) const noexcept {
  const ProxySurface& surface = around_.surfaces()[static_cast<std::size_t>(wall.surface)];
  if (wall.triangle < 0) {
    const Vec3 point =
        place_ + (around_.plane_wall(wall.surface, place_).least_m - around_.clearance_m()) * wall.normal;
    return {wall.surface, wall.triangle, point + around_.centre_W(), wall.normal, share_m};
  }
  const TriangleApproach approach =
      approach_triangle(surface.tree->part(), wall.triangle, around_.in_part(wall.surface, place_));
  return {wall.surface, wall.triangle,
          around_.from_part(wall.surface, approach.at.point) + around_.centre_W(),
          shaded_W(wall, approach.at), share_m};
}

/// What holds the proxy where it stands over a facet, with these weights of its corners.
ProxyHold Proxy::hold_over(const ProxyWall& wall, double share_m, const Vec3& weights) const noexcept {
  TrianglePoint at;
  at.barycentric = weights;
  return {wall.surface, wall.triangle, place_ - around_.clearance_m() * wall.normal + around_.centre_W(),
          shaded_W(wall, at), share_m};
}

/// The normal of a wall as Normals says at a point of its triangle.
Vec3 Proxy::shaded_W(const ProxyWall& wall, const TrianglePoint& at) const noexcept {
  if (normals_->shade == nullptr) return wall.normal;
  const ProxySurface& surface = around_.surfaces()[static_cast<std::size_t>(wall.surface)];
  const Vec3 normal_P = surface.R_WP.transpose() * wall.normal;
  const double side = side_of(surface.tree->part().facet_normals.col(wall.triangle), normal_P);
  return surface.R_WP * (side * shaded_normal(*surface.tree, wall.triangle, at, normals_, side * normal_P));
}

void Proxy::report(const Vec3& goal) noexcept {
  if (!contact_.settled) {
    report_underway(goal);
    return;
  }
  contact_.touching = false;
  if (hold_.wall_count == 0) {
    if (goal != place_) report_underway(goal);
    return;
  }
  // The ball without its skin: the walls stand nearer by that.
  std::array<ProxyWall, 3> walls = hold_.walls;
  for (ProxyWall& wall : walls) wall.least_m -= around_.skin_m();
  const ProxyProjection p = project_onto_walls(
      goal - hold_place_, std::span(walls.data(), static_cast<std::size_t>(hold_.wall_count)),
      std::ldexp(around_.tolerance_m(), -2));
  if (!p.found) {
    contact_.hold_count = 0;
    report_underway(goal);
    return;
  }
  for (std::size_t k = 0; k < static_cast<std::size_t>(p.active_count); ++k)
    contact_.holds[k] = hold_at(hold_.walls[static_cast<std::size_t>(p.active[k])], p.share_m[k]);
  report_held(goal, p);
}

/// The turn from the walls' normals to the holds' shaded ones: the mean, each weighted with its share.
/// @param walls  of the holds, in their order
Vec3 Proxy::turn_of_holds(std::span<const ProxyWall> walls) const noexcept {
  Vec3 turn = Vec3::Zero();
  double share_m = 0;
  for (std::size_t k = 0; k < walls.size(); ++k) {
    const ProxyHold& hold = contact_.holds[k];
    turn += hold.share_m * turn_between(walls[k].normal, hold.normal_W);
    share_m += hold.share_m;
  }
  return share_m > 0 ? Vec3(turn / share_m) : Vec3::Zero();
}

/// As far on the way from the last tick's normal to another as changes the push by at most so much.
/// @pre the other changes it by more
Vec3 Proxy::normal_towards(const Vec3& shaded, double most_m) const noexcept {
  const double depth_m = contact_.depth_m, last_m = last_push_.norm();
  const Vec3 last = last_push_ / last_m, across = shaded - shaded.dot(last) * last;
  const double across_m = across.norm();
  if (!(across_m > 1e-9)) return shaded;  // the same, or the opposite, to which no way is the shortest
  // The law of cosines in the triangle of both pushes and their difference.
  const double cosine =
      std::min(1.0, (depth_m * depth_m + last_m * last_m - most_m * most_m) / (2 * depth_m * last_m));
  return cosine * last + std::sqrt(std::max(0.0, 1 - cosine * cosine)) / across_m * across;
}

/// Shows a normal, or, where the push would change too much by it, one on the way there from the last tick's.
void Proxy::show(const Vec3& shaded) noexcept {
  contact_.normal_W = shaded;
  const bool after_hop = hopped_ || lags_;
  lags_ = false;
  const double depth_m = contact_.depth_m, step2_m2 = (depth_m * shaded - last_push_).squaredNorm();
  if (normals_->shade == nullptr || step2_m2 <= finger_m_ * finger_m_ || last_push_.isZero(0)) return;
  const double most_m = most_step_m() + (after_hop ? unfelt_share * depth_m : 0.0);
  if (step2_m2 <= most_m * most_m) return;
  if (after_hop) {
    lags_ = true;
    contact_.normal_W = normal_towards(shaded, most_m);
    // A hop that had to wait can bring the proxy nearer by more than may be shown at once.
    const double held_back_m = last_push_.norm() - most_m - depth_m;
    if (held_back_m > 0) {
      contact_.depth_m += held_back_m;
      contact_.proxy_W += held_back_m * contact_.direction_W;
    }
    return;
  }
  // The last turn, kept, changes the push by no more than the way to the proxy changes.
  const Vec3& direction = contact_.direction_W;
  const Vec3 last = turn_between(last_direction_, last_push_.normalized());
  const Vec3 left = turn_between(direction, shaded) - last;
  const Vec3 kept = turned(direction, last);
  const double kept_step_m = (depth_m * kept - last_push_).norm();
  if (kept_step_m * kept_step_m > step2_m2) return;
  // A unit vector goes by no more than twice what its turn changes by.
  const double left_m = 2 * depth_m * left.norm(), room_m = std::max(0.0, most_m - kept_step_m);
  if (room_m < left_m) contact_.normal_W = turned(direction, last + room_m / left_m * left);
}

/// @param p  onto the walls of hold_ that hold the ball without its skin
void Proxy::report_held(const Vec3& goal, const ProxyProjection& p) noexcept {
  std::array<ProxyWall, 3> walls;
  Vec3 push = Vec3::Zero();
  for (std::size_t k = 0; k < static_cast<std::size_t>(p.active_count); ++k) {
    walls[k] = hold_.walls[static_cast<std::size_t>(p.active[k])];
    push += p.share_m[k] * walls[k].normal;
  }
  const bool is_single = p.active_count == 1;
  contact_.settled = true;
  contact_.hold_count = p.active_count;
  contact_.depth_m = is_single ? p.share_m[0] : push.norm();
  contact_.touching = contact_.depth_m > 0;
  if (!contact_.touching) return;
  contact_.proxy_W = goal + push + around_.centre_W();
  if (is_single) {
    contact_.direction_W = walls[0].normal;
    contact_.point_W = contact_.holds[0].point_W;
    show(contact_.holds[0].normal_W);
    return;
  }
  contact_.direction_W = push / contact_.depth_m;
  contact_.point_W = contact_.proxy_W - around_.radius_m() * contact_.direction_W;
  const std::span holding(walls.data(), static_cast<std::size_t>(p.active_count));
  show(normals_->shade == nullptr ? contact_.direction_W
                                  : turned(contact_.direction_W, turn_of_holds(holding)));
  sort_by_share(contact_);
}

/// The proxy has not come to rest: on its way it pushes as far as it still has to go.
void Proxy::report_underway(const Vec3& goal) noexcept {
  if (hold_.wall_count > 0) {
    contact_.hold_count = 0;
    for (int k = 0; k < hold_.wall_count; ++k) {
      contact_.holds[static_cast<std::size_t>(contact_.hold_count++)] =
          hold_at(hold_.walls[static_cast<std::size_t>(k)], hold_.share_m[static_cast<std::size_t>(k)]);
    }
  }
  const Vec3 push = place_ - goal;
  const double length_m = push.norm();
  contact_.depth_m = std::max(0.0, length_m - around_.skin_m());
  contact_.touching = contact_.depth_m > 0 && contact_.hold_count > 0;
  if (!contact_.touching) return;
  contact_.settled = false;
  contact_.direction_W = push / length_m;
  contact_.proxy_W = place_ + around_.centre_W();
  contact_.point_W = contact_.proxy_W - around_.radius_m() * contact_.direction_W;
  show(contact_.direction_W);
}

}  // namespace fingerpad
