#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "base/types.hpp"

namespace fingerpad {

struct Part;
class TriangleTree;

/// One of the places, of equal area each, at which a part's facets are held against the smooth surface that
/// they stand for: the curved patch over the facet (curved_patch.hpp), as far as a mesh tells it. On flat
/// faces all is 0.
struct SurfacePlace {
  double sag_m = 0;       ///< how far the facet stands off the patch
  double facet_rad = 0;   ///< the facet's normal off the patch's shown one
  double smooth_rad = 0;  ///< the corners' normals, interpolated, off it
  double patch_rad = 0;   ///< the patch's own normal off it: how badly the patch fits its corners' normals
  double width_m = 0;     ///< of the facet, over its longest edge
  double curvature_per_m = 0;  ///< along the way in which the facet leans; > 0 where it is convex
  double across_per_m = 0;     ///< across that way
  int triangle = -1;           ///< the facet's number
  bool is_told = true;         ///< false: of a facet whose normal is noise; all that is off is a right angle
  int region = 0;              ///< which of the cubes it lies in, an eighth of the part's longest side wide

  bool operator==(const SurfacePlace&) const = default;
};

/// How far curved normals are off the surface itself where it turns over from convex to concave: so many
/// times what the patch's own normal is off the shown one. Arcs of one radius in even facets make 0.65 of it
/// (study contact: bend); of unlike radii, in uneven facets, at the most about this.
inline double curved_off_rad(const SurfacePlace& place) noexcept {
  constexpr double off_per_patch = 0.95;
  return off_per_patch * place.patch_rad;
}
/// Likewise how far normals are off it that are held against curved ones, beside what they are off these: 0.8
/// on such arcs.
inline double off_with_curved_rad(const SurfacePlace& place) noexcept {
  constexpr double off_per_patch = 1.05;
  return off_per_patch * place.patch_rad;
}

/// The region that a point of the part lies in.
/// @param x  relative to the part's centre [m]
int region_of(const Part& part, const Vec3& x) noexcept;

/// Whether a box reaches into a region.
/// @param low, high  its corners, relative to the part's centre [m]
bool reaches_region(const Part& part, const Vec3& low, const Vec3& high, int region) noexcept;

/// Region by region. At 16,384 places, and at no more than 64 times the triangles. On all threads, the same
/// on any number of them. A facet that is lower than this over its longest edge has no normal that is
/// believed; near a file's origin it has no place either, for it is a sliver whose neighbours tell the
/// surface (is_far_off).
std::vector<SurfacePlace> surface_places(const TriangleTree& tree, double trusted_height_m);

/// Calls take(places of one region) for each.
/// @param places  region by region
template <class Take>
void each_region(std::span<const SurfacePlace> places, Take take) {
  for (auto first = places.begin(), end = first; first != places.end(); first = end) {
    end = std::find_if(first, places.end(),
                       [&](const SurfacePlace& place) { return place.region != first->region; });
    take(std::span(first, end));
  }
}

/// Whether a region has less than a two-thousandth of a part's places: too few to judge it by.
inline bool is_too_small(std::span<const SurfacePlace> region, std::span<const SurfacePlace> all) noexcept {
  return region.size() < all.size() / 2000;
}

/// Of the places in a region, where that is the most: those of facets whose normal is not believed. Regions
/// that are too small do not count.
/// @param places  region by region
double untold_share(std::span<const SurfacePlace> places) noexcept;

}  // namespace fingerpad
