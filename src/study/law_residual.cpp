#include "study/law_residual.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "study/phase_stretch.hpp"
#include "study/slip_sums.hpp"
#include "study/spring_sums.hpp"

namespace fingerpad {
namespace {

constexpr double near_s = 0.05;

std::size_t group_size(double rate_hz) {
  return static_cast<std::size_t>(std::max(1L, std::lround(spring_group_s * rate_hz)));
}

/// Means of groups of samples of a stretch.
template <typename Value>
std::vector<double> group_means(const PhaseStretch& s, std::size_t size, const Value& value) {
  std::vector<double> means;
  for (std::size_t from = s.from; from + size <= s.to; from += size) {
    double sum = 0;
    for (std::size_t i = from; i < from + size; ++i) sum += value(i);
    means.push_back(sum / static_cast<double>(size));
  }
  return means;
}

/// Variance of a component's force noise, which is alike at every load, from that of the ratio.
double force_noise_n2(const MeasuredTrial& trial, const StickSegments& segments) {
  constexpr double light = 0.3;  // noisier samples count as events to the ratio's noise
  double inverse2 = 0, samples = 0;
  for (const double load_n : trial.normal_force_n) {
    if (load_n < light * segments.usual_normal_n) continue;
    inverse2 += 1 / (load_n * load_n);
    ++samples;
  }
  return segments.ratio_noise * segments.ratio_noise * samples / inverse2;
}

/// The mean of 1/n^2 over a group.
double mean_inverse_load2(const MeasuredTrial& trial, const SpringGroups& groups, std::size_t group) {
  const std::size_t from = groups.stretch.from + group * groups.size;
  double sum = 0;
  for (std::size_t i = from; i < from + groups.size; ++i)
    sum += 1 / (trial.normal_force_n[i] * trial.normal_force_n[i]);
  return sum / static_cast<double>(groups.size);
}

/// A trial's own spring along one axis.
struct OwnSpring {
  const SpringBend& bend;
  const SpringShape& shape;
  double compliance_m;
  std::size_t axis;
};

/// What a spring leaves of a stretch, by group.
struct StretchLeft {
  std::vector<double> ratio;    ///< of the force ratio
  std::vector<double> slope_m;  ///< the spring's way for a unit of force ratio there
};

/// The stick centre is where the spring leaves least of the force ratio.
StretchLeft left_of_stretch(const SpringGroups& groups, const OwnSpring& own) {
  StretchLeft left;
  std::vector<double> way_m;
  double centre_m = 0, weights = 0;
  for (std::size_t k = 0; k < groups.terms.size(); ++k) {
    const auto& both = groups.terms[k];
    const SpringTerms& terms = both[own.axis];
    const double longer = groups.longer[k];
    const Eigen::Vector2d slopes = spring_slopes(own.bend, {terms[spring_straight] / longer,
                                                            both[1 - own.axis][spring_straight] / longer})
                                       .col(0);
    constexpr double least_slope = 0.1;  // of a straight spring's; a bend that does not hold may come to less
    left.slope_m.push_back(longer * own.compliance_m *
                           std::max(least_slope, slopes[0] + own.shape.share_left * slopes[1]));
    way_m.push_back(terms[spring_position] -
                    own.compliance_m * (terms[spring_ratio] + own.shape.share_left * terms[spring_cubic]) -
                    own.shape.hysteresis_m * terms[spring_direction] -
                    own.shape.delay_s * terms[spring_speed]);
    const double weight = 1 / (left.slope_m.back() * left.slope_m.back());
    centre_m += weight * way_m.back();
    weights += weight;
  }
  centre_m /= weights;
  for (std::size_t k = 0; k < way_m.size(); ++k)
    left.ratio.push_back((way_m[k] - centre_m) / left.slope_m[k]);
  return left;
}

ResidualPart stick_residual(const MeasuredTrial& trial, const StickSegments& segments,
                            const TrialEvidence& evidence, const LawSpring& spring,
                            const std::vector<Vec2>& ratio, double most_pull) {
  ResidualPart part;
  const double force2 = force_noise_n2(trial, segments),
               both = evidence.spring[0](spring_straight, spring_straight) +
                      evidence.spring[1](spring_straight, spring_straight);
  const std::vector<SpringGroups> stretches =
      spring_groups(trial, segments, ratio, {spring.about, most_pull});
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const SpringSums& sums = evidence.spring[axis];
    const double compliance_m = spring_compliance_m(sums, spring.shape[axis]);
    if (!(sums(spring_straight, spring_straight) > 0.01 * both) || !(compliance_m > 0)) continue;
    const OwnSpring own{spring.about.bend[axis], spring.shape[axis], compliance_m, axis};
    for (const SpringGroups& groups : stretches) {
      if (groups.is_short) continue;
      const StretchLeft left = left_of_stretch(groups, own);
      double noise2 = 0;
      for (std::size_t k = 0; k < groups.terms.size(); ++k) {
        const double place = segments.position_noise_m / left.slope_m[k];
        noise2 += force2 * mean_inverse_load2(trial, groups, k) + place * place;
        part.left += left.ratio[k] * left.ratio[k];
        part.signal += std::pow(groups.terms[k][axis][spring_straight] / groups.longer[k], 2);
      }
      const auto count = static_cast<double>(groups.terms.size()), size = static_cast<double>(groups.size);
      part.expected += (count - 1) / count * noise2 / size;
      part.samples += static_cast<long>(groups.terms.size() * groups.size);
    }
  }
  return part;
}

ResidualPart slip_residual(const StickSegments& segments, const LawSpring& spring,
                           const std::vector<Vec2>& ratio, double rate_hz, bool hides_teeth) {
  const std::size_t size = group_size(rate_hz),
                    near = static_cast<std::size_t>(std::lround(near_s / spring_group_s));
  std::vector<std::vector<double>> slips;
  double mean = 0, squares = 0, count = 0;
  for (const PhaseStretch& whole : phase_stretches(segments, PadPhase::slip)) {
    PhaseStretch inner = inner_stretch(whole, segments);
    if (spring.leaves_hidden_out || hides_teeth)
      inner = fast_part(inner, segments, spring.about.v_min_m_per_s);
    slips.push_back(group_means(inner, size, [&](std::size_t i) {
      return -ratio[i].dot(segments.velocity_m_per_s[i].normalized());
    }));
    const std::vector<double>& groups = slips.back();
    for (std::size_t k = near; k + near < groups.size(); ++k) {
      mean += groups[k];
      squares += groups[k] * groups[k];
      ++count;
    }
  }
  constexpr double fewest = 20;
  ResidualPart part;
  if (count < fewest) return part;
  mean /= count;
  const double variance = std::max(0.0, squares / count - mean * mean);
  for (const std::vector<double>& groups : slips) {
    if (groups.size() < 2 * near) continue;  // between ruptures, or while it hardly moves
    for (std::size_t k = 0; k < groups.size(); ++k) {
      if (k >= near && k + near < groups.size()) continue;
      part.left += (groups[k] - mean) * (groups[k] - mean);
      part.expected += variance;
      part.signal += groups[k] * groups[k];
      part.samples += static_cast<long>(size);
    }
  }
  return part;
}

}  // namespace

ResidualPart& ResidualPart::operator+=(const ResidualPart& other) noexcept {
  left += other.left;
  expected += other.expected;
  signal += other.signal;
  samples += other.samples;
  return *this;
}

std::vector<Vec2> ratio_at_load(const MeasuredTrial& trial, const MuLoadLaw& load) {
  std::vector<Vec2> ratio = trial.force_ratio;
  if (load.exponent == 0) return ratio;
  for (std::size_t i = 0; i < ratio.size(); ++i)
    ratio[i] *= std::pow(trial.normal_force_n[i] / load.load_n, -load.exponent);
  return ratio;
}

TrialResidual trial_residual(const MeasuredTrial& trial, const StickSegments& segments,
                             const TrialEvidence& evidence, const LawSpring& spring) {
  const std::vector<Vec2> ratio = ratio_at_load(trial, spring.about.load);
  const double surest = surest_pull(evidence, spring.about);
  TrialResidual found;
  found.sure_stick = stick_residual(trial, segments, evidence, spring, ratio, surest);
  found.stick =
      spring.leaves_hidden_out || std::isinf(surest)
          ? found.sure_stick
          : stick_residual(trial, segments, evidence, spring, ratio, std::numeric_limits<double>::infinity());
  found.slip = slip_residual(segments, spring, ratio, trial.rate_hz, evidence.hides_teeth);
  found.gives = evidence.gives;
  found.drops = evidence.drops;
  return found;
}

}  // namespace fingerpad
