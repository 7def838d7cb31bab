#include "device/motor_guard.hpp"

#include <algorithm>

namespace fingerpad {
namespace {

/// By so much the limit is lowered that nobody who measures the force, in whatever axes and order of sums,
/// finds more of it than the limit.
constexpr double rounding = 1e-14;

/// Makes a vector no longer than `longest`, whatever its numbers. @returns whether it was longer
bool shorten(Vec3& vector, double longest) noexcept {
  const double largest = vector.cwiseAbs().maxCoeff();
  if (!(largest > 0)) return false;
  const Vec3 share = vector / largest;  // so that its square does not overflow
  const double length = largest * share.norm();
  if (length <= longest) return false;
  vector = share * (longest / share.norm());
  return true;
}

}  // namespace

MotorGuard::MotorGuard(const DeviceSettings& settings) noexcept
    : limit_n_(settings.force_limit_n * (1 - rounding)),
      rate_limit_n_per_s_(settings.force_rate_limit_n_per_s),
      soft_start_s_(settings.soft_start_s) {}

void MotorGuard::release() noexcept {
  sent_D_n_.setZero();
  ceiling_n_ = 0;
}

MotorGuard::Sent MotorGuard::next(const Vec3& wanted_D_n, bool touching, double dt_s) noexcept {
  if (stopped()) {
    release();
    return {Vec3::Zero(), touching};
  }
  Sent sent;
  Vec3 target_D_n = Vec3::Zero();
  if (!touching) {
    ceiling_n_ = 0;
  } else {
    const double grown_n = soft_start_s_ > 0 ? ceiling_n_ + limit_n_ * dt_s / soft_start_s_ : limit_n_;
    ceiling_n_ = std::min(limit_n_, grown_n);
    sent.limited = !wanted_D_n.allFinite();
    if (!sent.limited) target_D_n = wanted_D_n;
    sent.limited |= shorten(target_D_n, ceiling_n_);
  }
  Vec3 step_D_n = target_D_n - sent_D_n_;
  const bool too_fast = shorten(step_D_n, rate_limit_n_per_s_ * dt_s);
  sent_D_n_ = too_fast ? Vec3(sent_D_n_ + step_D_n) : target_D_n;
  sent.limited |= too_fast;
  shorten(sent_D_n_, limit_n_);
  sent.force_D_n = sent_D_n_;
  return sent;
}

}  // namespace fingerpad
