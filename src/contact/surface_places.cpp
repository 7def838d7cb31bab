#include "contact/surface_places.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "contact/curved_patch.hpp"
#include "contact/edge_measures.hpp"
#include "contact/normals.hpp"
#include "contact/triangle_tree.hpp"

namespace fingerpad {
namespace {

constexpr std::size_t most_places = 16384, most_per_triangle = 64;
constexpr int regions_along = 8;
/// A facet that leans by less is flat: its curvature is rounding.
constexpr double flat_rad = 1e-6;

struct FacetShape {
  double area_m2 = 0, height_m = 0;
};

FacetShape shape_of(const Part& part, int t) {
  const Vec3 p = part.vertices.col(part.triangles(0, t));
  const Vec3 a = part.vertices.col(part.triangles(1, t)) - p, b = part.vertices.col(part.triangles(2, t)) - p;
  const double doubled_m2 = a.cross(b).norm();
  const double longest_m = std::sqrt(std::max({a.squaredNorm(), b.squaredNorm(), (b - a).squaredNorm()}));
  return {doubled_m2 / 2, longest_m > 0 ? doubled_m2 / longest_m : 0};
}

double angle_of(const Vec3& a, const Vec3& b) {
  return 2 * std::asin(std::min(1.0, (a - b).norm() / 2));
}

/// How fast the corners' normals turn along a direction in the facet, > 0 where they spread (Rusinkiewicz
/// 2004). Not the patch's own second derivatives: they are off by as much as there is.
double curvature_along(const CurvedPatch& patch, const Vec3& direction) {
  const Vec3 e1 = patch.control[1] - patch.control[0], e2 = patch.control[2] - patch.control[0];
  const double e = e1.squaredNorm(), f = e1.dot(e2), g = e2.squaredNorm(), det = e * g - f * f;
  const double length2 = direction.squaredNorm();
  if (!(det > 0) || !(length2 > 0)) return 0;
  const double d1 = direction.dot(e1), d2 = direction.dot(e2);
  const Vec3 turned = ((g * d1 - f * d2) * (patch.corner_normal[1] - patch.corner_normal[0]) +
                       (e * d2 - f * d1) * (patch.corner_normal[2] - patch.corner_normal[0])) /
                      det;
  return turned.dot(direction) / length2;
}

/// On a facet of whose normal nothing is known.
SurfacePlace untold_place(const Part& part, int t, const Vec3& b) {
  SurfacePlace place;
  place.facet_rad = place.smooth_rad = place.patch_rad = std::numbers::pi / 2;
  place.is_told = false;
  place.triangle = t;
  Vec3 at = Vec3::Zero();
  for (int k = 0; k < 3; ++k) at += b[k] * part.vertices.col(part.triangles(k, t));
  place.region = region_of(part, at);
  return place;
}

/// A triangle on which places lie.
struct PlacedOn {
  int triangle = -1;
  double width_m = 0;
  CurvedPatch patch;  ///< where it is wide enough to tell of the surface
};

/// @param b  barycentric coordinates of the place on the triangle
SurfacePlace place_on(const TriangleTree& tree, const PlacedOn& on_triangle, const Vec3& b) {
  const Part& part = tree.part();
  const int t = on_triangle.triangle;
  const CurvedPatch& patch = on_triangle.patch;
  const Vec3 facet = part.facet_normals.col(t);
  SurfacePlace place;
  const Vec3 curved = shown_normal(patch, b, facet);
  TrianglePoint at;
  at.feature = Feature::face;
  at.barycentric = b;
  const PatchPoint on = evaluate(patch, b);
  const Vec3 flat = b[0] * patch.control[0] + b[1] * patch.control[1] + b[2] * patch.control[2];
  place.sag_m = std::abs((on.x - flat).dot(facet));
  place.facet_rad = angle_of(facet, curved);
  place.smooth_rad = angle_of(normals_smooth.shade(tree, t, at, facet), curved);
  const Vec3 cross = on.x1.cross(on.x2);
  // Of a folded patch nothing is known.
  place.patch_rad = cross.dot(facet) > 0 ? angle_of(cross.normalized(), curved) : std::numbers::pi / 2;
  if (place.facet_rad > flat_rad) {
    const Vec3 leaning = curved - curved.dot(facet) * facet;
    place.curvature_per_m = curvature_along(patch, leaning);
    place.across_per_m = curvature_along(patch, facet.cross(leaning));
  }
  place.width_m = on_triangle.width_m;
  if (!std::isfinite(place.sag_m + place.curvature_per_m + place.across_per_m)) place = {};
  place.triangle = t;
  place.region = region_of(part, flat);
  return place;
}

/// The corners' normals of patches at so many places: all of them, where that is quicker than those of each
/// patch by themselves. A patch asks for those of nine fans, each of which looks at some ten more; in a
/// table, of half as many fans as there are triangles, each is looked at a few times.
class NormalsForPlaces {
 public:
  NormalsForPlaces(const TriangleTree& tree, std::size_t places) : part_(tree.part()) {
    constexpr std::size_t triangles_a_place = 64;
    if (tree.curved_normals() != nullptr) {
      table_ = tree.curved_normals();
    } else if (static_cast<std::size_t>(part_.triangle_count()) < triangles_a_place * places) {
      own_ = curved_corner_normals(part_);
      table_ = &own_;
    }
  }
  NormalsForPlaces(const NormalsForPlaces&) = delete;
  NormalsForPlaces& operator=(const NormalsForPlaces&) = delete;
  CornerNormals operator()() const noexcept { return {part_, table_}; }

 private:
  const Part& part_;
  Points own_;
  const Points* table_ = nullptr;
};

/// Which of the cubes along each axis a point of the part lies in.
std::array<int, 3> cube_of(const Part& part, const Vec3& x) noexcept {
  const double wide_m = 2 * part.half_extent.maxCoeff() / regions_along;
  std::array<int, 3> cube;
  for (int i = 0; i < 3; ++i) {
    const auto along = static_cast<int>((x[i] + part.half_extent[i]) / wide_m);
    cube[static_cast<std::size_t>(i)] = std::clamp(along, 0, regions_along - 1);
  }
  return cube;
}

/// Spread evenly over triangles, whatever their number: the R2 sequence (Roberts 2018), folded.
Vec3 spread(std::size_t i) {
  double u = std::fmod(0.5 + static_cast<double>(i) * 0.7548776662466927, 1.0);
  double v = std::fmod(0.5 + static_cast<double>(i) * 0.5698402909980532, 1.0);
  if (u + v > 1) {
    u = 1 - u;
    v = 1 - v;
  }
  return {1 - u - v, u, v};
}

/// Those of a region in the order in which they are.
std::vector<SurfacePlace> by_region(const std::vector<SurfacePlace>& places) {
  std::array<std::size_t, regions_along * regions_along * regions_along + 1> next{};
  for (const SurfacePlace& place : places) ++next[static_cast<std::size_t>(place.region) + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<SurfacePlace> ordered(places.size());
  for (const SurfacePlace& place : places) ordered[next[static_cast<std::size_t>(place.region)]++] = place;
  return ordered;
}

}  // namespace

int region_of(const Part& part, const Vec3& x) noexcept {
  const std::array<int, 3> cube = cube_of(part, x);
  return (cube[0] * regions_along + cube[1]) * regions_along + cube[2];
}

bool reaches_region(const Part& part, const Vec3& low, const Vec3& high, int region) noexcept {
  const std::array<int, 3> from = cube_of(part, low), to = cube_of(part, high);
  for (std::size_t i = 3; i-- > 0; region /= regions_along)
    if (region % regions_along < from[i] || region % regions_along > to[i]) return false;
  return true;
}

std::vector<SurfacePlace> surface_places(const TriangleTree& tree, double trusted_height_m) {
  const Part& part = tree.part();
  const bool tells_low = is_far_off(part);
  std::vector<double> sums_m2;
  sums_m2.reserve(static_cast<std::size_t>(part.triangle_count()));
  double sum_m2 = 0;
  for (int t = 0; t < part.triangle_count(); ++t) {
    const FacetShape shape = shape_of(part, t);
    const bool has_places = tells_low || shape.height_m > trusted_height_m;
    sums_m2.push_back(sum_m2 += has_places ? shape.area_m2 : 0);
  }
  const std::size_t count = std::min(most_places, most_per_triangle * sums_m2.size());
  std::vector<SurfacePlace> places(sum_m2 > 0 ? count : 0);
  const NormalsForPlaces normals(tree, places.size());
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, places.size(), 256),
      [&](const tbb::blocked_range<std::size_t>& range) {
        PlacedOn on;  // those of a triangle follow one another
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
          const double wanted_m2 = sum_m2 * (static_cast<double>(i) + 0.5) / static_cast<double>(count);
          const auto found = std::upper_bound(sums_m2.begin(), sums_m2.end() - 1, wanted_m2);
          const int t = static_cast<int>(found - sums_m2.begin());
          const bool is_told = shape_of(part, t).height_m > trusted_height_m;
          if (is_told && t != on.triangle) on = {t, shape_of(part, t).height_m, curved_patch(normals(), t)};
          places[i] = is_told ? place_on(tree, on, spread(i)) : untold_place(part, t, spread(i));
        }
      });
  return by_region(places);
}

double untold_share(std::span<const SurfacePlace> places) noexcept {
  double most = 0;
  each_region(places, [&](std::span<const SurfacePlace> region) {
    if (is_too_small(region, places)) return;
    const auto untold =
        std::count_if(region.begin(), region.end(), [](const SurfacePlace& place) { return !place.is_told; });
    most = std::max(most, static_cast<double>(untold) / static_cast<double>(region.size()));
  });
  return most;
}

}  // namespace fingerpad
