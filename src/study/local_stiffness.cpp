#include "study/local_stiffness.hpp"

#include <algorithm>
#include <cmath>

#include "study/rupture_search.hpp"

namespace fingerpad {

SampleWindows::SampleWindows(const std::vector<bool>& begins_run) : run_(begins_run.size()) {
  for (std::size_t from = 0, to = 0; from < run_.size(); from = to) {
    to = from + 1;
    while (to < run_.size() && !begins_run[to]) ++to;
    std::fill(run_.begin() + static_cast<std::ptrdiff_t>(from),
              run_.begin() + static_cast<std::ptrdiff_t>(to), SampleWindow{from, to});
  }
}

SampleWindow SampleWindows::around(std::size_t i, int half_window) const {
  const auto half = static_cast<std::size_t>(half_window);
  return {std::max(run_[i].from, i - std::min(i, half)), std::min(run_[i].to, i + half + 1)};
}

WindowSums::WindowSums(const MeasuredTrial& trial, const StickSegments& found)
    : sums_(trial.position_m.size() + 1) {
  const Vec2 origin = trial.position_m.front();
  for (std::size_t i = 0; i < trial.position_m.size(); ++i) {
    const Vec2 x = trial.position_m[i] - origin;
    Vec2 q = trial.force_ratio[i];
    if (found.axes_exponent != 0)
      q *= std::pow(trial.normal_force_n[i] / found.usual_normal_n, found.axes_exponent);
    sums_[i + 1] = sums_[i];
    sums_[i + 1].x += x;
    sums_[i + 1].q += q;
    sums_[i + 1].xx += x.squaredNorm();
    sums_[i + 1].xq += x.dot(q);
  }
}

LocalStiffness WindowSums::stiffness(const SampleWindow& w, double noise_m, double least_m2) const {
  const auto count = static_cast<double>(w.to - w.from);
  const Sums &from = sums_[w.from], &to = sums_[w.to];
  const Vec2 x = to.x - from.x;
  const double spread = to.xx - from.xx - x.squaredNorm() / count;
  const double pull = x.dot(to.q - from.q) / count - (to.xq - from.xq);
  LocalStiffness local;
  local.is_known = w.to - w.from >= 4 &&
                   spread > std::max(2 * std::pow(least_window_spread * noise_m, 2) * count, least_m2);
  if (local.is_known) local.per_m = pull / spread;
  return local;
}

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
    const double before[2] = {low, high};
    if (counts[0] > 0) low = sums[0] / counts[0];
    if (counts[1] > 0) high = sums[1] / counts[1];
    if (low == before[0] && high == before[1]) break;
  }
  // A spring that would take five centimetres to reach these forces is no finger's.
  constexpr double softest_reach_m = 0.05;
  if (high * softest_reach_m < ratio_rms) return 2 * std::abs(high) + ratio_rms / softest_reach_m;
  return low > 0.4 * high ? 0.25 * low : high / 2;
}

std::vector<LocalStiffness> local_stiffnesses(const MeasuredTrial& trial, const StickSegments& found,
                                              const WindowSums& sums, const std::vector<bool>& is_light) {
  constexpr int widest = 16;  // times the half window
  constexpr double deviations = 4;
  std::vector<LocalStiffness> locals(is_light.size());
  const SampleWindows windows(found.begins_run);
  for (std::size_t i = 0; i < locals.size(); ++i) {
    if (is_light[i]) continue;
    const double least_m =
        found.border_per_m > 0 ? deviations * ratio_noise_at(trial, found, i) / found.border_per_m : 0;
    for (int widened = 1; widened <= widest && !locals[i].is_known; widened *= 2)
      locals[i] = sums.stiffness(windows.around(i, widened * found.half_window), found.position_noise_m,
                                 least_m * least_m);
  }
  return locals;
}

}  // namespace fingerpad
