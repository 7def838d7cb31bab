#include "study/position_delay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "study/block_draws.hpp"
#include "study/phase_stretch.hpp"

namespace fingerpad {
namespace {

constexpr std::size_t lags = 2 * std::size_t{delay_lags_each_way} + 1;

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

/// How many of q, q |q|^2 and q |q|^4 a spring has.
enum class SpringOrder : Eigen::Index { first = 1, third = 2, fifth = 3 };

/// How much of a position's spread a spring explains, times that of q.
class SpringExplains {
 public:
  /// @param spring  DelaySums::spring of an axis
  SpringExplains(const Mat3& spring, SpringOrder order) : qq_(spring(0, 0)) {
    constexpr double least_own = 1e-3;  // else a term says nothing beside those before it
    for (Eigen::Index term = 0; term < static_cast<Eigen::Index>(order); ++term) {
      Vec3 rest = Vec3::Unit(term);
      for (const OwnTerm& before : terms_)
        rest -= before.of.dot(spring.col(term)) / before.spread * before.of;
      const double spread = rest.dot(spring * rest);
      if (term == 0 || spread > least_own * spring(term, term)) terms_.push_back({rest, spread});
    }
  }
  /// @param xq  DelaySums::xq of that axis at a lag
  double of(const Vec3& xq) const {
    double explained = 0;
    for (const OwnTerm& term : terms_) explained += std::pow(term.of.dot(xq), 2) / term.spread;
    return qq_ * explained;
  }

 private:
  /// What a term has that those before it have not.
  struct OwnTerm {
    Vec3 of;
    double spread;
  };
  double qq_;
  std::vector<OwnTerm> terms_;
};

/// How much of q the springs explain at each lag, and how much there is of it.
struct ExplainedByLag {
  std::vector<double> explained;
  double all = 0;  ///< of the axes that count
};

ExplainedByLag explained_by_lag(const std::vector<DelaySums>& trials, const std::vector<int>& times,
                                SpringOrder order) {
  ExplainedByLag found{std::vector<double>(lags, 0)};
  for (std::size_t i = 0; i < trials.size(); ++i) {
    if (times[i] == 0 || trials[i].samples == 0) continue;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const std::vector<double>& xx = trials[i].xx[axis];
      const std::vector<Vec3>& xq = trials[i].xq[axis];
      const SpringExplains explains(trials[i].spring[axis], order);
      // An axis that hardly moves at some lag would seem to explain anything there.
      if (!(*std::min_element(xx.begin(), xx.end()) > 4 * trials[i].noise_m2)) continue;
      found.all += times[i] * trials[i].spring[axis](0, 0);
      for (std::size_t k = 0; k < lags; ++k)
        if (xq[k][0] < 0) found.explained[k] += times[i] * explains.of(xq[k]) / xx[k];
    }
  }
  return found;
}

/// The lag that explains most, in steps of the grid; nothing where that is at the grid's end.
std::optional<double> best_lag(const std::vector<DelaySums>& trials, const std::vector<int>& times,
                               SpringOrder order) {
  const std::vector<double> explained = explained_by_lag(trials, times, order).explained;
  const auto k =
      static_cast<std::size_t>(std::max_element(explained.begin(), explained.end()) - explained.begin());
  if (k == 0 || k + 1 == explained.size()) return std::nullopt;
  const double bend = explained[k - 1] - 2 * explained[k] + explained[k + 1];
  if (!(bend < 0)) return std::nullopt;
  return static_cast<double>(k) - delay_lags_each_way + 0.5 * (explained[k - 1] - explained[k + 1]) / bend;
}

/// A higher one where it leaves much less of q: where it is only free, ends of stick bend it, and the delay
/// with it.
SpringOrder spring_order_of(const std::vector<DelaySums>& trials) {
  constexpr double much_less = 0.5;
  const std::vector<int> once(trials.size(), 1);
  const auto left = [&](SpringOrder order) {
    const ExplainedByLag found = explained_by_lag(trials, once, order);
    return found.all - *std::max_element(found.explained.begin(), found.explained.end());
  };
  const double third = left(SpringOrder::third);
  if (!(third < much_less * left(SpringOrder::first))) return SpringOrder::first;
  return left(SpringOrder::fifth) < much_less * third ? SpringOrder::fifth : SpringOrder::third;
}

}  // namespace

DelaySums delay_sums(const MeasuredTrial& trial, const StickSegments& segments) {
  DelaySums sums;
  sums.subject = trial.subject;
  sums.sample_s = 1 / trial.rate_hz;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    sums.xx[axis].assign(lags, 0);
    sums.xq[axis].assign(lags, Vec3::Zero());
  }
  for (const PhaseStretch& whole : phase_stretches(segments, PadPhase::stick)) {
    const PhaseStretch stretch = inner_stretch(whole, segments);
    if (stretch.from < stretch.to) add_stretch(trial, segments, stretch, sums);
  }
  return sums;
}

DelayEstimate estimate_delay(const std::vector<DelaySums>& trials, std::uint64_t seed) {
  constexpr long fewest = 200;
  constexpr int draws = 200;
  constexpr double most_unsure_s = 5e-3;
  DelayEstimate estimate;
  std::vector<int> subject_of;
  std::set<int> subjects;
  double blocks = 0;
  for (const DelaySums& trial : trials) {
    subject_of.push_back(trial.subject);
    estimate.samples += trial.samples;
    if (trial.samples == 0) continue;
    ++blocks;
    subjects.insert(trial.subject);
    estimate.sample_s = std::max(estimate.sample_s, trial.sample_s);
  }
  const SpringOrder order = spring_order_of(trials);
  const auto lag = best_lag(trials, std::vector<int>(trials.size(), 1), order);
  if (estimate.samples < fewest || !lag) {
    estimate.refusal = estimate.samples < fewest
                           ? "too little stick in which force follows position"
                           : "no lag within 50 ms explains the forces best, and one that is longer is "
                             "not looked for";
    return estimate;
  }
  estimate.delay_s = *lag * delay_step_s;
  DrawSpread spread;
  RandomStream random(seed, 1);
  for (int draw = 0; draw < draws; ++draw) {
    if (const auto drawn = best_lag(trials, drawn_times(subject_of, Blocks::trials, random), order))
      spread.add(*drawn * delay_step_s);
  }
  LeftOutSpread without;
  const std::size_t left_out = each_left_out(subject_of, Blocks::trials, [&](const LeftOut& one) {
    if (const auto lag_left = best_lag(trials, one.times, order)) without.add(one, *lag_left * delay_step_s);
  });
  // What ends of stick that count as stick move all trials alike.
  constexpr double unsure_samples = 0.05;
  estimate.unsure_s = unsure_samples * std::max(estimate.sample_s, delay_step_s);
  const auto groups = static_cast<double>(subjects.size());
  const double drawn = interval_reach(spread, without.deviation(left_out), blocks, groups);
  const double reach = drawn > 0 ? drawn + estimate.unsure_s : 0;
  if (!(reach > 0) || spread.count < 0.95 * draws) return estimate;
  estimate.interval_s = {estimate.delay_s - reach, estimate.delay_s + reach};
  // Of few trials, the jackknife has those without the one that tells it.
  const double drawn_s = interval_reach(spread, std::nullopt, blocks, groups);
  if (drawn_s > most_unsure_s)
    estimate.refusal = fmt::format("the trials tell it to -+ {:.0f} ms only, and to {:.0f} ms is needed",
                                   std::ceil(1e3 * drawn_s), 1e3 * most_unsure_s);
  return estimate;
}

void shift_positions(RecordedTrial& trial, double delay_s) {
  const Eigen::Index n = trial.samples(), whole = std::lround(delay_s * trial.rate_hz);
  const double rest = delay_s * trial.rate_hz - static_cast<double>(whole);
  const Eigen::Index half = std::max<Eigen::Index>(3, std::lround(6e-3 * trial.rate_hz));
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
