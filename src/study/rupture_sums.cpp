#include "study/rupture_sums.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "study/position_parabola.hpp"
#include "study/spring_sums.hpp"

namespace fingerpad {
namespace {

constexpr std::size_t fewest = 5;  // samples of a line

/// Whether the teeth of a finger that moves on so have enough samples, wherever between two of them each
/// gives way: did the tooth's own number decide, those that give way late would be kept.
/// @param tooth_m  the spring's way from where it is entered to where it gives way; a bent spring's is soft
///                 in its beginning, so that its stiffness at the end would make it too short
/// @param step_m   the finger's from sample to sample
bool has_long_teeth(double tooth_m, double step_m) {
  return tooth_m >= static_cast<double>(fewest) * step_m;
}

/// How far springs give way along a direction, for a unit of the force ratio.
class GivingWay {
 public:
  GivingWay(const std::array<SpringBend, 2>& bend, const Vec2& forward) : bend_(bend), forward_(forward) {}

  double at(double ratio) const {
    return forward_.x() * forward_.x() * bend_[0].at(ratio)[0] +
           forward_.y() * forward_.y() * bend_[1].at(ratio)[0];
  }
  /// The ratio at which they have given way so far: a straight spring's is the way itself.
  double ratio_of(double way) const {
    constexpr int passes = 50;
    double least = 0, most = 1;
    while (most * at(most) < way && most < 1e3) most *= 2;
    for (int pass = 0; pass < passes; ++pass) {
      const double middle = (least + most) / 2;
      (middle * at(middle) < way ? least : most) = middle;
    }
    return (least + most) / 2;
  }

 private:
  const std::array<SpringBend, 2>& bend_;
  Vec2 forward_;
};

/// |q| where stick gives way. The spring's own way at the last samples is a line over the finger's, which is
/// taken on to half a sample after the last: of a bent spring the ratio itself is none. The finger's way is
/// the parabola through the positions around, so that their noise does not flatten the line; what the noise
/// of q adds to its length on the average is taken off.
std::optional<double> ratio_at_rupture(const MeasuredTrial& trial, const StickSegments& segments,
                                       const std::vector<Vec2>& ratio, const std::array<SpringBend, 2>& bend,
                                       std::size_t i) {
  constexpr std::size_t most = 8;
  std::size_t from = i - 1;
  const auto half = static_cast<std::size_t>(segments.half_window);
  while (from > 0 && i - from < most + half && !segments.begins_run[from] &&
         segments.phase[from - 1] == PadPhase::stick)
    --from;
  if (!segments.begins_run[from]) from += half;  // slip before it may reach so far
  from = std::max(from, i > most ? i - most : 0);
  if (i < from + fewest || !(segments.velocity_m_per_s[i].norm() > 0)) return std::nullopt;
  const auto way = position_parabola(trial, i, 2 * static_cast<std::size_t>(segments.half_window),
                                     segments.velocity_m_per_s[i].normalized());
  if (!way) return std::nullopt;
  const auto count = static_cast<double>(i - from);
  const auto way_at = [&](double j) { return way->at(j - static_cast<double>(i)); };
  const GivingWay spring(bend, segments.velocity_m_per_s[i].normalized());
  const auto given_at = [&](std::size_t j) -> Vec2 { return spring.at(ratio[j].norm()) * ratio[j]; };
  Vec2 mean_q(0, 0), slope(0, 0);
  double mean_s = 0, squares = 0;
  for (std::size_t j = from; j < i; ++j) {
    mean_q += given_at(j) / count;
    mean_s += way_at(static_cast<double>(j)) / count;
  }
  for (std::size_t j = from; j < i; ++j) {
    const double off = way_at(static_cast<double>(j)) - mean_s;
    squares += off * off;
    slope += off * (given_at(j) - mean_q);
  }
  if (!(squares > 0)) return std::nullopt;
  slope /= squares;
  const double ahead = way_at(static_cast<double>(i) - 0.5) - mean_s;
  const Vec2 at_rupture = mean_q + ahead * slope;
  if (!(slope.dot(at_rupture) > 0)) return std::nullopt;  // not pulled until then
  const double variance = segments.ratio_noise * segments.ratio_noise * (1 / count + ahead * ahead / squares),
               pull = spring.ratio_of(at_rupture.norm());
  return pull - variance / (2 * pull);
}

}  // namespace

void add_rupture_sums(const MeasuredTrial& trial, const StickSegments& segments,
                      const std::vector<Vec2>& ratio, const EvidencePoint& about, TrialEvidence& evidence) {
  const std::array<SpringBend, 2>& bend = about.bend;
  for (std::size_t i = 2; i < ratio.size(); ++i) {
    const Vec2& velocity = segments.velocity_m_per_s[i];
    if (!segments.is_rupture[i] || !(velocity.norm() > 0)) continue;
    const Vec2 forward = velocity.normalized();
    const double before = ratio[i - 1].norm(), after = ratio[i].norm(),
                 step_m = velocity.norm() / trial.rate_hz;
    const double rise = spring_stiffness_per_m(evidence, bend, forward, before) * step_m;
    // Of the pad's tooth, once it is known: of its own, those would be kept that noise makes long.
    const bool knows_tooth = about.mu_static > 0 && evidence.slip_samples > 0;
    const double top = knows_tooth ? about.mu_static : before,
                 foot =
                     knows_tooth ? evidence.slip_ratio / static_cast<double>(evidence.slip_samples) : after;
    const double tooth_m =
        spring_way_m(evidence, bend, forward, top) - spring_way_m(evidence, bend, forward, foot);
    if (rise > 0 && !has_long_teeth(tooth_m, step_m)) {
      ++evidence.short_teeth;
      evidence.short_drop += before - after;
      continue;
    }
    const auto at_rupture = ratio_at_rupture(trial, segments, ratio, bend, i);
    if (!at_rupture) continue;
    evidence.rupture_rise += rise;
    evidence.rupture_ratio += *at_rupture;
    evidence.rupture_log_load += std::log(trial.normal_force_n[i - 1]);
    ++evidence.ruptures;
  }
}

}  // namespace fingerpad
