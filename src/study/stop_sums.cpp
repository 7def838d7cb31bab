#include <algorithm>
#include <cmath>
#include <optional>

#include "study/phase_stretch.hpp"
#include "study/position_parabola.hpp"
#include "study/slip_sums.hpp"
#include "study/spring_way.hpp"

namespace fingerpad {
namespace {

/// What the pad does after a stretch of slip, along the motion at its end.
struct SlipStop {
  std::size_t first = 0;  ///< sample of the first
  std::vector<double> way_m, ratio;
  std::vector<double> longer;               ///< EvidencePoint::axes_at
  double slip_ratio = 0, slip_scatter = 0;  ///< mean before it, and the standard deviation
};

/// How far friction strays in all of a trial's slip about each stretch's mean: a standard deviation. A
/// vibration comes and goes, so that the last of one stretch may show little of it.
double trial_scatter_of_slip(const StickSegments& segments, const std::vector<Vec2>& ratio) {
  double squares = 0, samples = 0;
  for (const PhaseStretch& whole : phase_stretches(segments, PadPhase::slip)) {
    const PhaseStretch inner = inner_stretch(whole, segments);
    double sum = 0, sum_2 = 0;
    for (std::size_t i = inner.from; i < inner.to; ++i) {
      const double along = -ratio[i].dot(segments.velocity_m_per_s[i].normalized());
      sum += along;
      sum_2 += along * along;
    }
    const auto count = static_cast<double>(inner.to - inner.from);
    if (count > 0) squares += sum_2 - sum * sum / count;
    samples += count;
  }
  return samples > 0 ? std::sqrt(std::max(0.0, squares / samples)) : 0;
}

/// @param usual_scatter  that slip has at least
SlipStop stop_after(const MeasuredTrial& trial, const StickSegments& segments, const std::vector<Vec2>& ratio,
                    const EvidencePoint& about, const PhaseStretch& slip, const Vec2& forward,
                    double usual_scatter) {
  const auto half = static_cast<std::size_t>(segments.half_window);
  SlipStop stop;
  const std::size_t last = slip.to - half,
                    first = last > slip.from + 20 * half ? last - 20 * half : slip.from;
  for (std::size_t i = first; i < last; ++i)
    stop.slip_ratio -= ratio[i].dot(forward) / static_cast<double>(last - first);
  double square = 0;
  for (std::size_t i = first; i < last; ++i) square += std::pow(ratio[i].dot(forward) + stop.slip_ratio, 2);
  stop.slip_scatter = std::max(usual_scatter, std::sqrt(square / static_cast<double>(last - first)));
  stop.first = last;
  for (std::size_t i = last; i < trial.position_m.size() && i < slip.to + 6 * half; ++i) {
    if (i > slip.from && segments.begins_run[i]) break;
    if (!(segments.velocity_m_per_s[i].dot(forward) > 0)) break;
    stop.way_m.push_back(trial.position_m[i].dot(forward));
    stop.ratio.push_back(-ratio[i].dot(forward));
    stop.longer.push_back(about.axes_at(trial.normal_force_n[i]));
  }
  return stop;
}

/// How much friction is above the trial's in the last of slip, where windows do not reach beyond it.
double rise_before_stop(const StickSegments& segments, const std::vector<Vec2>& ratio,
                        const PhaseStretch& slip, const Vec2& forward, const TrialEvidence& evidence) {
  const auto half = static_cast<std::size_t>(segments.half_window);
  const std::size_t to = slip.to - (3 * half + 1) / 2, reach = 5 * half,
                    from = to > slip.from + reach ? to - reach : slip.from;
  if (evidence.slip_samples == 0) return 0;
  double sum = 0;
  for (std::size_t i = from; i < to; ++i) sum -= ratio[i].dot(forward);
  return sum / static_cast<double>(to - from) -
         evidence.slip_ratio / static_cast<double>(evidence.slip_samples);
}

/// Where along the way slip ended: the rising samples, taken back along the spring.
/// @param spring_m    how far the spring gives way to a ratio, at the load that springs are taken to
/// @param end_longer  SlipStop::longer where slip ended
template <typename Spring>
std::optional<double> end_of_slip_m(const SlipStop& stop, const Spring& spring_m, double end_longer,
                                    double noise) {
  constexpr std::size_t fewest = 3;
  if (stop.ratio.size() < fewest) return std::nullopt;
  const double rise = *std::max_element(stop.ratio.begin(), stop.ratio.end()) - stop.slip_ratio;
  // A pad that vibrates in slip rises, too, and the highest of many samples is some two to three deviations
  // up.
  if (!(rise > 5 * noise) || !(rise > 4 * stop.slip_scatter) || !(rise > 0.15 * stop.slip_ratio))
    return std::nullopt;
  double sum = 0, count = 0;
  for (std::size_t i = stop.ratio.size(); i-- > 0;) {
    const double above = stop.ratio[i] - stop.slip_ratio;
    if (above < 0.25 * rise) break;
    sum +=
        stop.way_m[i] - (stop.longer[i] * spring_m(stop.ratio[i]) - end_longer * spring_m(stop.slip_ratio));
    ++count;
  }
  if (count < fewest) return std::nullopt;
  return sum / count;
}

/// The same where the load is not known at which slip ended: it is that of a sample near there.
template <typename Spring>
std::optional<double> end_of_slip_m(const SlipStop& stop, const Spring& spring_m, double noise) {
  if (stop.longer.empty()) return std::nullopt;
  const auto end_m = end_of_slip_m(stop, spring_m, stop.longer.front(), noise);
  if (!end_m) return std::nullopt;
  std::size_t near = 0;
  while (near + 1 < stop.way_m.size() && stop.way_m[near] < *end_m) ++near;
  return end_of_slip_m(stop, spring_m, stop.longer[near], noise);
}

/// How a finger moves at a place of its way.
struct StopSpeed {
  double speed_m_per_s, slowing_m_per_s;  ///< slowing: from sample to sample; < 0 where it speeds up
  std::size_t sample;                     ///< nearest to it
};

/// At a place of the way, by a parabola through the positions around it.
std::optional<StopSpeed> speed_at_m(const MeasuredTrial& trial, const StickSegments& segments,
                                    const Vec2& forward, std::size_t near, double place_m) {
  const auto half = 2 * static_cast<std::size_t>(segments.half_window);
  const std::size_t count = trial.position_m.size();
  // The sample closest to the place.
  std::size_t middle = near;
  while (middle > 0 && !trial.starts_anew[middle] && trial.position_m[middle].dot(forward) > place_m)
    --middle;
  while (middle + 1 < count && !trial.starts_anew[middle + 1] &&
         trial.position_m[middle].dot(forward) < place_m)
    ++middle;
  const auto way = position_parabola(trial, middle, half, forward);
  if (!way) return std::nullopt;
  double t = 0;
  for (int pass = 0; pass < 5; ++pass) {
    const double slope = way->slope_at(t);
    if (!(slope > 0)) return std::nullopt;
    t -= (way->at(t) - place_m) / slope;
  }
  if (!(std::abs(t) < static_cast<double>(half))) return std::nullopt;
  const auto nearest = static_cast<long>(middle) + std::lround(t);
  return StopSpeed{way->slope_at(t) * trial.rate_hz, -2 * way->bend_m * trial.rate_hz,
                   static_cast<std::size_t>(std::clamp(nearest, 0L, static_cast<long>(count) - 1))};
}

}  // namespace

void add_stop_sums(const MeasuredTrial& trial, const StickSegments& segments, const std::vector<Vec2>& ratio,
                   const EvidencePoint& about, TrialEvidence& evidence) {
  const auto half = static_cast<std::size_t>(segments.half_window);
  const double usual_scatter = trial_scatter_of_slip(segments, ratio);
  for (const PhaseStretch& slip : phase_stretches(segments, PadPhase::slip)) {
    if (slip.to < slip.from + 4 * half) continue;
    // Its mean over some windows: one alone has noise of direction.
    Vec2 forward(0, 0);
    for (std::size_t i = slip.to - 3 * half; i < slip.to; ++i) forward += segments.velocity_m_per_s[i];
    forward.normalize();
    const SlipStop stop = stop_after(trial, segments, ratio, about, slip, forward, usual_scatter);
    const auto spring_m = [&](double pull) { return spring_way_m(evidence, about.bend, forward, pull); };
    if (!(spring_m(stop.slip_ratio) > 0)) continue;
    const auto end_m = end_of_slip_m(stop, spring_m, segments.ratio_noise);
    if (!end_m) continue;
    const auto speed =
        speed_at_m(trial, segments, forward, std::min(slip.to, trial.position_m.size() - 1), *end_m);
    if (!speed || !(speed->slowing_m_per_s > 0)) continue;
    evidence.stop_speed_m_per_s += speed->speed_m_per_s;
    evidence.stop_slowing_m_per_s += speed->slowing_m_per_s;
    evidence.stop_rise += rise_before_stop(segments, ratio, slip, forward, evidence);
    ++evidence.stops;
    evidence.stop_samples.push_back(speed->sample);
  }
}

}  // namespace fingerpad
