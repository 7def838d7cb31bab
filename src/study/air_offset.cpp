#include "study/air_offset.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/count_words.hpp"
#include "base/number_text.hpp"
#include "motion/pressed_force.hpp"
#include "study/press_and_air.hpp"
#include "study/sample_noise.hpp"

namespace fingerpad {
namespace {

using Samples = std::vector<Eigen::Index>;

constexpr double level_share = 0.25;  // of the press, by which what is alike may differ

Samples recorded_samples(const RecordedTrial& trial) {
  Samples samples;
  for (Eigen::Index i = 0; i < trial.samples(); ++i)
    if (trial.origin[static_cast<std::size_t>(i)] == SampleOrigin::recorded) samples.push_back(i);
  return samples;
}

double spread_of(const std::vector<double>& values) {
  return quantile(values, 0.9) - quantile(values, 0.1);
}

/// How far forces along the plate go to and fro.
double friction_spread_n(const RecordedTrial& trial, const Samples& samples) {
  double spread_n = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 along_W = Vec3::Unit(axis) - trial.normal_W[axis] * trial.normal_W;
    spread_n = std::max(spread_n, spread_of(values_at(along_W.transpose() * trial.force_W, samples)));
  }
  return spread_n;
}

/// Whether the finger is off the plate at its trial's ends: it stands higher there; where no height, or
/// nothing but its noise, was measured, friction goes to and fro in between alone. One that presses at both
/// ends and is lifted in between, with a force on the plate, looks alike in its normal force.
bool is_off_the_plate(const RecordedTrial& trial, const Samples& ends, const Samples& pressed) {
  constexpr double surely_friction = 5, beyond_noise = 5;
  const Eigen::RowVectorXd height_m = trial.normal_W.transpose() * trial.seen_W();
  const double above_m = median_of(values_at(height_m, ends)) - median_of(values_at(height_m, pressed));
  const double noise_m = sample_noise({height_m.data(), static_cast<std::size_t>(height_m.size())});
  if (std::abs(above_m) > beyond_noise * noise_m) return above_m > 0;
  return trial.lacks.empty() &&
         friction_spread_n(trial, pressed) > surely_friction * friction_spread_n(trial, ends);
}

}  // namespace

std::optional<Vec3> hiding_offset_W(const RecordedTrial& trial) {
  constexpr double window_s = 0.05;
  const Samples all = recorded_samples(trial);
  const auto window = static_cast<std::ptrdiff_t>(std::max(4L, std::lround(window_s * trial.rate_hz)));
  if (std::ssize(all) < 4 * window || !(pressing_n(trial) < -surely_presses_n)) return std::nullopt;
  const Samples before(all.begin(), all.begin() + window), after(all.end() - window, all.end());
  const Eigen::RowVectorXd along_n = along_normal_n(trial);
  const std::vector<double> before_n = values_at(along_n, before), after_n = values_at(along_n, after);
  const double air_n = (median_of(before_n) + median_of(after_n)) / 2;
  std::vector<double> above_n = values_at(along_n, all);
  for (double& force_n : above_n) force_n -= air_n;
  const double press_n = pressed_median_n(above_n), most_n = level_share * press_n;
  if (!(air_n < -surely_presses_n) || !(press_n > surely_presses_n)) return std::nullopt;
  const bool is_level = spread_of(before_n) < most_n && spread_of(after_n) < most_n &&
                        std::abs(median_of(before_n) - median_of(after_n)) < most_n;
  if (!is_level) return std::nullopt;
  Samples pressed, ends = before;
  ends.insert(ends.end(), after.begin(), after.end());
  for (std::size_t k = 0; k < all.size(); ++k)
    if (above_n[k] > press_n / 2) pressed.push_back(all[k]);
  if (!is_off_the_plate(trial, ends, pressed)) return std::nullopt;
  Vec3 offset_W;
  for (int axis = 0; axis < 3; ++axis) offset_W[axis] = median_of(values_at(trial.force_W.row(axis), ends));
  return offset_W;
}

std::vector<std::string> take_off_hiding_offsets(RecordedMeasurement& recorded) {
  std::vector<std::string> told;
  std::string file;
  std::vector<double> offsets_n;
  const auto tell = [&] {
    if (offsets_n.empty()) return;
    told.push_back(
        fmt::format("{}: its force reads {} N along the plate's normal in the air before and after the "
                    "press, which pushes beside it: a sensor that was not zeroed, no force on the "
                    "plate. Taken off {}",
                    file, rounded_text(median_of(offsets_n), 3), count_words(offsets_n.size(), "trial")));
    offsets_n.clear();
  };
  for (RecordedTrial& trial : recorded.trials) {
    if (trial.file != file) tell();
    file = trial.file;
    const std::optional<Vec3> offset_W = hiding_offset_W(trial);
    if (!offset_W) continue;
    offsets_n.push_back(trial.normal_W.dot(*offset_W));
    trial.force_W.colwise() -= *offset_W;
  }
  tell();
  return told;
}

std::string hiding_offset_words(FileTrials trials) {
  std::vector<double> offsets_n;
  for (const RecordedTrial& trial : trials)
    if (const auto offset_W = hiding_offset_W(trial)) offsets_n.push_back(trial.normal_W.dot(*offset_W));
  if (2 * offsets_n.size() <= trials.size()) return {};
  return fmt::format(
      "its force reads {} N along the plate's normal in the air before and after the press, which "
      "pushes beside it: a sensor that was not zeroed. Leave --no-tare out, and that is taken off",
      rounded_text(median_of(offsets_n), 3));
}

}  // namespace fingerpad
