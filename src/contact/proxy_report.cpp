#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "contact/proxy.hpp"

// What the proxy tells of itself: the walls that hold it, and the way from the finger to it.

namespace fingerpad {
namespace {

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
  if (normals_ == Normals::facet) return wall.normal;
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

/// @param p  onto the walls of hold_ that hold the ball without its skin
void Proxy::report_held(const Vec3& goal, const ProxyProjection& p) noexcept {
  Vec3 push = Vec3::Zero(), shaded = Vec3::Zero();
  for (std::size_t k = 0; k < static_cast<std::size_t>(p.active_count); ++k) {
    push += p.share_m[k] * hold_.walls[static_cast<std::size_t>(p.active[k])].normal;
    shaded += p.share_m[k] * contact_.holds[k].normal_W;
  }
  const bool is_single = p.active_count == 1;
  contact_.settled = true;
  contact_.hold_count = p.active_count;
  contact_.depth_m = is_single ? p.share_m[0] : push.norm();
  contact_.touching = contact_.depth_m > 0;
  if (!contact_.touching) return;
  contact_.proxy_W = goal + push + around_.centre_W();
  if (is_single) {
    contact_.direction_W = hold_.walls[static_cast<std::size_t>(p.active[0])].normal;
    contact_.normal_W = contact_.holds[0].normal_W;
    contact_.point_W = contact_.holds[0].point_W;
    return;
  }
  sort_by_share(contact_);
  contact_.direction_W = push / contact_.depth_m;
  const double shaded_m = shaded.norm();
  contact_.normal_W = shaded_m > 0 ? Vec3(shaded / shaded_m) : contact_.direction_W;
  contact_.point_W = contact_.proxy_W - around_.radius_m() * contact_.direction_W;
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
  contact_.direction_W = contact_.normal_W = push / length_m;
  contact_.proxy_W = place_ + around_.centre_W();
  contact_.point_W = contact_.proxy_W - around_.radius_m() * contact_.direction_W;
}

}  // namespace fingerpad
