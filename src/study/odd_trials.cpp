#include "study/odd_trials.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "base/number_text.hpp"
#include "motion/driving_share.hpp"
#include "study/sample_noise.hpp"
#include "study/six_axis_sensor.hpp"

namespace fingerpad {
namespace {

/// Whether a trial's forces stand out of their noise: else nothing pressed, which is told otherwise.
bool presses(const RecordedTrial& trial) {
  constexpr double beyond_noise = 20;
  const Eigen::RowVectorXd along_n = trial.normal_W.transpose() * trial.force_W;
  const double noise_n = sample_noise({along_n.data(), static_cast<std::size_t>(along_n.size())});
  return std::abs(pressing_n(trial)) > beyond_noise * noise_n;
}

double work_share(const RecordedTrial& trial) {
  return driving_share(finger_W(trial), trial.force_W, trial.rate_hz);
}

/// What is odd in a trial; empty where nothing is.
std::string oddity(const RecordedTrial& trial, double usual_n, double usual_share) {
  constexpr double most_times = 50;
  const double press_n = pressing_n(trial), times = std::abs(press_n / usual_n);
  const std::string press_text = rounded_text(press_n, 3), usual_text = rounded_text(usual_n, 3);
  if (times > most_times || (times * most_times < 1 && presses(trial)))
    return fmt::format(
        "its normal force is {} N where it presses, and the other trials' {} N: is it in another "
        "unit? It is counted as it is; --force-unit holds for all trials of a file",
        press_text, usual_text);
  if (press_n * usual_n < 0 && presses(trial))
    return fmt::format(
        "its normal force is {} N where it presses, and the other trials' {} N: is its sign "
        "turned round? It tells nothing so",
        press_text, usual_text);
  if (trial.lacks.empty() && usual_share < -most_driving_share && work_share(trial) > most_driving_share)
    return "its force drives the finger along its way, and the other trials' holds it back: is the sign of "
           "its "
           "fx and fy turned round? It tells neither slip nor springs so";
  return {};
}

}  // namespace

std::vector<std::string> odd_trial_doubts(FileTrials trials) {
  constexpr std::size_t fewest = 3;
  if (trials.size() < fewest) return {};
  const double usual_n = usual(trials, pressing_n), usual_share = usual(trials, work_share);
  std::vector<std::string> doubts;
  for (const RecordedTrial& trial : trials)
    if (const std::string words = oddity(trial, usual_n, usual_share); !words.empty())
      doubts.push_back(fmt::format("{}: {}", trial_name(trial), words));
  return doubts;
}

}  // namespace fingerpad
