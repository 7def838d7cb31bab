#include "study/odd_trials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "base/number_text.hpp"
#include "motion/driving_share.hpp"
#include "study/named_trials.hpp"
#include "study/sample_noise.hpp"
#include "study/six_axis_sensor.hpp"
#include "study/trial_drive.hpp"

namespace fingerpad {
namespace {

/// Of fewer trials none is odd.
constexpr std::size_t fewest_in_file = 3;

/// Forces stand out of their noise from so many times that on: else nothing pressed, which is told otherwise.
constexpr double beyond_noise = 20;

double noise_n(const RecordedTrial& trial) {
  const Eigen::RowVectorXd along_n = along_normal_n(trial);
  return sample_noise({along_n.data(), static_cast<std::size_t>(along_n.size())});
}

bool presses(const RecordedTrial& trial) {
  return std::abs(pressing_n(trial)) > beyond_noise * noise_n(trial);
}

/// Of a component of positions.
double place_noise_m(const RecordedTrial& trial) {
  const Eigen::RowVectorXd along_m = finger_W(trial).row(0);
  return sample_noise({along_m.data(), static_cast<std::size_t>(along_m.size())});
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

/// The middle of sizes; of two in the middle the one that is nearer, by its logarithm, to a finger's. Sizes
/// of 0 do not count; not a number where there are no others.
double usual_size(std::vector<double> sizes, double of_finger) {
  std::erase_if(sizes, [](double size) { return !(size > 0); });
  if (sizes.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(sizes.begin(), sizes.end());
  const double low = sizes[(sizes.size() - 1) / 2], high = sizes[sizes.size() / 2];
  return std::abs(std::log(low / of_finger)) < std::abs(std::log(high / of_finger)) ? low : high;
}

/// What trials mostly are.
struct UsualTrial {
  double press_n = 0;  ///< below 0 where most are of the wrong sign
  double reach_m = 0, work_share = 0;
  Vec3 work_by_axis = Vec3::Zero();

  explicit UsualTrial(FileTrials trials) {
    std::vector<double> presses_n, reaches_m;
    long turned = 0;
    for (const RecordedTrial& trial : trials) {
      const double press = pressing_n(trial);
      if (presses(trial)) {
        presses_n.push_back(std::abs(press));
        turned += press < 0 ? 1 : -1;
      }
      reaches_m.push_back(extent_m(trial));
    }
    press_n = (turned > 0 ? -1 : 1) * usual_size(presses_n, 1);
    reach_m = usual_size(reaches_m, 0.05);
    if (trials.size() < fewest_in_file) return;
    work_share = usual(trials, fingerpad::work_share);
    std::vector<Vec3> drives;
    drives.reserve(trials.size());
    for (const RecordedTrial& trial : trials) drives.push_back(drive_of(trial, 0).by_axis);
    for (int axis = 0; axis < 3; ++axis)
      work_by_axis[axis] = usual(trials, [&](const RecordedTrial& trial) {
        return drives[static_cast<std::size_t>(&trial - trials.data())][axis];
      });
  }
};

/// Which unit makes something so many times what it is, as a question; empty where none is likely.
/// @param thousandth  of the unit that is taken
std::string likely_unit(double times, std::string_view thousandth) {
  constexpr double near = 8;
  const auto is_thousand = [](double size) { return size > 1000 / near && size < 1000 * near; };
  if (is_thousand(times)) return fmt::format(" In {}?", thousandth);
  if (is_thousand(1 / times)) return fmt::format(" Or are the others, in {}?", thousandth);
  return {};
}

/// How to say the unit of one trial, where that can be said (take_trial_units), or leave it out.
std::string unit_mend(const RecordedTrial& trial, const std::vector<RecordedTrial>& all,
                      const char* of_file) {
  const std::string name = option_name(trial, all);
  if (trial.sensor) return fmt::format("; --leave-out '{}' leaves it out", name);
  return fmt::format(
      "; --trial-unit '{0}=UNIT' says its unit ({1} that of all trials of a file; a published layout has its "
      "own), and --leave-out '{0}' leaves it out",
      name, of_file);
}

/// What is odd in how far a trial's positions reach; empty where nothing is.
std::string odd_reach(const RecordedTrial& trial, double usual_m, const std::vector<RecordedTrial>& all) {
  constexpr double most_times = 300, farthest_m = 0.5, farther = 20;
  const double reach_m = extent_m(trial), times = reach_m / usual_m;
  const bool is_far = times > most_times || (reach_m > farthest_m && times > farther),
             is_near = times * most_times < 1 && reach_m > beyond_noise * place_noise_m(trial);
  if (!is_far && !is_near) return {};
  return fmt::format(
      "its positions reach over {} m, and the other trials' over {} m: are they in another unit?{} They "
      "are counted as they are{}",
      rounded_text(reach_m, 3), rounded_text(usual_m, 3), likely_unit(times, "mm"),
      unit_mend(trial, all, "--unit"));
}

/// What one axis has of a mirror in this trial alone; empty where none has.
std::string odd_axis(const RecordedTrial& trial, const UsualTrial& usual,
                     const std::vector<RecordedTrial>& all) {
  if (!(usual.work_by_axis.array() < -most_driving_share).any()) return {};
  const Vec3 work = drive_of(trial, 0).by_axis;
  for (int axis = 0; axis < 3; ++axis) {
    const bool is_odd = usual.work_by_axis[axis] < -most_driving_share && work[axis] > most_driving_share;
    const bool is_along_plate = std::abs(trial.normal_W[axis]) < 0.5;
    if (!is_odd || !is_along_plate) continue;
    return fmt::format(
        "along {0} alone its force drives the finger, and the other trials' holds it back: is its force or "
        "its position along {0} mirrored? It is counted as it is; --leave-out '{1}' leaves it out",
        "xyz"[axis], option_name(trial, all));
  }
  return {};
}

/// What is odd in a trial that presses as the others do; empty where nothing is.
std::string oddity(const RecordedTrial& trial, const UsualTrial& usual,
                   const std::vector<RecordedTrial>& all) {
  constexpr double most_times = 50;
  const double press_n = pressing_n(trial), times = std::abs(press_n / usual.press_n);
  const std::string press_text = rounded_text(press_n, 3), usual_text = rounded_text(usual.press_n, 3);
  if (times > most_times || (times * most_times < 1 && presses(trial)))
    return fmt::format(
        "its normal force is {} N where it presses, {} times the other trials' {} N: is it in another "
        "unit?{} It is counted as it is{}",
        press_text, times > 1 ? rounded_text(times, 3) : "1/" + rounded_text(1 / times, 3), usual_text,
        likely_unit(times, "mN"), unit_mend(trial, all, "--force-unit"));
  if (presses_the_other_way(trial, usual.press_n))
    return fmt::format(
        "its normal force is {} N where it presses, and the other trials' {} N: is its sign "
        "turned round? It is left out",
        press_text, usual_text);
  if (std::string reach = odd_reach(trial, usual.reach_m, all); !reach.empty()) return reach;
  if (trial.lacks.empty() && usual.work_share < -most_driving_share && work_share(trial) > most_driving_share)
    return fmt::format(
        "its force drives the finger along its way, and the other trials' holds it back: is the sign of "
        "its fx and fy turned round? It tells neither slip nor springs so; --leave-out '{}' leaves it out",
        option_name(trial, all));
  return trial.lacks.empty() ? odd_axis(trial, usual, all) : "";
}

}  // namespace

std::vector<std::string> odd_trial_doubts(const std::vector<RecordedTrial>& trials) {
  if (trials.size() < 2) return {};
  const UsualTrial usual(trials);
  std::vector<std::string> doubts;
  for (const RecordedTrial& trial : trials)
    if (const std::string words = oddity(trial, usual, trials); !words.empty())
      doubts.push_back(fmt::format("{}: {}", trial_name(trial), words));
  return doubts;
}

void leave_out_turned_presses(RecordedMeasurement& recorded) {
  if (recorded.trials.size() < 2) return;
  const UsualTrial usual(recorded.trials);
  std::erase_if(recorded.trials,
                [&usual](const RecordedTrial& trial) { return presses_the_other_way(trial, usual.press_n); });
}

}  // namespace fingerpad
