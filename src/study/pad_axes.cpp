#include "study/pad_axes.hpp"

#include <numbers>

#include "base/tangent_frame.hpp"
#include "touch/skin_motion.hpp"

namespace fingerpad {

MeasuredTrial in_pad_axes(const RecordedTrial& trial) {
  MeasuredTrial measured;
  measured.subject = trial.subject;
  measured.name = trial_name(trial);
  measured.rate_hz = trial.rate_hz;
  measured.lines_left_in = trial.lines_left_in;
  measured.has_direction = trial.has_direction();
  if (measured.has_direction)
    measured.inclination_deg = inclination_rad(trial.direction_W, trial.normal_W) * 180 / std::numbers::pi;
  const Mat3 frame = tangent_frame(trial.normal_W, trial.direction_W);
  bool follows = false;
  for (Eigen::Index i = 0; i < trial.samples(); ++i) {
    const Vec3 force = frame.transpose() * trial.force_W.col(i),
               place = frame.transpose() * trial.position_W.col(i);
    if (trial.origin[static_cast<std::size_t>(i)] == SampleOrigin::missing ||
        !(force.z() > least_normal_force_n)) {
      follows = false;
      continue;
    }
    measured.t_s.push_back(trial.start_s + static_cast<double>(i) / trial.rate_hz);
    measured.position_m.emplace_back(place.head<2>());
    measured.height_m.push_back(place.z());
    measured.normal_force_n.push_back(force.z());
    measured.force_ratio.emplace_back(force.head<2>() / force.z());
    measured.starts_anew.push_back(!follows);
    follows = true;
  }
  return measured;
}

}  // namespace fingerpad
