#include "study/delay_estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "study/block_draws.hpp"

namespace fingerpad {
namespace {

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
  std::vector<double> explained = std::vector<double>(delay_lags, 0);
  double all = 0;  ///< of the axes that count

  void add(const ExplainedByLag& other, int times) {
    for (std::size_t k = 0; k < delay_lags; ++k) explained[k] += times * other.explained[k];
    all += times * other.all;
  }
  double left() const { return all - *std::max_element(explained.begin(), explained.end()); }
};

ExplainedByLag explained_of(const DelaySums& trial, SpringOrder order) {
  ExplainedByLag found;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const std::vector<double>& xx = trial.xx[axis];
    const std::vector<Vec3>& xq = trial.xq[axis];
    const SpringExplains explains(trial.spring[axis], order);
    // An axis that hardly moves at some lag would seem to explain anything there.
    if (!(*std::min_element(xx.begin(), xx.end()) > 4 * trial.noise_m2)) continue;
    found.all += trial.spring[axis](0, 0);
    for (std::size_t k = 0; k < delay_lags; ++k)
      if (xq[k][0] < 0) found.explained[k] += explains.of(xq[k]) / xx[k];
  }
  return found;
}

/// Asks draws of blocks for the lag that explains most. Trials that are blocks themselves explain alike in
/// every draw; one of several parts has a spring of its own for those that are drawn.
class LagSearch {
 public:
  LagSearch(const DelayBlocks& blocks, SpringOrder order) : blocks_(blocks), order_(order) {
    for (std::size_t i = 0; i < blocks.sums.size(); ++i) {
      const bool is_whole = (i == 0 || blocks.trial[i - 1] != blocks.trial[i]) &&
                            (i + 1 == blocks.sums.size() || blocks.trial[i + 1] != blocks.trial[i]);
      whole_.push_back(is_whole ? std::optional(explained_of(blocks.sums[i], order)) : std::nullopt);
    }
  }

  ExplainedByLag explained(const std::vector<int>& times) const {
    ExplainedByLag all;
    for (std::size_t from = 0, to = 0; from < times.size(); from = to) {
      to = from + 1;
      if (whole_[from]) {
        if (times[from] > 0) all.add(*whole_[from], times[from]);
        continue;
      }
      while (to < times.size() && blocks_.trial[to] == blocks_.trial[from]) ++to;
      if (const auto drawn = drawn_parts(times, from, to)) all.add(explained_of(*drawn, order_), 1);
    }
    return all;
  }

  /// In steps of the grid; nothing where it is at the grid's end.
  std::optional<double> best(const std::vector<int>& times) const {
    const std::vector<double> at = explained(times).explained;
    const auto k = static_cast<std::size_t>(std::max_element(at.begin(), at.end()) - at.begin());
    if (k == 0 || k + 1 == at.size()) return std::nullopt;
    const double bend = at[k - 1] - 2 * at[k] + at[k + 1];
    if (!(bend < 0)) return std::nullopt;
    return static_cast<double>(k) - delay_lags_each_way + 0.5 * (at[k - 1] - at[k + 1]) / bend;
  }

 private:
  /// One trial's sums, of its parts that were drawn.
  std::optional<DelaySums> drawn_parts(const std::vector<int>& times, std::size_t from,
                                       std::size_t to) const {
    std::optional<DelaySums> sum;
    for (std::size_t i = from; i < to; ++i) {
      for (int count = 0; count < times[i]; ++count) {
        if (sum) *sum += blocks_.sums[i];
        if (!sum) sum = blocks_.sums[i];
      }
    }
    return sum;
  }

  const DelayBlocks& blocks_;
  SpringOrder order_;
  std::vector<std::optional<ExplainedByLag>> whole_;
};

/// A higher one where it leaves much less of q: where it is only free, ends of stick bend it, and the delay
/// with it.
SpringOrder spring_order_of(const DelayBlocks& blocks) {
  constexpr double much_less = 0.5;
  const std::vector<int> once(blocks.sums.size(), 1);
  const auto left = [&](SpringOrder order) { return LagSearch(blocks, order).explained(once).left(); };
  const double third = left(SpringOrder::third);
  if (!(third < much_less * left(SpringOrder::first))) return SpringOrder::first;
  return left(SpringOrder::fifth) < much_less * third ? SpringOrder::fifth : SpringOrder::third;
}

}  // namespace

void DelayBlocks::add(std::vector<DelaySums> of_trial) {
  const int number = trial.empty() ? 0 : trial.back() + 1;
  for (DelaySums& own : of_trial) {
    if (own.samples == 0) continue;
    trial.push_back(number);
    group.push_back(are_parts ? number : own.subject);
    sums.push_back(std::move(own));
  }
}

bool DelayBlocks::tell_spread() const {
  const std::set<int> groups(group.begin(), group.end());
  return static_cast<double>(sums.size()) - static_cast<double>(groups.size()) >= least_freedom;
}

DelayEstimate estimate_delay(const DelayBlocks& blocks, std::uint64_t seed) {
  constexpr long fewest = 200;
  constexpr int draws = 200;
  constexpr double most_unsure_s = 5e-3, most_missing = 0.05;
  DelayEstimate estimate;
  for (const DelaySums& block : blocks.sums) {
    estimate.samples += block.samples;
    estimate.sample_s = std::max(estimate.sample_s, block.sample_s);
  }
  const std::set<int> trials(blocks.trial.begin(), blocks.trial.end()),
      groups(blocks.group.begin(), blocks.group.end());
  estimate.trials = static_cast<long>(trials.size());
  estimate.by_parts = blocks.are_parts;
  if (estimate.samples < fewest) {
    estimate.refusal = "too little stick in which force follows position";
    return estimate;
  }
  const LagSearch search(blocks, spring_order_of(blocks));
  const auto lag = search.best(std::vector<int>(blocks.sums.size(), 1));
  if (!lag) {
    estimate.refusal =
        "no lag within 50 ms explains the forces best, and one that is longer is not looked for";
    return estimate;
  }
  estimate.delay_s = *lag * delay_step_s;
  DrawSpread spread;
  RandomStream random(seed, 1);
  for (int draw = 0; draw < draws; ++draw) {
    if (const auto drawn = search.best(drawn_times(blocks.group, Blocks::trials, random)))
      spread.add(*drawn * delay_step_s);
  }
  LeftOutSpread without;
  const std::size_t left_out = each_left_out(blocks.group, Blocks::trials, [&](const LeftOut& one) {
    if (const auto lag_left = search.best(one.times)) without.add(one, *lag_left * delay_step_s);
  });
  // What ends of stick that count as stick move all trials alike.
  constexpr double unsure_samples = 0.05;
  estimate.unsure_s = unsure_samples * std::max(estimate.sample_s, delay_step_s);
  const auto count = static_cast<double>(blocks.sums.size()), of = static_cast<double>(groups.size());
  const double drawn = interval_reach(spread, without.deviation(left_out), count, of);
  if (!(drawn > 0) || spread.count < (1 - most_missing) * draws) {
    estimate.refusal =
        drawn > 0 ? "with others drawn of these trials (or of their stick) no lag within 50 ms explains the "
                    "forces best"
                  : "too few stretches of stick tell it to say how far it may be off";
    return estimate;
  }
  const double reach = drawn + estimate.unsure_s;
  estimate.interval_s = {estimate.delay_s - reach, estimate.delay_s + reach};
  // Of few blocks, the jackknife has those without the one that tells it.
  const double drawn_s = interval_reach(spread, std::nullopt, count, of);
  if (drawn_s > most_unsure_s)
    estimate.refusal = fmt::format("the trials tell it to -+ {:.0f} ms only, and to {:.0f} ms is needed",
                                   std::ceil(1e3 * drawn_s), 1e3 * most_unsure_s);
  return estimate;
}

}  // namespace fingerpad
