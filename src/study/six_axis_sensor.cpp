#include "study/six_axis_sensor.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <span>

#include "study/sample_noise.hpp"

namespace fingerpad {

Vec3 contact_point(const ContactSensor& sensor, const Vec3& normal_W, const Vec3& force_W,
                   const Vec3& torque_W_n_m, const Vec3& tracked_W) {
  constexpr double least_n = 0.05;
  const double height_m = sensor.plate_height_m - normal_W.dot(sensor.origin_W),
               normal_n = normal_W.dot(force_W);
  // Of all points r on the line of the force the moment is tau = r x f + m n, with m the free moment about
  // the normal. n x (r x f) = r (n.f) - f (n.r), so that r = (n x tau + h f)/(n.f) with h = n.r: McCarthy
  // 1990's centre of pressure. Its height along the normal is not told by the force.
  const Vec3 contact = (normal_W.cross(torque_W_n_m) + height_m * force_W) / normal_n;
  if (!(std::abs(normal_n) > least_n) || !contact.allFinite()) return tracked_W;
  return sensor.origin_W + contact + normal_W * normal_W.dot(tracked_W - sensor.origin_W - contact);
}

bool is_tracked_along_plate(const RecordedTrial& trial) {
  // Lost markers put less than a tenth of the samples far off. Of noise alone nine tenths lie within 2.1
  // deviations of an axis, in the plane; what moves places by less than half a millimetre is noise too.
  constexpr double share = 0.9, least_m = 0.5e-3, deviations = 3;
  if (!trial.sensor || trial.tracked_W.cols() == 0) return false;
  Points along = trial.tracked_W - trial.normal_W * (trial.normal_W.transpose() * trial.tracked_W);
  double noise_m2 = 0;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const Eigen::VectorXd places_m = along.row(axis);
    const std::span<const double> samples(places_m.data(), static_cast<std::size_t>(places_m.size()));
    const double noise_m = sample_noise(samples);
    noise_m2 += noise_m * noise_m / 2;  // the plane's two axes
    along.row(axis).array() -= median_of(samples);
  }
  const Eigen::RowVectorXd off_m = along.colwise().norm();
  return quantile({off_m.data(), static_cast<std::size_t>(off_m.size())}, share) >
         std::max(least_m, deviations * std::sqrt(noise_m2));
}

const Points& finger_W(const RecordedTrial& trial) {
  return is_tracked_along_plate(trial) ? trial.tracked_W : trial.position_W;
}

std::optional<double> take_tracked_places(RecordedTrial& trial) {
  constexpr double surely = 0.5;  // of the mean normal force
  const Eigen::RowVectorXd normal_n = trial.normal_W.transpose() * trial.force_W;
  const double least_n = surely * normal_n.cwiseMax(0).mean();
  take_contact_points(trial);
  double squares = 0, count = 0;
  for (Eigen::Index i = 0; i < trial.samples(); ++i) {
    if (!(normal_n[i] > least_n)) continue;
    squares += (trial.position_W.col(i) - trial.tracked_W.col(i)).squaredNorm();
    ++count;
  }
  trial.position_W = trial.tracked_W;
  trial.tracked_W.resize(3, 0);
  trial.torque_W_n_m.resize(3, 0);
  trial.sensor.reset();
  if (count == 0) return std::nullopt;
  return std::sqrt(squares / count);
}

void take_contact_points(RecordedTrial& trial) {
  for (Eigen::Index i = 0; i < trial.samples(); ++i)
    trial.position_W.col(i) = contact_point(*trial.sensor, trial.normal_W, trial.force_W.col(i),
                                            trial.torque_W_n_m.col(i), trial.tracked_W.col(i));
}

void take_wrench(const SixAxisSensor& sensor, const Vec3* torque_S_n_m, RecordedRow& row) {
  row.force_W = sensor.rotation_WS * row.force_W;
  if (torque_S_n_m == nullptr) return;
  row.wrench = {{sensor.origin_W, sensor.plate_height_m}, sensor.rotation_WS * *torque_S_n_m, row.position_W};
  row.position_W =
      contact_point(row.wrench->sensor, row.normal_W, row.force_W, row.wrench->torque_W_n_m, row.position_W);
}

}  // namespace fingerpad
