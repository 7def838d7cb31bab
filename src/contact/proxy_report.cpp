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

ProxyHold Proxy::hold_at(const ProxyWall& wall, double share_m) const noexcept {
  ProxyHold hold;
  hold.surface = wall.surface;
  hold.triangle = wall.triangle;
  hold.share_m = share_m;
  hold.normal_W = wall.normal;
  const ProxySurface& surface = around_.surfaces()[static_cast<std::size_t>(wall.surface)];
  if (wall.triangle < 0) {
    hold.point_W = place_ + around_.plane_wall(wall.surface, place_).least_m * wall.normal -
                   around_.clearance_m() * wall.normal + around_.centre_W();
    return hold;
  }
  const Part& part = surface.tree->part();
  const Vec3 q = around_.in_part(wall.surface, place_);
  const TriangleApproach approach = approach_triangle(part, wall.triangle, q);
  hold.point_W = around_.from_part(wall.surface, approach.at.point) + around_.centre_W();
  const Vec3 normal_P = surface.R_WP.transpose() * wall.normal;
  const double side = side_of(part.facet_normals.col(wall.triangle), normal_P);
  hold.normal_W = surface.R_WP * (side * shaded_normal(*surface.tree, wall.triangle, approach.at, normals_,
                                                       side * normal_P));
  return hold;
}

void Proxy::report(const Vec3& goal) noexcept {
  const bool started = contact_.started;
  if (!contact_.settled) {
    report_underway(goal);
    return;
  }
  contact_.touching = false;
  if (hold_.wall_count == 0) {
    if (goal != place_) report_underway(goal);
    return;
  }
  contact_ = {};
  contact_.started = started;
  // The ball without its skin: the walls stand nearer by that.
  std::array<ProxyWall, 3> walls = hold_.walls;
  for (ProxyWall& wall : walls) wall.least_m -= around_.skin_m();
  const ProxyProjection p = project_onto_walls(
      goal - hold_place_, std::span(walls.data(), static_cast<std::size_t>(hold_.wall_count)),
      std::ldexp(around_.tolerance_m(), -2));
  if (!p.found) {
    report_underway(goal);
    return;
  }
  Vec3 push = Vec3::Zero(), shaded = Vec3::Zero();
  for (int k = 0; k < p.active_count; ++k) {
    const ProxyWall& wall = walls[static_cast<std::size_t>(p.active[k])];
    ProxyHold& hold = contact_.holds[static_cast<std::size_t>(k)] = hold_at(wall, p.share_m[k]);
    push += hold.share_m * wall.normal;
    shaded += hold.share_m * hold.normal_W;
  }
  contact_.hold_count = p.active_count;
  sort_by_share(contact_);
  contact_.depth_m = push.norm();
  contact_.touching = contact_.depth_m > 0;
  if (!contact_.touching) return;
  contact_.direction_W = p.active_count == 1 ? hold_.walls[static_cast<std::size_t>(p.active[0])].normal
                                             : Vec3(push / contact_.depth_m);
  const double shaded_m = shaded.norm();
  contact_.normal_W = p.active_count == 1 ? contact_.holds[0].normal_W
                      : shaded_m > 0      ? Vec3(shaded / shaded_m)
                                          : contact_.direction_W;
  contact_.proxy_W = goal + push + around_.centre_W();
  contact_.point_W = p.active_count == 1 ? contact_.holds[0].point_W
                                         : Vec3(contact_.proxy_W - around_.radius_m() * contact_.direction_W);
}

/// One facet holds the proxy, and the place under it is known by the weights of the facet's corners.
void Proxy::report_slide(const Vec3& goal, double depth_m, const Vec3& weights) noexcept {
  const ProxyWall& wall = hold_.walls[0];
  const ProxySurface& surface = around_.surfaces()[static_cast<std::size_t>(wall.surface)];
  const Part& part = surface.tree->part();
  contact_.touching = contact_.settled = true;
  contact_.depth_m = depth_m;
  contact_.direction_W = wall.normal;
  contact_.proxy_W = goal + depth_m * wall.normal + around_.centre_W();
  contact_.point_W = hold_place_ - around_.clearance_m() * wall.normal + around_.centre_W();
  contact_.hold_count = 1;
  ProxyHold& hold = contact_.holds[0];
  hold = {wall.surface, wall.triangle, contact_.point_W, wall.normal, depth_m};
  if (normals_ != Normals::facet) {
    const Vec3 normal_P = surface.R_WP.transpose() * wall.normal;
    const double side = side_of(part.facet_normals.col(wall.triangle), normal_P);
    TrianglePoint at;
    at.barycentric = weights;
    hold.normal_W =
        surface.R_WP * (side * shaded_normal(*surface.tree, wall.triangle, at, normals_, side * normal_P));
  }
  contact_.normal_W = hold.normal_W;
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
