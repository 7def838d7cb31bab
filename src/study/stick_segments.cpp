#include "study/stick_segments.hpp"

#include <algorithm>
#include <cmath>

namespace fingerpad {
namespace {

double median_of(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<long>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Standard deviation of white noise on a component, from second differences: their variance is six times
/// its.
double noise_of(const std::vector<Vec2>& samples) {
  std::vector<double> sizes;
  for (std::size_t i = 2; i < samples.size(); ++i) {
    const Vec2 bend = samples[i] - 2 * samples[i - 1] + samples[i - 2];
    sizes.push_back(std::abs(bend.x()));
    sizes.push_back(std::abs(bend.y()));
  }
  return median_of(std::move(sizes)) / 0.6745 / std::sqrt(6.0);
}

/// The window around a sample, [from, to), within its run.
struct SampleWindow {
  std::size_t from, to;
};

SampleWindow window_around(std::size_t i, const std::vector<bool>& begins_run, int half_window) {
  const auto half = static_cast<std::size_t>(half_window);
  SampleWindow window{i, i + 1};
  while (window.from > 0 && i - window.from < half && !begins_run[window.from]) --window.from;
  while (window.to < begins_run.size() && window.to - i <= half && !begins_run[window.to]) ++window.to;
  return window;
}

/// Slope of the positions; ruptures do not part them.
Vec2 local_velocity(const MeasuredTrial& trial, const SampleWindow& w) {
  const double middle = static_cast<double>(w.from + w.to - 1) / 2;
  Vec2 drift(0, 0);
  double squares = 0;
  for (std::size_t j = w.from; j < w.to; ++j) {
    const double t = static_cast<double>(j) - middle;
    drift += t * (trial.position_m[j] - trial.position_m[w.from]);
    squares += t * t;
  }
  return squares > 0 ? Vec2(drift / squares * trial.rate_hz) : Vec2(0, 0);
}

/// How much the ratio's length falls in the step to sample i.
double drop_at(const MeasuredTrial& trial, std::size_t i) {
  return trial.force_ratio[i - 1].norm() - trial.force_ratio[i].norm();
}

bool ruptures_at(std::size_t i, const MeasuredTrial& trial, int half_window, double noise) {
  constexpr double deviations = 6, shares = 1.5;
  const double least = deviations * std::sqrt(2.0) * noise, drop = drop_at(trial, i);
  if (!(drop > 0.5 * least)) return false;
  const auto half = static_cast<std::size_t>(half_window);
  std::vector<double> drops, sizes;
  for (std::size_t j = i > half ? i - half : 1; j <= std::min(i + half, trial.force_ratio.size() - 1); ++j) {
    if (j == i || trial.starts_anew[j]) continue;
    drops.push_back(drop_at(trial, j));
    sizes.push_back(std::abs(drops.back()));
  }
  return drop - median_of(std::move(drops)) > least + shares * median_of(std::move(sizes));
}

void find_ruptures(const MeasuredTrial& trial, StickSegments& found) {
  found.begins_run = trial.starts_anew;
  found.is_rupture.assign(trial.force_ratio.size(), false);
  for (std::size_t i = 1; i < trial.force_ratio.size(); ++i) {
    if (trial.starts_anew[i] || !ruptures_at(i, trial, found.half_window, found.ratio_noise)) continue;
    found.is_rupture[i] = found.begins_run[i] = true;
  }
}

/// What a window says.
struct LocalStiffness {
  double per_m = 0;
  bool is_known = false;
};

LocalStiffness local_stiffness(const MeasuredTrial& trial, const SampleWindow& w, double noise_m) {
  const auto count = static_cast<double>(w.to - w.from);
  Vec2 mean_x(0, 0), mean_q(0, 0);
  for (std::size_t j = w.from; j < w.to; ++j) {
    mean_x += trial.position_m[j] / count;
    mean_q += trial.force_ratio[j] / count;
  }
  double spread = 0, pull = 0;
  for (std::size_t j = w.from; j < w.to; ++j) {
    const Vec2 dx = trial.position_m[j] - mean_x;
    spread += dx.squaredNorm();
    pull -= dx.dot(trial.force_ratio[j] - mean_q);
  }
  LocalStiffness local;
  local.is_known = w.to - w.from >= 4 && spread > 16 * 2 * noise_m * noise_m * count;
  if (local.is_known) local.per_m = pull / spread;
  return local;
}

/// Half the mean of the stiffer of two groups; where there is no second group, what puts all on one side.
double border_per_m(const std::vector<LocalStiffness>& locals, double ratio_rms) {
  std::vector<double> known;
  for (const LocalStiffness& local : locals)
    if (local.is_known) known.push_back(local.per_m);
  if (known.empty()) return 0;
  std::sort(known.begin(), known.end());
  double low = known[known.size() / 20], high = known[known.size() - 1 - known.size() / 20];
  for (int pass = 0; pass < 30; ++pass) {
    double sums[2] = {0, 0}, counts[2] = {0, 0};
    for (const double k : known) {
      const int group = k > (low + high) / 2 ? 1 : 0;
      sums[group] += k;
      counts[group] += 1;
    }
    if (counts[0] > 0) low = sums[0] / counts[0];
    if (counts[1] > 0) high = sums[1] / counts[1];
  }
  // A spring that would take five centimetres to reach these forces is no finger's.
  constexpr double softest_reach_m = 0.05;
  if (high * softest_reach_m < ratio_rms) return 2 * std::abs(high) + ratio_rms / softest_reach_m;
  return low > 0.4 * high ? 0.25 * low : high / 2;
}

}  // namespace

StickSegments stick_segments(const MeasuredTrial& trial) {
  constexpr double half_window_s = 6e-3;
  constexpr int widest = 16;  // times the half window, where the pad moves slowly
  StickSegments found;
  found.half_window = std::max(3, static_cast<int>(std::lround(half_window_s * trial.rate_hz)));
  found.position_noise_m = noise_of(trial.position_m);
  found.ratio_noise = noise_of(trial.force_ratio);
  find_ruptures(trial, found);
  const std::size_t samples = trial.position_m.size();
  found.velocity_m_per_s.resize(samples);
  std::vector<LocalStiffness> locals(samples);
  double squares = 0;
  for (std::size_t i = 0; i < samples; ++i) {
    found.velocity_m_per_s[i] = local_velocity(trial, window_around(i, trial.starts_anew, found.half_window));
    for (int widened = 1; widened <= widest && !locals[i].is_known; widened *= 2)
      locals[i] = local_stiffness(trial, window_around(i, found.begins_run, widened * found.half_window),
                                  found.position_noise_m);
    squares += trial.force_ratio[i].squaredNorm();
  }
  const double border = border_per_m(locals, std::sqrt(squares / static_cast<double>(samples)));
  found.border_per_m = border;
  found.phase.assign(samples, PadPhase::unknown);
  for (std::size_t i = 0; i < samples; ++i) {
    if (!locals[i].is_known) continue;
    const bool against = trial.force_ratio[i].dot(found.velocity_m_per_s[i]) < 0;
    if (locals[i].per_m > border) found.phase[i] = PadPhase::stick;
    if (locals[i].per_m <= border && against) found.phase[i] = PadPhase::slip;
  }
  return found;
}

std::string_view reason_text(BoundaryReason reason) noexcept {
  switch (reason) {
    case BoundaryReason::touchdown:
      return "contact begins";
    case BoundaryReason::rupture:
      return "the force ratio drops at once";
    case BoundaryReason::spring_gives:
      return "force stops to follow displacement";
    case BoundaryReason::spring_holds:
      return "force begins to follow displacement";
    case BoundaryReason::hardly_moves:
      return "too little motion to tell";
    case BoundaryReason::moves_again:
      return "motion tells again";
  }
  return "";
}

std::vector<PhaseBoundary> phase_boundaries(const MeasuredTrial& trial, const StickSegments& segments) {
  const auto reason = [&](std::size_t i, PadPhase before, PadPhase after) {
    if (trial.starts_anew[i]) return BoundaryReason::touchdown;
    if (segments.is_rupture[i]) return BoundaryReason::rupture;
    if (after == PadPhase::unknown) return BoundaryReason::hardly_moves;
    if (before == PadPhase::unknown) return BoundaryReason::moves_again;
    return after == PadPhase::slip ? BoundaryReason::spring_gives : BoundaryReason::spring_holds;
  };
  std::vector<PhaseBoundary> found;
  for (std::size_t i = 0; i < segments.phase.size(); ++i) {
    const PadPhase before = i > 0 ? segments.phase[i - 1] : PadPhase::unknown, after = segments.phase[i];
    if (before == after && !segments.begins_run[i]) continue;
    found.push_back({i, before, after, reason(i, before, after)});
  }
  return found;
}

}  // namespace fingerpad
