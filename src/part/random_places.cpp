#include "part/random_places.hpp"

#include <Eigen/Geometry>
#include <cstddef>

namespace fingerpad {

RandomPlaces::RandomPlaces(const Part& part) : part_(part) {
  areas_.reserve(static_cast<std::size_t>(part.triangle_count()));
  double sum = 0;
  for (int t = 0; t < part.triangle_count(); ++t) {
    const Vec3 a = corner(t, 0);
    areas_.push_back(sum += (corner(t, 1) - a).cross(corner(t, 2) - a).norm());
  }
  // Chen & Asau 1974: a draw begins at its share's first triangle, so that it looks at few, however many
  // there are.
  first_.reserve(areas_.size());
  const double share = sum / static_cast<double>(areas_.size());
  std::size_t t = 0;
  for (std::size_t k = 0; k < areas_.size(); ++k) {
    while (t + 1 < areas_.size() && areas_[t] <= static_cast<double>(k) * share) ++t;
    first_.push_back(static_cast<int>(t));
  }
}

int RandomPlaces::triangle(RandomStream& random) const {
  const double drawn = random.uniform(), area = drawn * areas_.back();
  auto t =
      static_cast<std::size_t>(first_[static_cast<std::size_t>(drawn * static_cast<double>(areas_.size()))]);
  while (t > 0 && areas_[t - 1] > area) --t;  // where rounding has put it a share on
  while (t + 1 < areas_.size() && areas_[t] <= area) ++t;
  return static_cast<int>(t);
}

Vec3 RandomPlaces::point(int t, const Vec3& origin, RandomStream& random) const {
  double u = random.uniform(), v = random.uniform();
  if (u + v > 1) u = 1 - u, v = 1 - v;
  const Vec3 a = corner(t, 0);
  return origin + a + u * (corner(t, 1) - a) + v * (corner(t, 2) - a);
}

void RandomPlaces::pass_point(RandomStream& random) {
  random.uniform();
  random.uniform();
}

}  // namespace fingerpad
