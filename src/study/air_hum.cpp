#include "study/air_hum.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "study/sample_noise.hpp"

namespace fingerpad {
namespace {

/// Values less the straight line through them.
Eigen::RowVectorXd without_line(const Eigen::RowVectorXd& values) {
  const Eigen::Index n = values.size();
  const Eigen::RowVectorXd along = Eigen::RowVectorXd::LinSpaced(n, -1, 1);
  const double mean = values.mean(), slope = values.dot(along) / along.squaredNorm();
  return values - Eigen::RowVectorXd::Constant(n, mean) - slope * along;
}

}  // namespace

std::vector<Eigen::Index> lightest_samples(const RecordedTrial& trial, double nominal_hz) {
  constexpr double light = 0.25;  // of the press
  const auto period = std::max<Eigen::Index>(1, std::lround(trial.rate_hz / nominal_hz));
  std::vector<Eigen::Index> found;
  if (trial.samples() <= period) return found;
  std::vector<double> mean_n;
  double sum_n = 0;
  for (Eigen::Index i = 0; i < trial.samples(); ++i) {
    sum_n += trial.normal_W.dot(trial.force_W.col(i));
    if (i + 1 < period) continue;
    mean_n.push_back(sum_n / static_cast<double>(period));
    sum_n -= trial.normal_W.dot(trial.force_W.col(i + 1 - period));
  }
  const double low_n = quantile(mean_n, 0.01), most_n = low_n + light * (quantile(mean_n, 0.9) - low_n);
  for (std::size_t k = 0; k < mean_n.size(); ++k) {
    const Eigen::Index middle = static_cast<Eigen::Index>(k) + period / 2;
    if (mean_n[k] < most_n && trial.origin[static_cast<std::size_t>(middle)] == SampleOrigin::recorded)
      found.push_back(middle);
  }
  return found;
}

AirHum::AirHum(const RecordedTrial& trial, Sensed sensed, const std::vector<Eigen::Index>& free,
               double nominal_hz)
    : rate_hz_(trial.rate_hz) {
  constexpr double fewest_periods = 3;
  const auto shortest = static_cast<std::size_t>(fewest_periods * trial.rate_hz / nominal_hz);
  for (std::size_t from = 0, to = 0; from < free.size(); from = to) {
    to = from + 1;
    while (to < free.size() && free[to] == free[to - 1] + 1) ++to;
    if (to - from < shortest) continue;
    moments_.push_back({samples_.size(), samples_.size() + to - from});
    samples_.insert(samples_.end(), free.begin() + static_cast<std::ptrdiff_t>(from),
                    free.begin() + static_cast<std::ptrdiff_t>(to));
  }
  rest_.resize(3, static_cast<Eigen::Index>(samples_.size()));
  for (const Moment& moment : moments_) {
    const auto from = static_cast<Eigen::Index>(moment.from),
               count = static_cast<Eigen::Index>(moment.to) - from;
    const Points values = (trial.*sensed).middleCols(samples_[moment.from], count);
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      rest_.row(axis).segment(from, count) = without_line(values.row(axis));
  }
  if (moments_.empty()) return;
  const auto middle = [this](const Moment& moment) {
    return static_cast<double>(samples_[moment.from] + samples_[moment.to - 1]) / 2;
  };
  span_s_ = (middle(moments_.back()) - middle(moments_.front())) / rate_hz_;
}

AirHum::Told AirHum::at(double hz, const Moment& moment) const {
  Told told;
  const double turn = 2 * std::numbers::pi * hz / rate_hz_;
  const std::complex<double> step = std::polar(1.0, -turn);
  const auto count = static_cast<double>(moment.to - moment.from);
  std::complex<double> phase = 1;
  for (std::size_t k = moment.from; k < moment.to; ++k) {
    const bool follows = k > moment.from && samples_[k] == samples_[k - 1] + 1;
    phase = follows ? phase * step : std::polar(1.0, -turn * static_cast<double>(samples_[k]));
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      told.phasors[static_cast<std::size_t>(axis)] += rest_(axis, static_cast<Eigen::Index>(k)) * phase;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    told.phasors[axis] *= 2 / count;
    const double own = std::norm(told.phasors[axis]),
                 all = rest_.row(static_cast<Eigen::Index>(axis))
                           .segment(static_cast<Eigen::Index>(moment.from),
                                    static_cast<Eigen::Index>(moment.to - moment.from))
                           .squaredNorm() /
                       count;
    told.variance[axis] = 2 * std::max(all - own / 2, 0.0) / count;
    told.power += own;
  }
  return told;
}

bool AirHum::is_like(const HumLine& line) const {
  constexpr double least_share = 0.1, deviations = 4;
  double off2 = 0, line2 = 0, noise2 = 0;
  // One by one: a frequency that is a little off turns ends of the trial either way.
  for (const Moment& moment : moments_) {
    const Told told = at(line.hz, moment);
    const double share = static_cast<double>(moment.to - moment.from) / static_cast<double>(samples_.size());
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!line.hums[axis]) continue;
      off2 += share * std::norm(told.phasors[axis] - line.phasors[axis]);
      line2 += share * std::norm(line.phasors[axis]);
      noise2 += share * 2 * told.variance[axis];
    }
  }
  return !(off2 > least_share * least_share * line2) || !(off2 > deviations * deviations * noise2);
}

double AirHum::reach_hz() const {
  constexpr double least_span_s = 0.5, farthest_hz = 0.25;
  return span_s_ > least_span_s ? std::min(farthest_hz, 0.5 / span_s_) : 0;
}

std::optional<HumLine> AirHum::bounded(const HumLine& line, double near_hz) const {
  constexpr double stands_out = 5, stands_beside = 3;  // deviations: once for sure, on other axes for likely
  constexpr int steps = 20;
  if (samples_.empty()) return std::nullopt;
  const Moment all{0, samples_.size()};
  const bool tells_hz = reach_hz() > 0;
  double best_hz = line.hz;
  if (tells_hz) {
    const double step_hz = reach_hz() / steps;
    double most = 0;
    for (int k = -steps; k <= steps; ++k) {
      const double hz = near_hz + k * step_hz, power = at(hz, all).power;
      if (power > most) most = power, best_hz = hz;
    }
    const double left = at(best_hz - step_hz, all).power, right = at(best_hz + step_hz, all).power,
                 bend = left - 2 * most + right;
    if (bend < 0) best_hz += std::clamp(0.5 * (left - right) / bend, -1.0, 1.0) * step_hz;
  }
  const Told told = at(best_hz, all);
  HumLine found{line.nominal_hz, best_hz, {}, {}, {}, true};
  bool is_sure = false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double power = std::norm(told.phasors[axis]);
    found.hums[axis] = power > stands_beside * stands_beside * told.variance[axis];
    is_sure = is_sure || power > stands_out * stands_out * told.variance[axis];
    // Where the moments do not tell how it runs on, it is of the whole trial's line, no larger than in the
    // air.
    const double size = std::abs(line.phasors[axis]);
    found.phasors[axis] = tells_hz || size == 0 ? told.phasors[axis]
                                                : line.phasors[axis] * std::min(1.0, std::sqrt(power) / size);
  }
  return is_sure ? std::optional(found) : std::nullopt;
}

}  // namespace fingerpad
