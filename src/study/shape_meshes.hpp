#pragma once

#include <vector>

#include "part/part.hpp"

// Meshes of known shapes, for studies: wound outwards.

namespace fingerpad {

/// A ball of facets about the origin, an octahedron split in four `subdivisions` times: 8 * 4^subdivisions
/// triangles, vertices on the sphere, wound outwards.
TriangleSoup ball_mesh(double radius_m, int subdivisions);

/// A torus about z: the radius of its ring and of its tube.
TriangleSoup torus_mesh(double ring_m, double tube_m, int around, int across);

/// A profile turned about z, with a point of the axis at each end.
/// @param profile  radius and height of each ring, from the top to the bottom
TriangleSoup revolved_mesh(const std::vector<Vec2>& profile, int around, double top_m, double bottom_m);

/// What lies under a profile down to a height, from -half_width_m to half_width_m along y; its top has two
/// triangles from one point of the profile to the next, as CAD tessellates what bends one way.
/// @param profile  x and z of each point, x rising
TriangleSoup bar_mesh(const std::vector<Vec2>& profile, double half_width_m, double bottom_m);

/// A block about the origin, its edges and corners rounded in `steps` facets a quarter turn; its flat sides,
/// which a CAD tessellation leaves whole, are of two triangles each.
/// @param inner_half_m  half its sizes, less the rounding
TriangleSoup rounded_block_mesh(const Vec3& inner_half_m, double rounding_m, int steps);

/// A mesh with a hollow: `inner` turned inside out.
TriangleSoup hollowed(const TriangleSoup& outer, const TriangleSoup& inner);

/// A plate of 12 triangles, 60 x 40 mm, its top in z = 0, and a hollow ball, outer radius 30 mm, whose
/// topmost point is the origin; walls of this thickness.
TriangleSoup plate_mesh(double thickness_m);
TriangleSoup hollow_ball_mesh(double thickness_m);

}  // namespace fingerpad
