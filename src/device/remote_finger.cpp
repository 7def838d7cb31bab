#include "device/remote_finger.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace fingerpad {

RemoteFinger::RemoteFinger(const DeviceSettings& settings, const FingerSample& rest) noexcept
    : guard_(settings), workspace_(settings, rest), rest_(rest), watchdog_s_(settings.watchdog_s) {}

void RemoteFinger::hear(const DeviceReading& reading) noexcept {
  last_ = reading;
}

FingerSample RemoteFinger::advance(std::int64_t now_ns, double dt_s) noexcept {
  dt_s_ = dt_s;
  const double silence_s = 1e-9 * static_cast<double>(now_ns - last_.arrived_ns);
  const bool silent = last_.accepted == 0 || silence_s >= watchdog_s_;
  if (silent && !lifted_) {
    tripped_ = true;
    trips_.trip(now_ns);
  }
  lifted_ = silent;
  return lifted_ ? rest_ : workspace_.finger(last_.place);
}

/// Limited by as much as the force is, and of arms as long as the device sees them.
Vec3 RemoteFinger::torque_D_n_m(const TickRecord& tick, const Vec3& wanted_D_n,
                                const Vec3& sent_D_n) const noexcept {
  const double wanted_n = wanted_D_n.norm();
  if (!(wanted_n > 0) || !tick.torque_W_n_m.allFinite()) return Vec3::Zero();
  const double share = std::min(1.0, sent_D_n.norm() / wanted_n);
  return workspace_.force_D_n(tick.torque_W_n_m) * (share / workspace_.scale());
}

DeviceAnswer RemoteFinger::feel(const TickRecord& tick, std::int64_t now_ns, bool is_sent) noexcept {
  DeviceAnswer answer;
  const bool touching = tick.phase != Phase::free && !lifted_;
  // A clutched device is moved without its finger, which then must not push it.
  if (lifted_ || last_.place.clutch) guard_.release();
  const bool wanted = touching && !last_.place.clutch;
  // A servo that was held up makes its ticks good in a burst: what the motors may do goes by the clock then.
  const double since_s = 1e-9 * static_cast<double>(now_ns - felt_ns_);
  const double allowed_s = std::clamp(since_s, 1e-9, dt_s_);
  felt_ns_ = now_ns;
  const Vec3 wanted_D_n = workspace_.force_D_n(tick.force_W_n);
  const MotorGuard::Sent sent = guard_.next(wanted_D_n, wanted, allowed_s);
  answer.force_D_n = sent.force_D_n;
  answer.limited = sent.limited || (touching && !wanted);
  answer.torque_D_n_m = touching ? torque_D_n_m(tick, wanted_D_n, sent.force_D_n) : Vec3::Zero();
  answer.phase = touching ? tick.phase : Phase::free;
  answer.depth_m = touching ? tick.depth_m / workspace_.scale() : 0;
  answer.watchdog_tripped = tripped_;
  answer.stopped = guard_.stopped();
  answer.made_ns = now_ns;
  answer.sequence = last_.sequence;
  answer.accepted = last_.accepted;
  if (is_sent) tripped_ = false;
  sent_W_n_ = workspace_.in_world(sent.force_D_n);
  return answer;
}

}  // namespace fingerpad
