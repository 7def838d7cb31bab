#include "motion/finger_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/error.hpp"
#include "base/number_text.hpp"

namespace fingerpad {
namespace {

long ticks_between(double start_s, double end_s, double rate_hz) {
  // The last tick may lie a rounding error beyond the end: a motion of 1 s at 1 kHz has 1001 ticks.
  const double ticks = std::floor((end_s - start_s) * rate_hz + 1e-6) + 1;
  if (!(ticks <= most_ticks)) {
    throw refused("",
                  fmt::format("the motion lasts {} s, which is {} ticks at {} Hz; at most {:.0f} are run: "
                              "make it shorter or lower rate_hz (is its time in seconds?)",
                              end_s - start_s, rounded_text(ticks, 3), rate_hz, most_ticks));
  }
  return static_cast<long>(ticks);
}

/// The sample after `t_s`, or one behind the last. Clocks are mostly even: the place that an even one has is
/// tried before the search.
Eigen::Index sample_after(const std::vector<double>& t_s, double at_s, double samples_per_s) noexcept {
  const auto count = static_cast<Eigen::Index>(t_s.size());
  const double place = (at_s - t_s.front()) * samples_per_s;
  if (place >= 0 && place < static_cast<double>(count - 1)) {
    const auto guess = static_cast<Eigen::Index>(place);
    for (Eigen::Index right = std::max<Eigen::Index>(1, guess); right < std::min(count, guess + 3); ++right) {
      const auto k = static_cast<std::size_t>(right);
      if (t_s[k - 1] <= at_s && at_s < t_s[k]) return right;
    }
  }
  return std::upper_bound(t_s.begin(), t_s.end(), at_s) - t_s.begin();
}

/// The samples around a time, and how far between them it is.
struct Between {
  Eigen::Index left, right;
  double share;
};

Between between(const std::vector<double>& t_s, double at_s, double samples_per_s) noexcept {
  const auto last = static_cast<Eigen::Index>(t_s.size()) - 1;
  const auto right =
      std::clamp<Eigen::Index>(sample_after(t_s, at_s, samples_per_s), std::min<Eigen::Index>(1, last), last);
  const Eigen::Index left = std::max<Eigen::Index>(right - 1, 0);
  const double t_left = t_s[static_cast<std::size_t>(left)];
  if (at_s == t_left) return {left, right, 0};
  const double span = t_s[static_cast<std::size_t>(right)] - t_left;
  return {left, right, span > 0 ? std::clamp((at_s - t_left) / span, 0.0, 1.0) : 0.0};
}

FingerSample interpolated(const Motion& motion, double t_s, double samples_per_s,
                          const Vec3& direction_W) noexcept {
  const auto [left, right, u] = between(motion.t_s, t_s, samples_per_s);

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

long tick_count(double duration_s, double rate_hz) {
  return ticks_between(0, duration_s, rate_hz);
}

FingerPath::FingerPath(Motion motion, double rate_hz, const Vec3& direction_W)
    : rate_hz_(rate_hz),
      direction_W_(direction_W),
      t0_s_(motion.t_s.front()),
      end_s_(motion.t_s.back()),
      samples_per_s_(static_cast<double>(motion.t_s.size() - 1) / (end_s_ - t0_s_)),
      tick_count_(ticks_between(motion.t_s.front(), motion.t_s.back(), rate_hz)) {
  motion_ = std::make_shared<const Motion>(std::move(motion));
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

std::size_t FingerPath::memory_bytes() const noexcept {
  const Motion* recorded = recording();
  if (recorded == nullptr) return 0;
  Eigen::Index numbers = 0;
  for (const Points* points : {&recorded->p_WQ, &recorded->direction_W, &recorded->push_W_n,
                               &recorded->velocity_W, &recorded->force_W_n})
    numbers += points->size();
  return static_cast<std::size_t>(numbers) * sizeof(double) + recorded->attitude.size() * sizeof(Attitude) +
         (recorded->t_s.size() + recorded->normal_force_n.size()) * sizeof(double);
}

bool FingerPath::goes_as(const FingerPath& other) const noexcept {
  if (rate_hz_ != other.rate_hz_ || tick_count_ != other.tick_count_ ||
      motion_.index() != other.motion_.index())
    return false;
  const Motion* const a = recording();
  const Motion* const b = other.recording();
  if (a == nullptr) return std::get<ScriptedMotion>(motion_) == std::get<ScriptedMotion>(other.motion_);
  if (a == b) return true;
  const auto is_alike = [](const double* from, const double* other_from, auto count) {
    return std::memcmp(from, other_from, static_cast<std::size_t>(count) * sizeof *from) == 0;
  };
  return a->t_s.size() == b->t_s.size() && a->p_WQ.cols() == b->p_WQ.cols() &&
         is_alike(a->t_s.data(), b->t_s.data(), a->t_s.size()) &&
         is_alike(a->p_WQ.data(), b->p_WQ.data(), a->p_WQ.size());
}

double FingerPath::farthest_m() const noexcept {
  const auto largest = [](const auto& p) { return p.cwiseAbs().maxCoeff(); };
  const auto* scripted = std::get_if<ScriptedMotion>(&motion_);
  if (scripted == nullptr) return largest(recording()->p_WQ);
  if (scripted->kind == ScriptedMotion::Kind::line)
    return std::max(largest(scripted->from_m), largest(scripted->to_m));
  return largest(scripted->centre_m) + scripted->amplitude_m;
}

const Motion* FingerPath::recording() const noexcept {
  const auto* shared = std::get_if<std::shared_ptr<const Motion>>(&motion_);
  return shared != nullptr ? shared->get() : nullptr;
}

bool FingerPath::turns() const noexcept {
  const Motion* recorded = recording();
  return recorded != nullptr && (recorded->direction_W.cols() > 0 || !recorded->attitude.empty());
}

bool FingerPath::was_in_hand() const noexcept {
  const Motion* recorded = recording();
  return recorded != nullptr && recorded->push_W_n.cols() > 0;
}

bool FingerPath::has_attitudes() const noexcept {
  const Motion* recorded = recording();
  return recorded != nullptr && !recorded->attitude.empty();
}

bool FingerPath::has_velocity() const noexcept {
  const Motion* recorded = recording();
  return recorded != nullptr && recorded->velocity_W.cols() > 0;
}

bool FingerPath::has_measured_force() const noexcept {
  const Motion* recorded = recording();
  return recorded != nullptr && recorded->force_W_n.cols() > 0;
}

Vec3 FingerPath::measured_force_W_n(long k) const noexcept {
  const Motion& motion = *recording();
  const auto [left, right, u] =
      between(motion.t_s, t0_s_ + static_cast<double>(k) / rate_hz_, samples_per_s_);
  return (1 - u) * motion.force_W_n.col(left) + u * motion.force_W_n.col(right);
}

FingerSample FingerPath::at(long k) const noexcept {
  return at_time(t0_s_ + static_cast<double>(k) / rate_hz_);
}

FingerSample FingerPath::at_time(double t_s) const noexcept {
  if (const auto* scripted = std::get_if<ScriptedMotion>(&motion_))
    return {t_s, scripted->at(t_s), direction_W_};
  return interpolated(*recording(), t_s, samples_per_s_, direction_W_);
}

}  // namespace fingerpad
