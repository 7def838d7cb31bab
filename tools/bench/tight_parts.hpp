#pragma once

#include "part/part.hpp"

namespace fingerpad::bench {

// Parts that a ball fits so well that it touches hundreds or thousands of facets at once. In metres.

/// A round bar along z with a bore all through it. The bore's facets touch the circle of `radius_m` from
/// outside, so that a ball of this radius just passes; `facets` around, two triangles each.
TriangleSoup bore(double radius_m, int facets);

/// A cube with a spherical hollow about the origin, whose facets touch the sphere of `radius_m` from outside.
/// 20 * 4^subdivisions facets.
TriangleSoup socket(double radius_m, int subdivisions);

/// A flat cone, tip up at the origin, of `facets` slivers, and as many below.
TriangleSoup fan(double radius_m, double height_m, int facets);

}  // namespace fingerpad::bench
