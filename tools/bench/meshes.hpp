#pragma once

#include "part/part.hpp"

namespace fingerpad::bench {

/// A sphere of 1 m diameter: an icosahedron split `subdivisions` times, 20 * 4^subdivisions triangles (5: 20
/// thousand, 7: 328 thousand, 8: 1.3 million).
TriangleSoup icosphere(int subdivisions);

/// A closed plate of 1 m x 0.625 m x 10 mm with 16 x 10 holes of 80 sides, tessellated as CAD programs do it:
/// thin fans from the corners of a cell to the rim of its hole. 52 thousand triangles, most of them slivers.
TriangleSoup drilled_plate();

}  // namespace fingerpad::bench
