#include "study/spring_sums.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "friction/stick_spring.hpp"
#include "study/phase_stretch.hpp"
#include "study/sample_noise.hpp"

namespace fingerpad {
namespace {

using Terms = SpringTerms;
using Bends = std::array<SpringBend, 2>;

constexpr std::size_t fewest_groups = 3;

/// Variance of the sensors' noise on each component, told in stick: in slip the pad vibrates.
struct SpringNoise {
  Vec2 position_m2{0, 0}, ratio2{0, 0};
};

SpringNoise noise_in_stick(const MeasuredTrial& trial, const std::vector<PhaseStretch>& stretches,
                           const std::vector<Vec2>& ratio) {
  SpringNoise noise;
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    std::vector<double> positions, ratios;
    const auto bend = [axis](const std::vector<Vec2>& of, std::size_t i) {
      return std::abs(of[i][axis] - 2 * of[i - 1][axis] + of[i - 2][axis]);
    };
    for (const PhaseStretch& s : stretches) {
      for (std::size_t i = s.from + 2; i < s.to; ++i) {
        positions.push_back(bend(trial.position_m, i));
        ratios.push_back(bend(ratio, i));
      }
    }
    noise.position_m2[axis] = std::pow(noise_of_bends(positions), 2);
    noise.ratio2[axis] = std::pow(noise_of_bends(ratios), 2);
  }
  return noise;
}

/// Which way the finger goes at a sample: over a window that is wide enough for a slow finger's noise.
class MotionDirection {
 public:
  MotionDirection(const MeasuredTrial& trial, int half_window)
      : trial_(trial),
        reach_(static_cast<std::size_t>(4 * half_window)),
        sums_(trial.position_m.size() + 1, Vec2(0, 0)) {
    for (std::size_t i = 0; i < trial.position_m.size(); ++i)
      sums_[i + 1] = sums_[i] + trial.position_m[i] - trial.position_m.front();
  }

  /// Unit; zero where the finger does not move.
  Vec2 at(std::size_t i) const {
    std::size_t reach = 0;
    while (reach < reach_ && i > reach && i + reach < trial_.position_m.size() &&
           !trial_.starts_anew[i - reach] && (reach == 0 || !trial_.starts_anew[i + reach]))
      ++reach;
    if (reach == 0) return {0, 0};
    const Vec2 way = sums_[i + reach] - 2 * sums_[i] + sums_[i - reach];
    return way.norm() > 0 ? Vec2(way.normalized()) : Vec2(0, 0);
  }

 private:
  const MeasuredTrial& trial_;
  std::size_t reach_;
  std::vector<Vec2> sums_;
};

/// Means over a group of samples, per axis the terms of the spring.
std::array<Terms, 2> group_terms(const MeasuredTrial& trial, const StickSegments& segments,
                                 const std::vector<Vec2>& ratio, const MotionDirection& direction,
                                 const Bends& bends, double longer, std::size_t from, std::size_t to) {
  Vec2 x(0, 0), r(0, 0), v(0, 0);
  const auto count = static_cast<double>(to - from);
  for (std::size_t i = from; i < to; ++i) {
    x += trial.position_m[i] / count;
    r -= ratio[i] / count;
    v += segments.velocity_m_per_s[i] / count;
  }
  const Vec2 along = direction.at((from + to) / 2);
  std::array<Terms, 2> terms;
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    const Vec2 spring = longer * r[axis] * bends[k].at(r.norm());
    terms[k] << x[axis], spring[0], spring[1], along[axis], v[axis], longer * r[axis];
  }
  return terms;
}

/// EvidencePoint::axes_at the mean load of a group.
double mean_longer(const MeasuredTrial& trial, const EvidencePoint& about, std::size_t from, std::size_t to) {
  if (about.axes_exponent == 0) return 1;
  double sum_n = 0;
  for (std::size_t i = from; i < to; ++i) sum_n += trial.normal_force_n[i];
  return about.axes_at(sum_n / static_cast<double>(to - from));
}

/// How hard a group of a stretch is pulled. One of a single sample is told by the samples beside it: did its
/// own noise tell, those would be chosen that it makes less of, and the spring would seem softer far out.
double pull_of(const std::vector<Vec2>& ratio, const PhaseStretch& stretch, std::size_t from, std::size_t to,
               int half_window) {
  const std::size_t reach =
      to - from > 1 ? 0
                    : std::min({static_cast<std::size_t>(half_window), from - stretch.from, stretch.to - to});
  Vec2 sum(0, 0);
  for (std::size_t k = 1; k <= reach; ++k) sum += ratio[from - k] + ratio[to - 1 + k];
  if (reach > 0) return sum.norm() / static_cast<double>(2 * reach);
  for (std::size_t i = from; i < to; ++i) sum += ratio[i];
  return sum.norm() / static_cast<double>(to - from);
}

/// What the groups' means keep of the noise, to first order in it.
SpringSums noise_sums(const SpringGroups& groups, std::size_t axis, const SpringNoise& noise,
                      const SpringBend& bend) {
  SpringSums sums = SpringSums::Zero();
  const auto count = static_cast<double>(groups.terms.size());
  const double share = (1 - 1 / count) / static_cast<double>(groups.size);
  const auto own = static_cast<Eigen::Index>(axis);
  const Vec2 ratio2(noise.ratio2[own], noise.ratio2[1 - own]);
  sums(spring_position, spring_position) += count * share * noise.position_m2[own];
  for (std::size_t k = 0; k < groups.terms.size(); ++k) {
    const auto& terms = groups.terms[k];
    const double longer = groups.longer[k], longer2_share = longer * longer * share;
    const Eigen::Matrix2d slopes = spring_slopes(
        bend, {terms[axis][spring_straight] / longer, terms[1 - axis][spring_straight] / longer});
    sums(spring_straight, spring_straight) += longer2_share * ratio2[0];
    sums.block<2, 2>(spring_ratio, spring_ratio) +=
        longer2_share * slopes * ratio2.asDiagonal() * slopes.transpose();
    const Vec2 with_straight = longer2_share * ratio2[0] * slopes.col(0);
    sums.block<2, 1>(spring_ratio, spring_straight) += with_straight;
    sums.block<1, 2>(spring_straight, spring_ratio) += with_straight.transpose();
  }
  return sums;
}

/// Adds a stretch's groups: their products about their means, without what noise makes of them.
void add_groups(const SpringGroups& groups, const SpringNoise& noise, const Bends& bends,
                TrialEvidence& evidence) {
  const auto count = static_cast<double>(groups.terms.size()), weight = static_cast<double>(groups.size);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    Terms mean = Terms::Zero();
    for (const auto& terms : groups.terms) mean += terms[axis] / count;
    SpringSums sums = SpringSums::Zero();
    for (const auto& terms : groups.terms) sums += (terms[axis] - mean) * (terms[axis] - mean).transpose();
    const SpringSums noisy = noise_sums(groups, axis, noise, bends[axis]);
    evidence.spring[axis] += weight * (sums - noisy);
    evidence.spring_noise[axis] += weight * noisy;
  }
  evidence.stick_samples += static_cast<long>(groups.terms.size() * groups.size);
}

/// Adds the loads that a stretch's groups are taken under.
void add_stick_loads(const MeasuredTrial& trial, const SpringGroups& groups, TrialEvidence& evidence) {
  const auto size = static_cast<double>(groups.size);
  std::size_t i = groups.stretch.from;
  for (std::size_t group = 0; group < groups.terms.size(); ++group) {
    double sum_n = 0;
    for (const std::size_t to = i + groups.size; i < to; ++i) sum_n += trial.normal_force_n[i];
    evidence.stick_log_load += size * std::log(sum_n / size);
  }
}

}  // namespace

Vec2 SpringBend::at(double ratio) const noexcept {
  const double c = cubic_share, share = ratio / mu_static;
  if (c == 0 || !(share > 1e-6)) return {1 / (1 - c), (1 - share * share) / (1 - c) / (1 - c)};
  const double rho = cubic_spring_rho(share, c);
  return Vec2(rho, (rho - rho * rho * rho) / (1 - c + 3 * c * rho * rho)) / share;
}

Eigen::Matrix2d spring_slopes(const SpringBend& bend, const Vec2& own_and_other) {
  const double step = 1e-4 * bend.mu_static;
  const auto terms = [&bend](const Vec2& r) -> Vec2 { return r[0] * bend.at(r.norm()); };
  Eigen::Matrix2d slopes;
  for (Eigen::Index k = 0; k < 2; ++k) {
    const Vec2 aside = step * Vec2::Unit(k);
    slopes.col(k) = (terms(own_and_other + aside) - terms(own_and_other - aside)) / (2 * step);
  }
  return slopes;
}

double surest_pull(const TrialEvidence& evidence, const EvidencePoint& about) {
  constexpr double surely = 0.75;
  if (!(about.hidden_stick_ratio > 0)) return std::numeric_limits<double>::infinity();
  if (evidence.slip_samples == 0) return surely * about.hidden_stick_ratio;
  return surely * evidence.slip_ratio / static_cast<double>(evidence.slip_samples);
}

std::vector<SpringGroups> spring_groups(const MeasuredTrial& trial, const StickSegments& segments,
                                        const std::vector<Vec2>& ratio, const SpringChoice& choice) {
  const auto wanted = static_cast<std::size_t>(std::max(1L, std::lround(spring_group_s * trial.rate_hz)));
  const MotionDirection direction(trial, segments.half_window);
  std::vector<SpringGroups> found;
  for (const PhaseStretch& whole : phase_stretches(segments, PadPhase::stick)) {
    const PhaseStretch s = inner_stretch(whole, segments);
    if (s.to - s.from < fewest_groups * std::min<std::size_t>(wanted, 2)) continue;
    const std::size_t size = std::max<std::size_t>(1, std::min(wanted, (s.to - s.from) / fewest_groups));
    SpringGroups groups{{s.from, s.to}, size, {}, {}, size < wanted};
    // Beyond a group that is pulled too much, stick may be another one.
    const auto end_at = [&](std::size_t to) {
      groups.stretch.to = to;
      if (groups.terms.size() >= fewest_groups || std::isinf(choice.most_pull)) found.push_back(groups);
      groups.terms.clear();
      groups.longer.clear();
      groups.stretch.from = to + size;
    };
    for (std::size_t from = s.from; from + size <= s.to; from += size) {
      const double longer = mean_longer(trial, choice.about, from, from + size);
      auto terms =
          group_terms(trial, segments, ratio, direction, choice.about.bend, longer, from, from + size);
      if (pull_of(ratio, s, from, from + size, segments.half_window) > choice.most_pull) {
        end_at(from);
        continue;
      }
      if (choice.about.knows_delay) terms[0][spring_speed] = terms[1][spring_speed] = 0;
      groups.terms.push_back(terms);
      groups.longer.push_back(longer);
    }
    end_at(s.to);
  }
  return found;
}

void add_spring_sums(const MeasuredTrial& trial, const StickSegments& segments,
                     const std::vector<Vec2>& ratio, const EvidencePoint& about, TrialEvidence& evidence) {
  const std::vector<SpringGroups> all =
      spring_groups(trial, segments, ratio, {about, surest_pull(evidence, about)});
  std::vector<PhaseStretch> stretches;
  stretches.reserve(all.size());
  for (const SpringGroups& groups : all) stretches.push_back(groups.stretch);
  const SpringNoise noise = noise_in_stick(trial, stretches, ratio);
  for (const SpringGroups& groups : all) {
    add_groups(groups, noise, about.bend, evidence);
    add_stick_loads(trial, groups, evidence);
  }
}

TrialEvidence spring_evidence(const MeasuredTrial& trial, const StickSegments& segments) {
  TrialEvidence evidence;
  evidence.subject = trial.subject;
  evidence.has_direction = trial.has_direction;
  evidence.inclination_deg = trial.inclination_deg;
  add_spring_sums(trial, segments, trial.force_ratio, {}, evidence);
  return evidence;
}

}  // namespace fingerpad
