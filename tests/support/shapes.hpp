#pragma once

#include "part/part.hpp"

namespace fingerpad::test {

/// A box centred on the origin: 12 triangles, two a side, wound outwards.
/// @param size_m  full lengths along x, y, z
TriangleSoup box_soup(const Vec3& size_m);

/// A sphere about the origin: an octahedron whose facets were split in four `subdivisions` times, every
/// vertex on the sphere. 8 * 4^subdivisions triangles, vertices shared, wound outwards.
TriangleSoup sphere_soup(double radius_m, int subdivisions);

/// A torus about the z axis: `around` x `across` quads, each split in two; vertices shared, wound outwards.
/// @param ring_radius_m  from the axis to the tube's centre
/// @param tube_radius_m  of the tube, < ring_radius_m
TriangleSoup torus_soup(double ring_radius_m, double tube_radius_m, int around, int across);

/// An open square in the plane z = 0, normal +z, of `cells` x `cells` quads split in two, centred on the
/// origin.
TriangleSoup square_soup(double side_m, int cells);

/// Two open half planes that meet along the y axis, each `side_m` square, normals up (+z side); `turn_rad` is
/// the angle by which the normal turns over the edge: > 0 a ridge (convex), < 0 a valley, 0 flat.
TriangleSoup roof_soup(double side_m, double turn_rad);

/// Both soups in one, the second behind the first.
TriangleSoup joined(const TriangleSoup& first, const TriangleSoup& second);

/// The soup moved by `offset_m`.
TriangleSoup moved(TriangleSoup soup, const Vec3& offset_m);

/// The soup with every triangle's winding turned round.
TriangleSoup reversed(TriangleSoup soup);

/// The soup as an STL holds it: three vertices of its own for each triangle, none shared.
TriangleSoup unshared(const TriangleSoup& soup);

/// A sheet of nu x nv quads, each cut in two.
template <class Point>
TriangleSoup sheet_soup(int nu, int nv, Point point) {
  TriangleSoup soup;
  soup.vertices_P.resize(3, (nu + 1) * (nv + 1));
  soup.triangles.resize(3, 2 * nu * nv);
  for (int j = 0; j <= nv; ++j) {
    for (int i = 0; i <= nu; ++i)
      soup.vertices_P.col(j * (nu + 1) + i) = point(static_cast<double>(i) / nu, static_cast<double>(j) / nv);
  }
  for (int j = 0; j < nv; ++j) {
    for (int i = 0; i < nu; ++i) {
      const int a = j * (nu + 1) + i, t = 2 * (j * nu + i);
      soup.triangles.col(t) << a, a + 1, a + nu + 2;
      soup.triangles.col(t + 1) << a, a + nu + 2, a + nu + 1;
    }
  }
  return soup;
}

}  // namespace fingerpad::test
