#include "view/triangles_in_sight.hpp"

#include <algorithm>
#include <cmath>

#include "contact/triangle_tree.hpp"
#include "part/part.hpp"

namespace fingerpad {
namespace {

/// The ball about a triangle's middle that holds its corners reaches into the beam; part frame.
bool may_be_in_beam(const Part& part, int triangle, const Vec3& from, const Vec3& along, double radius_m) {
  const Vec3 a = part.vertices.col(part.triangles(0, triangle)),
             b = part.vertices.col(part.triangles(1, triangle)),
             c = part.vertices.col(part.triangles(2, triangle)), middle = (a + b + c) / 3;
  const double size_m = std::sqrt(
      std::max({(a - middle).squaredNorm(), (b - middle).squaredNorm(), (c - middle).squaredNorm()}));
  const Vec3 way = middle - from;
  return (way - way.dot(along) * along).norm() <= radius_m + size_m;
}

}  // namespace

std::vector<int> triangles_in_sight(const Surface& surface, const CloseUpSight& sight) {
  std::vector<int> found;
  const Part& part = *surface.part;
  if (!surface.tree) {
    for (int t = 0; t < part.triangle_count(); ++t) found.push_back(t);
    return found;
  }
  const Vec3 q = surface.R_WP.transpose() * (sight.contact_W - surface.p_WP) - part.centre_P;
  const Vec3 along = surface.R_WP.transpose() * sight.normal_W;
  surface.tree->each_within(
      q, sight.reach_m,
      [](void* list, int triangle) { static_cast<std::vector<int>*>(list)->push_back(triangle); }, &found);
  std::erase_if(found, [&](int t) { return !may_be_in_beam(part, t, q, along, sight.across_m); });
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace fingerpad
