#include "study/position_delay.hpp"

#include <algorithm>
#include <cmath>

#include "study/phase_stretch.hpp"
#include "study/rupture_search.hpp"
#include "study/slope_window.hpp"

namespace fingerpad {
namespace {

/// The part of a trial around i without a gap.
PhaseStretch unbroken_around(const MeasuredTrial& trial, std::size_t from, std::size_t to,
                             std::size_t reach) {
  PhaseStretch found{from, to};
  while (found.from > 0 && from - found.from < reach && !trial.starts_anew[found.from]) --found.from;
  while (found.to < trial.starts_anew.size() && found.to - to < reach && !trial.starts_anew[found.to])
    ++found.to;
  return found;
}

/// q, q |q|^2 and q |q|^4 (columns) of both axes.
using OrderTerms = Eigen::Matrix<double, 2, 3>;

/// At each sample of a stretch, about their means.
std::vector<OrderTerms> centred_spring(const MeasuredTrial& trial, const PhaseStretch& stretch) {
  std::vector<OrderTerms> spring;
  OrderTerms mean = OrderTerms::Zero();
  for (std::size_t i = stretch.from; i < stretch.to; ++i) {
    const Vec2& q = trial.force_ratio[i];
    const double square = q.squaredNorm();
    spring.emplace_back();
    spring.back() << q, square * q, square * square * q;
    mean += spring.back() / static_cast<double>(stretch.to - stretch.from);
  }
  for (OrderTerms& terms : spring) terms -= mean;
  return spring;
}

/// A trial's positions of a moment before: whole samples, and the rest along the velocity.
class EarlierPositions {
 public:
  EarlierPositions(const MeasuredTrial& trial, const StickSegments& segments, double lag_s)
      : back_(std::lround(lag_s * trial.rate_hz)),
        rest_s_(lag_s - static_cast<double>(back_) / trial.rate_hz),
        position_m_(trial.position_m),
        velocity_m_per_s_(segments.velocity_m_per_s) {}
  Vec2 at(std::size_t i) const {
    const auto from = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) - back_);
    return position_m_[from] - rest_s_ * velocity_m_per_s_[from];
  }

 private:
  std::ptrdiff_t back_;
  double rest_s_;
  const std::vector<Vec2>&position_m_, &velocity_m_per_s_;
};

/// The positions' noise takes part of what a position explains.
void add_stretch(const MeasuredTrial& trial, const StickSegments& segments, PhaseStretch stretch,
                 DelaySums& sums) {
  const double noise_m2 = segments.position_noise_m * segments.position_noise_m;
  const auto reach =
      static_cast<std::size_t>(std::lround(delay_lags_each_way * delay_step_s * trial.rate_hz));
  const PhaseStretch around = unbroken_around(trial, stretch.from, stretch.to, reach);
  stretch.from = std::max(stretch.from, around.from + reach);
  stretch.to = std::min(stretch.to, around.to > reach ? around.to - reach : 0);
  if (stretch.to < stretch.from + 5) return;
  const auto count = static_cast<double>(stretch.to - stretch.from);
  const std::vector<OrderTerms> spring = centred_spring(trial, stretch);
  for (const OrderTerms& terms : spring) {
    for (Eigen::Index axis = 0; axis < 2; ++axis)
      sums.spring[static_cast<std::size_t>(axis)] += terms.row(axis).transpose() * terms.row(axis);
  }
  for (int lag = -delay_lags_each_way; lag <= delay_lags_each_way; ++lag) {
    const EarlierPositions position(trial, segments, lag * delay_step_s);
    Vec2 sum(0, 0), xx(0, 0);
    OrderTerms xq = OrderTerms::Zero();
    const Vec2 origin = position.at(stretch.from);
    for (std::size_t i = stretch.from; i < stretch.to; ++i) {
      const Vec2 x = position.at(i) - origin;
      sum += x;
      xx += x.cwiseProduct(x);
      xq += x.asDiagonal() * spring[i - stretch.from];
    }
    xx -= sum.cwiseProduct(sum) / count + Vec2::Constant((count - 1) * noise_m2);
    const auto k = static_cast<std::size_t>(long{lag} + delay_lags_each_way);
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
      sums.xx[static_cast<std::size_t>(axis)][k] += xx[axis];
      sums.xq[static_cast<std::size_t>(axis)][k] += xq.row(axis).transpose();
    }
  }
  sums.samples += static_cast<long>(stretch.to - stretch.from);
  sums.noise_m2 += (count - 1) * noise_m2;
}

DelaySums no_sums(const MeasuredTrial& trial) {
  DelaySums sums;
  sums.subject = trial.subject;
  sums.sample_s = 1 / trial.rate_hz;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    sums.xx[axis].assign(delay_lags, 0);
    sums.xq[axis].assign(delay_lags, Vec3::Zero());
  }
  return sums;
}

/// Where the force ratio has settled after a rupture: k samples over which it falls by more than its noise
/// are followed by k + 1 more. A sensor that takes some samples to show a drop still falls while the finger
/// moves on, as if the force came before the position. Where the drop takes one sample, it is the rupture
/// itself.
std::size_t settled_after(const MeasuredTrial& trial, const StickSegments& segments, std::size_t rupture) {
  constexpr double deviations = 3;
  const std::size_t last = rupture + static_cast<std::size_t>(segments.half_window);
  std::size_t end = rupture;
  while (end < last && end + 1 < trial.force_ratio.size() && !segments.begins_run[end + 1] &&
         trial.force_ratio[end].norm() - trial.force_ratio[end + 1].norm() >
             deviations * ratio_noise_at(trial, segments, end))
    ++end;
  return end == rupture ? rupture : 2 * end - rupture + 1;
}

/// Whether most of a trial's ruptures fall on so: then it is the sensor, and else a rupture that was not
/// seen.
bool sensor_smears_ruptures(const MeasuredTrial& trial, const StickSegments& segments) {
  long ruptures = 0, lasting = 0;
  for (std::size_t i = 0; i < segments.is_rupture.size(); ++i) {
    if (!segments.is_rupture[i]) continue;
    ++ruptures;
    lasting += settled_after(trial, segments, i) > i ? 1 : 0;
  }
  return 2 * lasting > ruptures;
}

/// What is surely stick.
std::vector<PhaseStretch> inner_stretches(const MeasuredTrial& trial, const StickSegments& segments) {
  const bool smears = sensor_smears_ruptures(trial, segments);
  std::vector<PhaseStretch> found;
  for (const PhaseStretch& whole : phase_stretches(segments, PadPhase::stick)) {
    PhaseStretch stretch = inner_stretch(whole, segments);
    if (smears && segments.is_rupture[whole.from]) stretch.from = settled_after(trial, segments, whole.from);
    if (stretch.from < stretch.to) found.push_back(stretch);
  }
  return found;
}

}  // namespace

DelaySums delay_sums(const MeasuredTrial& trial, const StickSegments& segments) {
  DelaySums sums = no_sums(trial);
  for (const PhaseStretch& stretch : inner_stretches(trial, segments))
    add_stretch(trial, segments, stretch, sums);
  return sums;
}

std::vector<DelaySums> delay_sums_by_part(const MeasuredTrial& trial, const StickSegments& segments) {
  constexpr std::size_t most_parts = 12;
  const std::vector<PhaseStretch> stretches = inner_stretches(trial, segments);
  std::size_t samples = 0, before = 0;
  for (const PhaseStretch& stretch : stretches) samples += stretch.to - stretch.from;
  std::vector<DelaySums> parts(most_parts, no_sums(trial));
  for (const PhaseStretch& stretch : stretches) {
    add_stretch(trial, segments, stretch, parts[most_parts * before / samples]);
    before += stretch.to - stretch.from;
  }
  std::erase_if(parts, [](const DelaySums& part) { return part.samples == 0; });
  return parts;
}

DelaySums& DelaySums::operator+=(const DelaySums& other) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    for (std::size_t k = 0; k < delay_lags; ++k) {
      xx[axis][k] += other.xx[axis][k];
      xq[axis][k] += other.xq[axis][k];
    }
    spring[axis] += other.spring[axis];
  }
  noise_m2 += other.noise_m2;
  samples += other.samples;
  return *this;
}

void shift_positions(RecordedTrial& trial, double delay_s) {
  const Eigen::Index n = trial.samples(), whole = std::lround(delay_s * trial.rate_hz);
  const double rest = delay_s * trial.rate_hz - static_cast<double>(whole);
  const Eigen::Index half = slope_half_window(trial.rate_hz);
  double squares = 0;
  for (Eigen::Index k = -half; k <= half; ++k) squares += static_cast<double>(k * k);
  const Points before = trial.position_W;
  const std::vector<SampleOrigin> origin = trial.origin;
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index from = std::clamp<Eigen::Index>(i - whole, 0, n - 1);
    Vec3 step = Vec3::Zero();  // per sample, the slope of the positions around
    if (from >= half && from + half < n) {
      for (Eigen::Index k = 1; k <= half; ++k)
        step += static_cast<double>(k) / squares * (before.col(from + k) - before.col(from - k));
    }
    trial.position_W.col(i) = before.col(from) - rest * step;
    if (from != i - whole) trial.origin[static_cast<std::size_t>(i)] = SampleOrigin::missing;
    trial.origin[static_cast<std::size_t>(i)] =
        std::max(trial.origin[static_cast<std::size_t>(i)], origin[static_cast<std::size_t>(from)]);
  }
}

}  // namespace fingerpad
