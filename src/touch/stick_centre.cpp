#include "touch/stick_centre.hpp"

#include <cmath>

#include "contact/triangle_tree.hpp"

namespace fingerpad {
namespace {

/// A foot is near within this share of the stretch.
constexpr double near_share = 0.1;

}  // namespace

void StickCentre::place(const PlacedSurface& surface, const Vec3& contact_W, const Vec3& stretch_W,
                        Normals normals, int contact_triangle, FacetsAtHand& facets,
                        const Search& search) noexcept {
  const Vec3 target = contact_W - stretch_W;
  drag(target);
  const double distance2 = stretch_W.squaredNorm();
  if (surface.is_plane() || !(distance2 > 0)) return;
  const auto put = [&](const Vec3& near) {
    if ((near - target).squaredNorm() < distance2) point_W_ = near;
  };
  // Mostly the centre comes to lie on the facet that S is on, or near it: then nothing need be searched.
  // Where a surface of the normals' own stands for the facets it must be; shading moves no point.
  const bool is_on_facets = normals->own_surface == nullptr;
  if (is_on_facets && contact_triangle >= 0) {
    Vec3 foot;
    // Not of a foot that lies far off: another facet, at which the way there did not look, may be nearer.
    if (facets.find_foot(surface, contact_triangle, target, foot) &&
        (foot - target).squaredNorm() < near_share * near_share * distance2)
      return put(foot);
  }
  const Normals by = is_on_facets ? Normals::facet : normals;
  const double reach_m = std::sqrt(distance2);
  BriefSearch brief{search.most_looks, contact_triangle, &facets.around(), search.memory};
  // Where no looks are counted the tree finds it sooner than what is kept of the last search, some ticks
  // back.
  const WorldPoint near = search.most_looks == Looks::unlimited
                              ? nearest_point(surface, target, by, contact_triangle, reach_m)
                              : nearest_point(surface, target, by, brief, reach_m);
  if (near.found) put(near.point_W);
}

}  // namespace fingerpad
