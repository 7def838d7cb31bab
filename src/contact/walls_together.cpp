#include "contact/walls_together.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "contact/proxy_limits.hpp"

namespace fingerpad {

WallsTogether::WallsTogether(const std::array<Vec3, 3>& normals, int count) noexcept : count_(count) {
  const Vec3 &a = normals[0], &b = normals[1], &c = normals[2];
  if (count == 2) {
    const double sine2 = a.cross(b).squaredNorm(), cosine = a.dot(b);
    fix_shares_ = sine2 > ProxyLimits::parallel2;
    turn_ = cosine < 0 ? -1 : 1;
    common_ = 1 / (1 + turn_ * cosine);
    per_sine2_ = 1 / sine2;
  }
  if (count == 3) {
    const Vec3 bc = b.cross(c);
    const double volume = a.dot(bc);
    fix_shares_ = std::abs(volume) > ProxyLimits::flat_volume;
    dual_ = {bc / volume, c.cross(a) / volume, a.cross(b) / volume};
  }
}

}  // namespace fingerpad
