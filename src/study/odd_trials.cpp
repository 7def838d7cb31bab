#include "study/odd_trials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/number_text.hpp"
#include "motion/driving_share.hpp"
#include "study/sample_noise.hpp"
#include "study/six_axis_sensor.hpp"

namespace fingerpad {
namespace {

/// Of fewer trials none is odd.
constexpr std::size_t fewest_in_file = 3;

/// Forces stand out of their noise from so many times that on: else nothing pressed, which is told otherwise.
constexpr double beyond_noise = 20;

Eigen::RowVectorXd along_normal_n(const RecordedTrial& trial) {
  return trial.normal_W.transpose() * trial.force_W;
}

double noise_n(const RecordedTrial& trial) {
  const Eigen::RowVectorXd along_n = along_normal_n(trial);
  return sample_noise({along_n.data(), static_cast<std::size_t>(along_n.size())});
}

bool presses(const RecordedTrial& trial) {
  return std::abs(pressing_n(trial)) > beyond_noise * noise_n(trial);
}

/// What the sensor shows in the air: at the end of the trial at which it shows less.
double air_n(const RecordedTrial& trial) {
  constexpr double end_s = 0.05;
  const Eigen::RowVectorXd along_n = along_normal_n(trial);
  const auto count = std::clamp<Eigen::Index>(std::lround(end_s * trial.rate_hz), 1, along_n.size());
  const auto median_n = [](std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  };
  const double first_n = median_n({along_n.data(), along_n.data() + count}),
               last_n = median_n({along_n.data() + along_n.size() - count, along_n.data() + along_n.size()});
  return std::abs(first_n) < std::abs(last_n) ? first_n : last_n;
}

/// Whether it presses the other way than usual. A light press may be less than the sensor's offset, which the
/// air before and after it tells; without air a press counts that no offset is.
bool presses_the_other_way(const RecordedTrial& trial, double usual_n) {
  constexpr double no_offset = 0.5;  // of the usual press
  const double press_n = pressing_n(trial), from_air_n = press_n - air_n(trial);
  if (!(press_n * usual_n < 0) || !presses(trial)) return false;
  const bool has_air = std::abs(from_air_n) > no_offset * std::abs(press_n);
  if (!has_air) return std::abs(press_n) > no_offset * std::abs(usual_n);
  return from_air_n * usual_n < 0 && std::abs(from_air_n) > beyond_noise * noise_n(trial);
}

double work_share(const RecordedTrial& trial) {
  return driving_share(finger_W(trial), trial.force_W, trial.rate_hz);
}

/// What is odd in a trial that presses as the others do; empty where nothing is.
std::string oddity(const RecordedTrial& trial, double usual_n, double usual_share) {
  constexpr double most_times = 50;
  const double press_n = pressing_n(trial), times = std::abs(press_n / usual_n);
  const std::string press_text = rounded_text(press_n, 3), usual_text = rounded_text(usual_n, 3);
  if (times > most_times || (times * most_times < 1 && presses(trial)))
    return fmt::format(
        "its normal force is {} N where it presses, and the other trials' {} N: is it in another "
        "unit? It is counted as it is; --force-unit holds for all trials of a file",
        press_text, usual_text);
  if (presses_the_other_way(trial, usual_n))
    return fmt::format(
        "its normal force is {} N where it presses, and the other trials' {} N: is its sign "
        "turned round? It is left out",
        press_text, usual_text);
  if (trial.lacks.empty() && usual_share < -most_driving_share && work_share(trial) > most_driving_share)
    return "its force drives the finger along its way, and the other trials' holds it back: is the sign of "
           "its fx and fy turned round? It tells neither slip nor springs so";
  return {};
}

}  // namespace

std::vector<std::string> odd_trial_doubts(FileTrials trials) {
  if (trials.size() < fewest_in_file) return {};
  const double usual_n = usual(trials, pressing_n), usual_share = usual(trials, work_share);
  std::vector<std::string> doubts;
  for (const RecordedTrial& trial : trials)
    if (const std::string words = oddity(trial, usual_n, usual_share); !words.empty())
      doubts.push_back(fmt::format("{}: {}", trial_name(trial), words));
  return doubts;
}

void leave_out_turned_presses(RecordedMeasurement& recorded) {
  std::vector<bool> is_out;
  each_file(recorded, [&](FileTrials own) {
    const double usual_n = own.size() < fewest_in_file ? 0 : usual(own, pressing_n);
    for (const RecordedTrial& trial : own) is_out.push_back(presses_the_other_way(trial, usual_n));
  });
  auto out = is_out.begin();
  std::erase_if(recorded.trials, [&](const RecordedTrial&) { return *out++; });
}

}  // namespace fingerpad
