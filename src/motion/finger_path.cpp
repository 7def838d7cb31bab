#include "motion/finger_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace fingerpad {
namespace {

long ticks_between(double start_s, double end_s, double rate_hz) {
  // The last tick may lie a rounding error beyond the end: a motion of 1 s at 1 kHz has 1001 ticks.
  const double ticks = std::floor((end_s - start_s) * rate_hz + 1e-6) + 1;
  if (!(ticks <= most_ticks)) {
    throw refused(
        "", fmt::format("the motion lasts {} s, which is {:.3g} ticks at {} Hz; at most {:.0f} are run: "
                        "make it shorter or lower rate_hz (is its time in seconds?)",
                        end_s - start_s, ticks, rate_hz, most_ticks));
  }
  return static_cast<long>(ticks);
}

FingerSample interpolated(const Motion& motion, double t_s, const Vec3& direction_W) noexcept {
  const auto above = std::upper_bound(motion.t_s.begin(), motion.t_s.end(), t_s);
  const auto last = static_cast<Eigen::Index>(motion.t_s.size()) - 1;
  const auto right =
      std::clamp<Eigen::Index>(above - motion.t_s.begin(), std::min<Eigen::Index>(1, last), last);
  const Eigen::Index left = std::max<Eigen::Index>(right - 1, 0);
  const double t_left = motion.t_s[static_cast<std::size_t>(left)];
  const double span = motion.t_s[static_cast<std::size_t>(right)] - t_left;
  const double u = span > 0 ? std::clamp((t_s - t_left) / span, 0.0, 1.0) : 0.0;

  FingerSample sample;
  sample.t_s = t_s;
  sample.p_WQ = (1 - u) * motion.p_WQ.col(left) + u * motion.p_WQ.col(right);
  if (motion.push_W_n.cols() > 0)
    sample.push_W_n = (1 - u) * motion.push_W_n.col(left) + u * motion.push_W_n.col(right);
  sample.direction_W = direction_W;
  if (!motion.attitude.empty()) {
    sample.attitude = motion.attitude[static_cast<std::size_t>(left)].slerp(
        u, motion.attitude[static_cast<std::size_t>(right)]);
    sample.direction_W = *sample.attitude * direction_W;
  }
  if (!motion.normal_force_n.empty()) {
    sample.normal_force_n = (1 - u) * motion.normal_force_n[static_cast<std::size_t>(left)] +
                            u * motion.normal_force_n[static_cast<std::size_t>(right)];
  }
  if (motion.velocity_W.cols() > 0) {
    sample.velocity_W = (1 - u) * motion.velocity_W.col(left) + u * motion.velocity_W.col(right);
  }
  if (motion.direction_W.cols() == 0) return sample;
  // At a sample its own number counts, to the last bit.
  if (u == 0 || u == 1) {
    sample.direction_W = motion.direction_W.col(u == 0 ? left : right);
    return sample;
  }
  const Vec3 mean = (1 - u) * motion.direction_W.col(left) + u * motion.direction_W.col(right);
  const double length = mean.norm();
  // Opposite neighbours have no mean: the earlier one holds.
  sample.direction_W = length > 1e-6 ? Vec3(mean / length) : Vec3(motion.direction_W.col(left));
  return sample;
}

}  // namespace

FingerPath::FingerPath(Motion motion, double rate_hz, const Vec3& direction_W)
    : rate_hz_(rate_hz),
      direction_W_(direction_W),
      t0_s_(motion.t_s.front()),
      end_s_(motion.t_s.back()),
      tick_count_(ticks_between(motion.t_s.front(), motion.t_s.back(), rate_hz)) {
  motion_ = std::move(motion);
}

FingerPath::FingerPath(const ScriptedMotion& motion, double rate_hz, const Vec3& direction_W)
    : motion_(motion),
      rate_hz_(rate_hz),
      direction_W_(direction_W),
      end_s_(motion.duration_s),
      tick_count_(ticks_between(0, motion.duration_s, rate_hz)) {}

FingerPath FingerPath::with_rate(double rate_hz) const {
  FingerPath path = *this;
  path.rate_hz_ = rate_hz;
  path.tick_count_ = ticks_between(t0_s_, end_s_, rate_hz);
  return path;
}

double FingerPath::farthest_m() const noexcept {
  const auto largest = [](const auto& p) { return p.cwiseAbs().maxCoeff(); };
  const auto* scripted = std::get_if<ScriptedMotion>(&motion_);
  if (scripted == nullptr) return largest(std::get_if<Motion>(&motion_)->p_WQ);
  if (scripted->kind == ScriptedMotion::Kind::line)
    return std::max(largest(scripted->from_m), largest(scripted->to_m));
  return largest(scripted->centre_m) + scripted->amplitude_m;
}

bool FingerPath::turns() const noexcept {
  const auto* recorded = std::get_if<Motion>(&motion_);
  return recorded != nullptr && (recorded->direction_W.cols() > 0 || !recorded->attitude.empty());
}

bool FingerPath::was_in_hand() const noexcept {
  const auto* recorded = std::get_if<Motion>(&motion_);
  return recorded != nullptr && recorded->push_W_n.cols() > 0;
}

bool FingerPath::has_attitudes() const noexcept {
  const auto* recorded = std::get_if<Motion>(&motion_);
  return recorded != nullptr && !recorded->attitude.empty();
}

bool FingerPath::has_velocity() const noexcept {
  const auto* recorded = std::get_if<Motion>(&motion_);
  return recorded != nullptr && recorded->velocity_W.cols() > 0;
}

FingerSample FingerPath::at(long k) const noexcept {
  return at_time(t0_s_ + static_cast<double>(k) / rate_hz_);
}

FingerSample FingerPath::at_time(double t_s) const noexcept {
  if (const auto* scripted = std::get_if<ScriptedMotion>(&motion_))
    return {t_s, scripted->at(t_s), direction_W_};
  return interpolated(*std::get_if<Motion>(&motion_), t_s, direction_W_);
}

}  // namespace fingerpad
