#include "study/rupture_search.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "study/sample_noise.hpp"

namespace fingerpad {
namespace {

constexpr double rupture_deviations = 4.5;  // of a step's noise, that a drop is beyond

/// How much the length of the ratio's mean falls between the `count` samples before sample i and those from
/// it on; nothing where they are not all of one run.
std::optional<double> drop_at(const MeasuredTrial& trial, std::size_t i, std::size_t count) {
  if (i < count || i + count > trial.force_ratio.size()) return std::nullopt;
  Vec2 before(0, 0), after(0, 0);
  for (std::size_t k = 0; k < count; ++k) {
    if (trial.starts_anew[i - k] || (k > 0 && trial.starts_anew[i + k])) return std::nullopt;
    before += trial.force_ratio[i - 1 - k];
    after += trial.force_ratio[i + k];
  }
  return (before.norm() - after.norm()) / static_cast<double>(count);
}

bool ruptures_at(std::size_t i, const MeasuredTrial& trial, int half_window, double noise,
                 std::size_t count) {
  constexpr double shares = 1;
  const std::optional<double> drop = drop_at(trial, i, count);
  if (!drop) return false;
  const double least =
      least_drop(noise / std::sqrt(static_cast<double>(count)), trial.force_ratio[i - 1].norm());
  if (!(*drop > 0.5 * least)) return false;
  const auto half = static_cast<std::size_t>(half_window);
  std::vector<double> drops;
  for (std::size_t j = i > half ? i - half : 1; j <= std::min(i + half, trial.force_ratio.size() - 1); ++j) {
    const std::optional<double> other = j == i ? std::nullopt : drop_at(trial, j, count);
    if (!other) continue;
    // Means that hold the same step tell of it too: the rupture is where most falls.
    const bool holds_step = count > 1 && j + count > i && i + count > j;
    if (holds_step && *other > *drop) return false;
    drops.push_back(*other);
  }
  // The means of a finger that moves on differ by much, and by as much throughout: that is no size of steps.
  const double usual = median_of(drops);
  for (double& other : drops) other = std::abs(count > 1 ? other - usual : other);
  return *drop - usual > least + shares * median_of(drops);
}

/// Ratio of the noise of q to friction above which a step of single samples may hide a rupture.
constexpr double single_noise = most_noise_share / 2;
constexpr std::size_t means_count = 3;

}  // namespace

double least_drop(double noise, double friction) {
  constexpr double least_share = 0.08;
  return std::max(rupture_deviations * std::sqrt(2.0) * noise, least_share * friction);
}

double ratio_noise_at(const MeasuredTrial& trial, const StickSegments& segments, std::size_t i) {
  return segments.ratio_noise * std::max(1.0, segments.usual_normal_n / trial.normal_force_n[i]);
}

double most_friction(const MeasuredTrial& trial, double least_n) {
  std::vector<double> frictions;
  for (std::size_t i = 0; i < trial.normal_force_n.size(); ++i)
    if (trial.normal_force_n[i] >= least_n) frictions.push_back(trial.force_ratio[i].norm());
  return quantile(frictions, 0.98);
}

bool drops_below_its_tooth(const MeasuredTrial& trial, const StickSegments& segments, std::size_t from,
                           std::size_t i) {
  constexpr std::size_t top_samples = 4;  // the last of them may have dropped already
  constexpr double deviations = 3, share = 0.1, like_load = 1.25;
  double top = 0, greatest = 0;
  for (std::size_t j = i > from + top_samples ? i - top_samples : from; j < i; ++j)
    top = std::max(top, trial.force_ratio[j].norm());
  const double load_n = trial.normal_force_n[i - 1];
  for (std::size_t j = from + 1; j + 1 < i; ++j) {
    const double here_n = trial.normal_force_n[j];
    if (here_n * like_load < load_n || here_n > like_load * load_n) continue;
    greatest = std::max(
        greatest, (trial.force_ratio[j - 1] + trial.force_ratio[j] + trial.force_ratio[j + 1]).norm() / 3);
  }
  return greatest > top + std::max(deviations * ratio_noise_at(trial, segments, i - 1), share * greatest);
}

void find_ruptures(const MeasuredTrial& trial, StickSegments& found) {
  found.begins_run = trial.starts_anew;
  found.is_rupture.assign(trial.force_ratio.size(), false);
  found.usual_normal_n = quantile(trial.normal_force_n, 0.5);
  const double most = most_friction(trial, found.usual_normal_n);
  for (const std::size_t count : {std::size_t{1}, means_count}) {
    for (std::size_t i = 1; i < trial.force_ratio.size(); ++i) {
      const double noise = ratio_noise_at(trial, found, i);
      if (trial.starts_anew[i] || (count > 1 && !(noise > single_noise * most))) continue;
      const auto near = found.is_rupture.begin() + static_cast<std::ptrdiff_t>(i > count ? i - count : 0);
      const auto beyond = found.is_rupture.begin() +
                          static_cast<std::ptrdiff_t>(std::min(i + count, found.is_rupture.size()));
      if (count > 1 && std::find(near, beyond, true) != beyond) continue;
      if (ruptures_at(i, trial, found.half_window, noise, count))
        found.is_rupture[i] = found.begins_run[i] = true;
    }
  }
}

}  // namespace fingerpad
