#include "part/random_places.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>

namespace fingerpad {

RandomPlaces::RandomPlaces(const Part& part) : part_(part) {
  areas_.reserve(static_cast<std::size_t>(part.triangle_count()));
  double sum = 0;
  for (int t = 0; t < part.triangle_count(); ++t) {
    const Vec3 a = corner(t, 0);
    areas_.push_back(sum += (corner(t, 1) - a).cross(corner(t, 2) - a).norm());
  }
}

int RandomPlaces::triangle(RandomStream& random) const {
  const auto at = std::upper_bound(areas_.begin(), areas_.end(), random.uniform() * areas_.back());
  return static_cast<int>(std::min(at - areas_.begin(), std::ssize(areas_) - 1));
}

Vec3 RandomPlaces::point(int t, const Vec3& origin, RandomStream& random) const {
  double u = random.uniform(), v = random.uniform();
  if (u + v > 1) u = 1 - u, v = 1 - v;
  const Vec3 a = corner(t, 0);
  return origin + a + u * (corner(t, 1) - a) + v * (corner(t, 2) - a);
}

}  // namespace fingerpad
