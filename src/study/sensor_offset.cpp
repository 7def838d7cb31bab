#include "study/sensor_offset.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>

#include "study/sample_noise.hpp"

namespace fingerpad {
namespace {

/// A trial's offset, and its friction.
struct TrialOffset {
  double offset_n, friction_n;
};

/// Nothing where the trial does not rub to and fro, or its forces do not oppose it.
std::optional<TrialOffset> trial_offset(const MeasuredTrial& trial, const StickSegments& segments) {
  constexpr double fast = 0.5, least_slip = 0.25, least_turned = 0.5, least_explained = 0.8;
  std::vector<double> speeds;
  for (const Vec2& v : segments.velocity_m_per_s) speeds.push_back(v.norm());
  const double least_speed = fast * quantile(speeds, 0.9);
  double count = 0, slips = 0, ff = 0, pp = 0, fp = 0;
  Vec2 f_sum(0, 0), p_sum(0, 0);
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    if (!(speeds[i] > least_speed)) continue;
    // Slip of one way whose friction an offset outweighs passes for none: what is fast counts.
    slips += segments.phase[i] == PadPhase::slip ? 1 : 0;
    const Vec2 f = trial.normal_force_n[i] * trial.force_ratio[i],
               p = trial.normal_force_n[i] / speeds[i] * segments.velocity_m_per_s[i];
    ++count;
    f_sum += f;
    p_sum += p;
    ff += f.squaredNorm();
    pp += p.squaredNorm();
    fp += f.dot(p);
  }
  if (count == 0 || slips < least_slip * count) return std::nullopt;
  const double turned = pp - p_sum.squaredNorm() / count, against = fp - f_sum.dot(p_sum) / count,
               spread = ff - f_sum.squaredNorm() / count;
  if (!(turned > least_turned * pp) || !(against < 0) ||
      !(against * against > least_explained * turned * spread))
    return std::nullopt;
  const double mu = -against / turned;
  return TrialOffset{(f_sum + mu * p_sum).norm() / count, mu * std::sqrt(pp / count)};
}

}  // namespace

SensorOffset sensor_offset(const Measurement& measurement, const std::vector<StickSegments>& segments) {
  constexpr double told_share = 0.05;  // vibration of slip leaves a hundredth
  std::set<std::string> tared;
  for (const TrialCleaning& cleaning : measurement.cleanings)
    if (cleaning.free_samples > 0) tared.insert(cleaning.name);
  SensorOffset found;
  std::vector<double> told_n, offsets_n;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (tared.contains(measurement.trials[i].name)) continue;
    ++found.untared;
    const auto own = trial_offset(measurement.trials[i], segments[i]);
    if (!own) continue;
    ++found.told;
    told_n.push_back(own->offset_n);
    if (own->offset_n > told_share * own->friction_n) offsets_n.push_back(own->offset_n);
  }
  if (!told_n.empty()) found.typical_n = median_of(told_n);
  found.off = offsets_n.size();
  if (found.off == 0) return found;
  found.usual_n = median_of(offsets_n);
  found.most_n = *std::max_element(offsets_n.begin(), offsets_n.end());
  return found;
}

}  // namespace fingerpad
