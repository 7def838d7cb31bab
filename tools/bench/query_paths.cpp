#include "query_paths.hpp"

#include <algorithm>
#include <cmath>

#include "base/random_stream.hpp"

namespace fingerpad::bench {
namespace {

constexpr double step_m = 1e-4;  // 0.1 m/s at 1 kHz
constexpr double sway_m = 2e-3;

double sway(int i) {
  return sway_m * std::sin(0.0137 * i);
}

}  // namespace

std::vector<Vec3> coherent_on_sphere(int count) {
  std::vector<Vec3> points;
  double longitude = 0, latitude = 0;
  for (int i = 0; i < count; ++i) {
    const double heading = 2.0 * std::sin(1e-3 * i) + 0.3;
    latitude = std::clamp(latitude + step_m / 0.5 * std::sin(heading), -1.4, 1.4);
    longitude += step_m / 0.5 * std::cos(heading) / std::cos(latitude);
    const Vec3 out(std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
                   std::sin(latitude));
    points.emplace_back((0.5 + sway(i)) * out);
  }
  return points;
}

std::vector<Vec3> coherent_on_plate(int count) {
  std::vector<Vec3> points;
  // Back and forth on slanted lines over the upper face, over holes and between them.
  double x = 0.01, y = -0.2, vx = 0.8, vy = 0.6;
  for (int i = 0; i < count; ++i) {
    if (std::abs(x + vx * step_m) > 0.49) vx = -vx;
    if (std::abs(y + vy * step_m) > 0.30) vy = -vy;
    x += vx * step_m;
    y += vy * step_m;
    points.emplace_back(x, y, 0.005 + sway(i));
  }
  return points;
}

std::vector<Vec3> random_in_box(const Part& part, int count) {
  RandomStream random(1);
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    const Vec3 unit(2 * random.uniform() - 1, 2 * random.uniform() - 1, 2 * random.uniform() - 1);
    points.emplace_back(unit.cwiseProduct(part.half_extent));
  }
  return points;
}

}  // namespace fingerpad::bench
