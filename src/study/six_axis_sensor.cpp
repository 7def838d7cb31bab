#include "study/six_axis_sensor.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace fingerpad {

void take_wrench(const SixAxisSensor& sensor, const Vec3* torque_S_n_m, RecordedRow& row) {
  const Vec3 force_W = sensor.rotation_WS * row.force_W;
  row.force_W = force_W;
  if (torque_S_n_m == nullptr) return;
  const Vec3 torque_W = sensor.rotation_WS * *torque_S_n_m;
  const Vec3& n = row.normal_W;
  const double height_m = sensor.plate_height_m - n.dot(sensor.origin_W), normal_n = n.dot(force_W);
  // Of all points r on the line of the force the moment is tau = r x f + m n, with m the free moment about
  // the normal. n x (r x f) = r (n.f) - f (n.r), so that r = (n x tau + h f)/(n.f) with h = n.r: McCarthy
  // 1990's centre of pressure. Its height along the normal is not told by the force.
  const Vec3 contact = (n.cross(torque_W) + height_m * force_W) / normal_n;
  if (std::abs(normal_n) > 0.05 && contact.allFinite())
    row.position_W = sensor.origin_W + contact + n * n.dot(row.position_W - sensor.origin_W - contact);
}

}  // namespace fingerpad
