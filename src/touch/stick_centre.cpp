#include "touch/stick_centre.hpp"

#include "contact/triangle_tree.hpp"

namespace fingerpad {
namespace {

/// That the search for its place may take: a trace shows it, no force depends on it.
constexpr long most_looks = 2000;

}  // namespace

void StickCentre::place(const PlacedSurface& surface, const Vec3& contact_W, const Vec3& stretch_W,
                        Normals normals, int contact_triangle) noexcept {
  const Vec3 target = contact_W - stretch_W;
  drag(target);
  const double distance = stretch_W.norm();
  if (surface.is_plane() || !(distance > 0)) return;
  // Mostly the centre comes to lie on the facet that S is on: then nothing need be searched.
  // Where a surface of the normals' own stands for the facets it must be; shading moves no point.
  const Normals place_only = normals->own_surface == nullptr ? Normals::facet : normals;
  WorldPoint near = nearest_on_facet(surface, contact_triangle, target, place_only);
  if (!near.found) {
    BriefSearch search{most_looks, contact_triangle};
    near = nearest_point(surface, target, place_only, search, distance);
  }
  if (near.found && (near.point_W - target).norm() < distance) drag(near.point_W);
}

}  // namespace fingerpad
