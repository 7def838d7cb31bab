#include "study/file_trials.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "motion/pressed_force.hpp"
#include "study/six_axis_sensor.hpp"

namespace fingerpad {

Eigen::RowVectorXd along_normal_n(const RecordedTrial& trial) {
  return trial.normal_W.transpose() * trial.force_W;
}

double pressing_n(const RecordedTrial& trial) {
  const Eigen::RowVectorXd along_n = along_normal_n(trial);
  return pressed_median_n({along_n.data(), static_cast<std::size_t>(along_n.size())});
}

double extent_m(const RecordedTrial& trial) {
  const Points& places_W = finger_W(trial);
  return (places_W.rowwise().maxCoeff() - places_W.rowwise().minCoeff()).maxCoeff();
}

double usual(FileTrials trials, const std::function<double(const RecordedTrial&)>& of) {
  std::vector<double> values;
  for (const RecordedTrial& trial : trials) {
    if (const double value = of(trial); !std::isnan(value)) values.push_back(value);
  }
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

double fastest_m_per_s(const RecordedTrial& trial) {
  constexpr double window_s = 12e-3, most_share = 0.95;
  const auto window = static_cast<Eigen::Index>(std::lround(window_s * trial.rate_hz));
  const auto step = std::max<Eigen::Index>(1, std::min<Eigen::Index>(window, trial.samples() - 1));
  const Points& places_W = finger_W(trial);
  std::vector<double> speeds;
  for (Eigen::Index i = 0; i + step < trial.samples(); i += step)
    speeds.push_back((places_W.col(i + step) - places_W.col(i)).norm() * trial.rate_hz /
                     static_cast<double>(step));
  if (speeds.empty()) return 0;
  std::sort(speeds.begin(), speeds.end());
  return speeds[static_cast<std::size_t>(most_share * static_cast<double>(speeds.size() - 1))];
}

double largest_force_n(const RecordedTrial& trial) {
  return trial.force_W.colwise().norm().maxCoeff();
}

void each_file(const RecordedMeasurement& recorded, const std::function<void(FileTrials)>& use) {
  const std::vector<RecordedTrial>& trials = recorded.trials;
  for (std::size_t from = 0, to = 0; from < trials.size(); from = to) {
    while (to < trials.size() && trials[to].file == trials[from].file) ++to;
    use(FileTrials(trials.data() + from, to - from));
  }
}

}  // namespace fingerpad
