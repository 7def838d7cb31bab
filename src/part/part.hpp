#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/types.hpp"
#include "part/bounds.hpp"

namespace fingerpad {

/// A CAD part as plain arrays, in metres, re-centred so that large file coordinates cost no accuracy.
///
/// Frame P is the file's own frame (times the unit); the arrays hold positions relative to `centre_P`:
/// p_P = centre_P + vertices.col(i). Connectivity (`welded`, `neighbours`) never changes a coordinate.
struct Part {
  Vec3 centre_P = Vec3::Zero();    ///< [m]
  Points vertices;                 ///< 3 x n_v, relative to centre_P [m]; those that triangles use
  IndexTriples triangles;          ///< 3 x n, indices into vertices, the file's winding
                                   ///< (or the repair's: build_part.hpp)
  std::vector<int> file_triangle;  ///< n: number of the triangle in file order from 0 (polygons fanned,
                                   ///< dropped faces keep their number)
  IndexTriples welded;             ///< 3 x n, as triangles, but with equal (or near-equal) vertices merged
  int welded_count = 0;            ///< welded vertices are 0 .. welded_count - 1
  int largest_fan = 0;             ///< triangles at a welded vertex, at the most
  IndexTriples neighbours;         ///< 3 x n: triangle across edge k (corner k to k+1), -1 at a boundary and
                                   ///< where more than two triangles meet
  std::vector<std::uint8_t> creases;  ///< n: bit k set where edge k is sharper than the crease angle or has
                                      ///< no single neighbour

  Points facet_normals;  ///< 3 x n, unit; of a triangle without area: that of the facet it lies on, which is
                         ///< the neighbour across its longest edge (or else its largest neighbour)
  Points edge_pseudonormals;    ///< 3 x 3n: column 3t + k is the sum of the facet normals at edge k, unit
  Points vertex_pseudonormals;  ///< 3 x welded_count: angle-weighted (Baerentzen & Aanaes 2005), unit
  Points corner_normals;  ///< 3 x 3n: column 3t + k, angle-weighted over the smooth fan around the corner

  Vec3 half_extent = Vec3::Zero();  ///< of all used vertices' bounding box, centred on centre_P [m]
  double size_m() const { return 2 * half_extent.norm(); }  ///< the box's diagonal
  int triangle_count() const { return static_cast<int>(triangles.cols()); }
};

/// The bounds of a part in frame P [m].
Bounds bounds_P(const Part& part);

/// A triangle soup as it came from a file or from code, in metres, before connectivity and normals.
struct TriangleSoup {
  Points vertices_P;               ///< 3 x n_v [m]
  IndexTriples triangles;          ///< 3 x n
  std::vector<int> file_triangle;  ///< n, or empty for 0 .. n-1
};

/// Connectivity, creases and normals for a soup: re-centres, welds, finds neighbours, creases and normals.
///
/// Welds exactly; if that leaves boundary edges, tries again at 1e-7 of the diagonal and keeps that where it
/// closes the mesh (`weld_distance_m` then says so, else 0). Left out are triangles with two corners in one
/// place, later repetitions of a triangle (in either winding), and triangles without area that stand alone;
/// if nothing has an area, the part is left without triangles.
/// @param crease_rad  edges whose facet normals turn by more than this split corner normals, >= 0
/// @pre every index is in range and every used coordinate finite; at least one triangle.
Part make_part(const TriangleSoup& soup, double crease_rad, double* weld_distance_m = nullptr);

}  // namespace fingerpad
