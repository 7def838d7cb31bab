#include "tick_walks.hpp"

#include <algorithm>
#include <cmath>

#include "base/random_stream.hpp"

namespace fingerpad::bench {
namespace {

constexpr double dt_s = 1e-3, pressed_m = 2e-4;

Vec3 any(RandomStream& random) {
  return {random.normal(), random.normal(), random.normal()};
}

Vec3 in_box(const Part& part, RandomStream& random) {
  const Vec3 unit(2 * random.uniform() - 1, 2 * random.uniform() - 1, 2 * random.uniform() - 1);
  return part.centre_P + unit.cwiseProduct(part.half_extent);
}

int any_triangle(const Part& part, RandomStream& random) {
  return std::min(static_cast<int>(random.uniform() * part.triangle_count()), part.triangle_count() - 1);
}

/// Where a ball stands that is pressed in at the middle of a facet.
Vec3 pressed_at(const Part& part, int t, double radius_m) {
  Vec3 middle = Vec3::Zero();
  for (int k = 0; k < 3; ++k) middle += part.vertices.col(part.triangles(k, t)) / 3;
  return part.centre_P + middle + (radius_m - pressed_m) * part.facet_normals.col(t);
}

/// From facet to facet: to one beside it most of the time, so that it stays on the surface.
std::vector<Vec3> rub(const Part& part, double radius_m, int ticks) {
  RandomStream random(3);
  constexpr double step_m = 1e-4;
  int triangle = any_triangle(part, random);
  Vec3 at = pressed_at(part, triangle, radius_m + 2e-3), aim = pressed_at(part, triangle, radius_m);
  std::vector<Vec3> places;
  for (int k = 0; k < ticks; ++k) {
    while ((aim - at).norm() < step_m && random.uniform() < 0.9) {
      const int next = part.neighbours(static_cast<int>(3 * random.uniform()) % 3, triangle);
      triangle = next >= 0 ? next : any_triangle(part, random);
      aim = pressed_at(part, triangle, radius_m);
    }
    const Vec3 way = aim - at;
    at += way * std::min(1.0, step_m / std::max(way.norm(), 1e-12)) + 2e-6 * any(random);
    places.push_back(at);
  }
  return places;
}

std::vector<Vec3> strike(const Part& part, int ticks) {
  RandomStream random(5);
  const double size_m = part.half_extent.norm();
  Vec3 at = part.centre_P + 1.2 * size_m * any(random).normalized(), velocity = Vec3::Zero();
  std::vector<Vec3> places;
  for (int k = 0; k < ticks; ++k) {
    if (k % 40 == 0) {
      const double speed = std::min(5.0, size_m / (20 * dt_s)) * (0.2 + 0.8 * random.uniform());
      velocity = speed * (in_box(part, random) - at).normalized();
    }
    places.push_back(at += velocity * dt_s);
  }
  return places;
}

std::vector<Vec3> jump(const Part& part, double radius_m, int ticks) {
  RandomStream random(9);
  Vec3 at = part.centre_P;
  std::vector<Vec3> places;
  for (int k = 0; k < ticks; ++k) {
    if (k % 16 == 0) at = in_box(part, random);
    if (k % 16 == 8) at = pressed_at(part, any_triangle(part, random), radius_m);
    places.push_back(at += 1e-5 * any(random));
  }
  return places;
}

}  // namespace

std::vector<TickWalk> tick_walks(const Part& part, double radius_m, int ticks) {
  return {{"rub", rub(part, radius_m, ticks)},
          {"strike", strike(part, ticks)},
          {"jump", jump(part, radius_m, ticks)}};
}

}  // namespace fingerpad::bench
