#include "touch/parts_ball.hpp"

#include <limits>

#include "part/part.hpp"

namespace fingerpad {

std::optional<Ball> ball_of_parts(const World& world) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Surface& surface : world.surfaces) {
    if (!surface.part) continue;
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
      const Vec3 p_P = surface.part->centre_P + sign.cwiseProduct(surface.part->half_extent);
      const Vec3 p_W = surface.p_WP + surface.R_WP * p_P;
      low = low.cwiseMin(p_W);
      high = high.cwiseMax(p_W);
    }
  }
  if (!(low.x() <= high.x())) return std::nullopt;
  return Ball{(low + high) / 2, (high - low).norm() / 2};
}

}  // namespace fingerpad
