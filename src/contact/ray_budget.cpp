#include "contact/ray_budget.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fingerpad {
namespace {

/// Rays that are tried, from facets evenly spread over the part's list.
constexpr int trials = 16;
/// Looks at a triangle that all rays together may cost: some ten nanoseconds each.
constexpr double most_looks = 1e8;

/// Whether a ray passes the box of triangle t.
bool passes_box(const Part& part, int t, const Vec3& from, const Vec3& inverse_direction) noexcept {
  double begin = 0, end = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const double a = part.vertices(i, part.triangles(0, t)), b = part.vertices(i, part.triangles(1, t)),
                 c = part.vertices(i, part.triangles(2, t));
    const double low = (std::min({a, b, c}) - from[i]) * inverse_direction[i],
                 high = (std::max({a, b, c}) - from[i]) * inverse_direction[i];
    begin = std::max(begin, std::min(low, high));
    end = std::min(end, std::max(low, high));
  }
  return begin <= end;
}

/// Triangles whose boxes the ray straight in from the middle of facet t passes.
long looks_from(const Part& part, int t) noexcept {
  Vec3 middle = Vec3::Zero();
  for (int k = 0; k < 3; ++k) middle += part.vertices.col(part.triangles(k, t)) / 3;
  // Along an axis that the ray does not go it still moves a little: 0 times infinity is no number.
  const Vec3 inverse = (-part.facet_normals.col(t)).unaryExpr([](double d) {
    return 1 / std::copysign(std::max(std::abs(d), 1e-12), d);
  });
  long looks = 0;
  for (int other = 0; other < part.triangle_count(); ++other)
    looks += passes_box(part, other, middle, inverse) ? 1 : 0;
  return looks;
}

}  // namespace

int affordable_rays(const Part& part) {
  const int count = part.triangle_count();
  if (count == 0) return 1;
  double looks = 0;
  for (int i = 0; i < trials; ++i)
    looks += static_cast<double>(looks_from(part, static_cast<int>((i + 0.5) / trials * count)));
  return static_cast<int>(std::clamp(most_looks * trials / std::max(looks, 1.0), 1.0, 1e9));
}

}  // namespace fingerpad
