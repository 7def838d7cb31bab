#include "device/pointer_aim.hpp"

#include <cmath>

namespace fingerpad {

bool PointerAim::ask(const FingerSample& target) noexcept {
  const double length = target.direction_W.norm();
  if (!target.p_WQ.allFinite() || !target.push_W_n.allFinite() || !std::isfinite(target.t_s)) return false;
  if (!(length > 0) || !std::isfinite(length)) return false;
  finger = target;
  spot_W = target.p_WQ;
  return true;
}

void PointerAim::look_from(const Vec3& towards_W) noexcept {
  if (towards_W.allFinite() && towards_W.norm() > 0) towards_eye_W = towards_W.normalized();
}

}  // namespace fingerpad
