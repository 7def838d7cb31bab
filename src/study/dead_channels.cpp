#include "study/dead_channels.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/number_text.hpp"
#include "study/named_trials.hpp"

namespace fingerpad {
namespace {

bool is_dead_along_plate(const RecordedTrial& trial) {
  if (!trial.lacks.empty() || trial.samples() == 0) return false;
  if (!(std::abs(pressing_n(trial)) > surely_presses_n)) return false;
  const Eigen::Matrix3Xd along_plate_W_n = trial.force_W - trial.normal_W * along_normal_n(trial);
  const Vec3 first_W_n = along_plate_W_n.col(0);
  constexpr double rounding_n = 1e-9;
  return ((along_plate_W_n.colwise() - first_W_n).cwiseAbs().array() < rounding_n).all();
}

}  // namespace

std::vector<std::string> dead_channel_doubts(FileTrials own, const std::vector<RecordedTrial>& all) {
  std::vector<std::string> doubts;
  for (const RecordedTrial& trial : own) {
    if (!is_dead_along_plate(trial)) continue;
    const double along_n =
        (trial.force_W.col(0) - trial.normal_W.dot(trial.force_W.col(0)) * trial.normal_W).norm();
    doubts.push_back(fmt::format(
        "{}: its force along the plate is {} N in every sample, though the finger presses: are these "
        "channels connected, and its columns written? --leave-out '{}' leaves it out",
        trial_name(trial), rounded_text(along_n, 3), option_name(trial, all)));
  }
  return doubts;
}

}  // namespace fingerpad
