#pragma once

#include <limits>

#include "contact/normals.hpp"

namespace fingerpad {

class ClosestMemory;
struct BriefSearch;
struct ClosestTriangle;
struct FacetView;
struct Part;

/// Where a point stands against a surface, frame P (the file's frame, not re-centred).
struct SurfacePoint {
  Vec3 point_P = Vec3::Zero();    ///< S, the nearest surface point [m]
  Vec3 normal_P = Vec3::UnitZ();  ///< outward, unit, as `Normals` says
  Vec3 pseudonormal_P =
      Vec3::UnitZ();  ///< angle-weighted, of the closest feature, unit; its side gives the sign
  double signed_distance_m = std::numeric_limits<double>::infinity();  ///< < 0 inside
  int triangle = -1;  ///< index into Part::triangles; -1: a plane, or nothing within reach
};

/// The nearest surface point of a part.
///
/// The sign is the side of the angle-weighted pseudonormal of the closest feature (Baerentzen & Aanaes 2005):
/// right wherever the part bounds a solid, also where bodies touch in a point. Where its surface crosses
/// itself or whole shells overlap, a point has the sign of the sheet that is nearest.
/// `curved`: `triangle` is the one whose patch the point lies on, and the sign is the facets' wherever they
/// are farther off than the patch strays from them; between the two it is the side of the patch.
/// @param p_P      where [m], frame P; one whose distance no double can hold has no nearest point
/// @param seed     see TriangleTree::closest
/// @param reach_m  where the distance is larger than this, `triangle` is -1 and the distance infinite; points
///                 inside are always answered
/// noexcept, allocates nothing.
SurfacePoint nearest_surface_point(const TriangleTree& tree, const Vec3& p_P, Normals normals, int seed,
                                   double reach_m) noexcept;

/// The same along a path; see TriangleTree::closest.
SurfacePoint nearest_surface_point(const TriangleTree& tree, const Vec3& p_P, Normals normals,
                                   ClosestMemory& memory, double reach_m) noexcept;
SurfacePoint nearest_surface_point(const TriangleTree& tree, const Vec3& p_P, Normals normals,
                                   BriefSearch& search, double reach_m) noexcept;

/// What the closest triangle says, where that is known already: nearest_surface_point's answer.
/// @param closest  to p_P, of the tree
SurfacePoint surface_point_at(const TriangleTree& tree, const ClosestTriangle& closest, const Vec3& p_P,
                              Normals normals, double reach_m) noexcept;

/// A point of a facet.
struct FacetFoot {
  Vec3 point_P = Vec3::Zero();
  int triangle = -1;  ///< -1: there is none
};

/// The point under p_P of the first of these that has one:
///   triangle t's facet;
///   those that the way from there to p_P leads over, edge by edge: one beyond a crease, or two where none is
///   one, or some more where the surface hardly turns on the way (triangles in one plane count as one facet);
///   the one across the edge of t that is nearest to p_P.
/// No other triangle is looked at: one may be nearer.
/// noexcept, allocates nothing.
FacetFoot foot_on_facet(const Part& part, int t, const Vec3& p_P) noexcept;
/// The same of a facet that was looked at from there.
/// @param view  of triangle t, from p_P relative to the part's centre
FacetFoot foot_on_facet(const Part& part, int t, const FacetView& view) noexcept;

/// The normal at a point of triangle t of the tree's part as `normals` says: the facet rule's where that is
/// asked for, and at creases and sharp vertices.
/// @param facet_normal_P  what the facet rule gives there, on the facets' outer side, unit
/// noexcept, allocates nothing.
Vec3 shaded_normal(const TriangleTree& tree, int t, const TrianglePoint& at, Normals normals,
                   const Vec3& facet_normal_P) noexcept;

/// The nearest point of a plane through `point_P` with outward unit normal. Inside is the half space behind
/// it.
SurfacePoint nearest_plane_point(const Vec3& point_P, const Vec3& normal_P, const Vec3& p_P) noexcept;

}  // namespace fingerpad
