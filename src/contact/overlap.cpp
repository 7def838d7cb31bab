#include "contact/overlap.hpp"

#include <algorithm>

#include "base/random_stream.hpp"
#include "part/part.hpp"
#include "part/random_places.hpp"

namespace fingerpad {
namespace {

constexpr int most_points = 2000;

/// Vertices, and places all over the facets [m], frame W.
std::vector<Vec3> points_of(const PlacedSurface& surface) {
  const Part& part = *surface.part;
  std::vector<Vec3> points;
  const auto add = [&](const Vec3& p_P) { points.emplace_back(surface.p_WP + surface.R_WP * p_P); };
  const Eigen::Index vertices = part.vertices.cols();
  const Eigen::Index step = std::max<Eigen::Index>(1, vertices / most_points);
  for (Eigen::Index i = 0; i < vertices; i += step) add(part.centre_P + part.vertices.col(i));
  const RandomPlaces places(part);
  RandomStream random(1);
  for (int i = 0; i < most_points; ++i) add(places.point(places.triangle(random), part.centre_P, random));
  return points;
}

/// How deep the points of one surface lie behind another.
void look_for_depth(const PlacedSurface& behind, std::span<const Vec3> points, Overlap& overlap) {
  const bool is_open = behind.part && behind.part->neighbours.minCoeff() < 0;
  if (is_open) return;
  for (const Vec3& p_W : points) {
    const WorldPoint nearest = nearest_point(behind, p_W, Normals::facet, -1, 0);
    if (!nearest.found || -nearest.signed_distance_m <= overlap.depth_m) continue;
    overlap.depth_m = -nearest.signed_distance_m;
    overlap.at_W = p_W;
  }
}

double length_m(const PlacedSurface& surface) {
  return 2 * surface.part->half_extent.maxCoeff();
}

}  // namespace

std::vector<Overlap> overlaps(std::span<const PlacedSurface> surfaces) {
  constexpr double notable_share = 0.02;
  std::vector<std::vector<Vec3>> points(surfaces.size());
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    if (!surfaces[i].is_plane()) points[i] = points_of(surfaces[i]);
  std::vector<Overlap> found;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    for (std::size_t k = i + 1; k < surfaces.size(); ++k) {
      if (surfaces[i].is_plane()) continue;  // planes stand last
      Overlap overlap{i, k, 0, Vec3::Zero()};
      look_for_depth(surfaces[k], points[i], overlap);
      look_for_depth(surfaces[i], points[k], overlap);
      const double smaller_m = surfaces[k].is_plane()
                                   ? length_m(surfaces[i])
                                   : std::min(length_m(surfaces[i]), length_m(surfaces[k]));
      if (overlap.depth_m > notable_share * smaller_m) found.push_back(overlap);
    }
  }
  return found;
}

}  // namespace fingerpad
