#include "view/draw_space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "touch/world.hpp"

namespace fingerpad {
namespace {

struct BoxGrower {
  Vec3 min = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 max = -min;
  void take(const Vec3& p) {
    min = min.cwiseMin(p);
    max = max.cwiseMax(p);
  }
  std::optional<Ball> ball() const {
    if (!(min.x() <= max.x())) return std::nullopt;
    return Ball{(min + max) / 2, (max - min).norm() / 2};
  }
};

}  // namespace

Ball ViewExtent::everything() const {
  if (parts && path) {
    // A path far from the parts (a finger that came from afar) is not worth losing them.
    const double reach_m = (path->centre_W - parts->centre_W).norm() + path->radius_m;
    return reach_m > 3 * parts->radius_m ? *parts : Ball{parts->centre_W, std::max(reach_m, parts->radius_m)};
  }
  if (parts) return *parts;
  if (path) return {path->centre_W, std::max(path->radius_m, 1e-3)};
  return {Vec3::Zero(), 0.05};
}

ViewExtent extent_of(const ViewInput& input) {
  ViewExtent extent;
  if (input.world) extent.parts = ball_of_parts(*input.world);
  BoxGrower touched, went;
  Vec3 normals = Vec3::Zero();
  double contacts = 0;
  for (const TickRecord& row : input.rows) {
    went.take(row.p_WQ);
    extent.max_force_n = std::max(extent.max_force_n, row.force_W_n.norm());
    if (row.phase == Phase::free) continue;
    touched.take(row.contact_W);
    normals += row.normal_W;
    ++contacts;
  }
  extent.path = touched.ball() ? touched.ball() : went.ball();
  // Round a whole part the normals cancel out: then the view of a part serves.
  if (contacts > 0 && normals.norm() > 0.1 * contacts) extent.facing_W = normals;
  if (contacts == 0 && !extent.parts && input.world) {
    for (const Surface& surface : input.world->surfaces) extent.facing_W = surface.plane_normal_W;
  }
  extent.facing_W.normalize();
  return extent;
}

}  // namespace fingerpad
