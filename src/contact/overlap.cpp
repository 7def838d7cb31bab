#include "contact/overlap.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/random_stream.hpp"
#include "part/part.hpp"
#include "part/random_places.hpp"

namespace fingerpad {
namespace {

double length_m(const PlacedSurface& surface) {
  return 2 * surface.part->half_extent.maxCoeff();
}

constexpr int most_points = 2000;
constexpr double notable_share = 0.02;
/// How far below a part's surface it is looked at too, in units of its greatest length: bodies that coincide
/// have no point of their surfaces inside the other.
constexpr std::array insets{0.025, 0.08, 0.25};

/// Places on a part's surface and within it [m], frame W.
struct Places {
  std::vector<Vec3> on, within;
};

Places places_of(const PlacedSurface& surface) {
  const Part& part = *surface.part;
  Places found;
  const auto in_world = [&](const Vec3& p_P) -> Vec3 { return surface.p_WP + surface.R_WP * p_P; };
  const Eigen::Index vertices = part.vertices.cols();
  const Eigen::Index step = std::max<Eigen::Index>(1, (vertices + most_points - 1) / most_points);
  for (Eigen::Index i = 0; i < vertices; i += step)
    found.on.push_back(in_world(part.centre_P + part.vertices.col(i)));
  const RandomPlaces places(part);
  RandomStream random(1);
  for (int i = 0; i < most_points; ++i) {
    const int triangle = places.triangle(random);
    const Vec3 on_P = places.point(triangle, part.centre_P, random);
    found.on.push_back(in_world(on_P));
    for (const double inset : insets)
      found.within.push_back(in_world(on_P - inset * length_m(surface) * part.facet_normals.col(triangle)));
  }
  return found;
}

/// Whether it tells inside from outside: it is closed, and its facets look out.
bool has_inside(const PlacedSurface& surface) {
  if (surface.is_plane()) return true;
  const Part& part = *surface.part;
  if (part.neighbours.minCoeff() < 0) return false;
  double volume_6 = 0;
  for (Eigen::Index t = 0; t < part.triangles.cols(); ++t) {
    const auto corner = [&](int k) -> Vec3 { return part.vertices.col(part.triangles(k, t)); };
    volume_6 += corner(0).dot(corner(1).cross(corner(2)));
  }
  return volume_6 > 0;
}

/// How deep a point lies behind a surface; negative in front of it.
double depth_of(const Vec3& p_W, const PlacedSurface& behind) {
  const WorldPoint nearest = nearest_point(behind, p_W, Normals::facet, -1, 0);
  return nearest.found ? -nearest.signed_distance_m : -HUGE_VAL;
}

/// How deep the places of one part lie behind another surface; of those within it no deeper than they lie in
/// that part itself.
void look_for_depth(const PlacedSurface& part, const Places& places, const PlacedSurface& behind,
                    Overlap& overlap) {
  if (!has_inside(behind)) return;
  const auto take = [&](double depth_m, const Vec3& p_W) {
    if (depth_m <= overlap.depth_m) return;
    overlap.depth_m = depth_m;
    overlap.at_W = p_W;
  };
  for (const Vec3& p_W : places.on) take(depth_of(p_W, behind), p_W);
  if (behind.is_plane() || !has_inside(part)) return;
  for (const Vec3& p_W : places.within) {
    const double depth_m = depth_of(p_W, behind);
    if (depth_m > overlap.depth_m) take(std::min(depth_m, depth_of(p_W, part)), p_W);
  }
}

}  // namespace

std::vector<Overlap> overlaps(std::span<const PlacedSurface> surfaces) {
  std::vector<Places> places(surfaces.size());
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    if (!surfaces[i].is_plane()) places[i] = places_of(surfaces[i]);
  std::vector<Overlap> found;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    for (std::size_t k = i + 1; k < surfaces.size(); ++k) {
      if (surfaces[i].is_plane()) continue;  // planes stand last
      Overlap overlap{i, k, 0, Vec3::Zero()};
      look_for_depth(surfaces[i], places[i], surfaces[k], overlap);
      if (!surfaces[k].is_plane()) look_for_depth(surfaces[k], places[k], surfaces[i], overlap);
      const double smaller_m = surfaces[k].is_plane()
                                   ? length_m(surfaces[i])
                                   : std::min(length_m(surfaces[i]), length_m(surfaces[k]));
      if (overlap.depth_m > notable_share * smaller_m) found.push_back(overlap);
    }
  }
  return found;
}

}  // namespace fingerpad
