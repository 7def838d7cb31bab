#include "study/swapped_forces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "motion/pressed_force.hpp"
#include "study/named_trials.hpp"
#include "study/press_and_air.hpp"
#include "study/sample_noise.hpp"

namespace fingerpad {
namespace {

/// How much of a force keeps one sign: 1 of a press, near 0 of friction that goes to and fro.
double one_sign_share(const std::vector<double>& forces_n) {
  double sum = 0, sizes = 0;
  for (const double force_n : forces_n) {
    sum += force_n;
    sizes += std::abs(force_n);
  }
  return sizes > 0 ? std::abs(sum) / sizes : 0;
}

double mean_size(const std::vector<double>& forces_n) {
  double sizes = 0;
  for (const double force_n : forces_n) sizes += std::abs(force_n);
  return forces_n.empty() ? 0 : sizes / static_cast<double>(forces_n.size());
}

/// Whether an axis presses in the place of the normal, along which friction acts then. The air before and
/// after it tells the sensor's offset; without it nothing is told.
bool presses_instead(const RecordedTrial& trial, const Vec3& axis_W) {
  constexpr double press_share = 0.9, friction_share = 0.6, least_times = 2.5;
  constexpr double beyond_noise = 10;
  const Eigen::RowVectorXd normal_n = along_normal_n(trial), other_n = axis_W.transpose() * trial.force_W;
  const PressAndAir samples =
      press_and_air(other_n.cwiseAbs(),
                    std::abs(pressed_median_n({other_n.data(), static_cast<std::size_t>(other_n.size())})));
  if (!last_long(samples.air, trial.rate_hz)) return false;
  const std::vector<double> press_n = values_at(other_n, samples.press);
  std::vector<double> friction_n = values_at(normal_n, samples.press);
  if (!(one_sign_share(press_n) > press_share)) return false;
  if (!(mean_size(press_n) > least_times * mean_size(friction_n))) return false;
  const double offset_n = median_of(values_at(normal_n, samples.air));
  for (double& force_n : friction_n) force_n -= offset_n;
  return one_sign_share(friction_n) < friction_share &&
         mean_size(friction_n) >
             beyond_noise * sample_noise({normal_n.data(), static_cast<std::size_t>(normal_n.size())});
}

/// -1: none.
int pressing_axis(const RecordedTrial& trial) {
  if (!trial.lacks.empty() || trial.samples() == 0) return -1;
  for (int axis = 0; axis < 3; ++axis) {
    const bool is_along_plate = std::abs(trial.normal_W[axis]) < 0.5;
    if (is_along_plate && presses_instead(trial, Vec3::Unit(axis))) return axis;
  }
  return -1;
}

/// Of each trial the axis that presses instead, -1: none.
std::vector<int> pressing_axes(FileTrials trials) {
  std::vector<int> axes;
  axes.reserve(trials.size());
  for (const RecordedTrial& trial : trials) axes.push_back(pressing_axis(trial));
  return axes;
}

std::size_t count_swapped(const std::vector<int>& axes) {
  return static_cast<std::size_t>(std::ranges::count_if(axes, [](int axis) { return axis >= 0; }));
}

/// "x and y": those that are among them.
std::string axis_words(const std::vector<int>& axes) {
  std::string words;
  for (int axis = 0; axis < 3; ++axis)
    if (std::ranges::find(axes, axis) != axes.end())
      words += fmt::format("{}{}", words.empty() ? "" : " and ", "xyz"[axis]);
  return words;
}

/// @param along  axis_words
std::string swapped_words(const std::string& along) {
  return fmt::format(
      "along the plate's normal its force changes its sign to and fro, as friction does, and along {} it "
      "presses",
      along);
}

constexpr std::string_view why =
    "two columns of force are swapped, or the plate's normal is another. --columns says which is which, "
    "--sensor-turned how the sensor stands, nx, ny, nz the normal";

}  // namespace

std::string swapped_forces_doubt(FileTrials trials) {
  const std::vector<int> axes = pressing_axes(trials);
  if (2 * count_swapped(axes) <= axes.size()) return {};
  return fmt::format("{}: {}", swapped_words(axis_words(axes)), why);
}

std::vector<std::string> swapped_trial_doubts(FileTrials own, const std::vector<RecordedTrial>& all) {
  const std::vector<int> axes = pressing_axes(own);
  const std::size_t count = count_swapped(axes);
  if (2 * count > axes.size()) return {};
  std::vector<std::string> doubts;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (axes[i] < 0) continue;
    doubts.push_back(
        fmt::format("{}: {}, so in {} of the {} trials of its file: {}; --leave-out '{}' leaves it out",
                    trial_name(own[i]), swapped_words(axis_words({axes[i]})), count, axes.size(), why,
                    option_name(own[i], all)));
  }
  return doubts;
}

}  // namespace fingerpad
