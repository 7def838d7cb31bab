#pragma once

#include <TopoDS_Shape.hxx>

#include "closed_mesh.hpp"

namespace fingerpad::parts {

/// How far a triangle may lie from the exact surface, and how far neighbouring normals may turn along an
/// edge.
struct Fineness {
  double deflection_mm;
  double turn_rad;
};

/// Triangles of a solid, outward, welded. Neighbouring faces share the points of their common edge; where the
/// two faces round such a point differently they are joined (within 1e-4 mm). Same solid, same triangles.
ClosedMesh tessellate(const TopoDS_Shape& solid, const Fineness& fineness);

}  // namespace fingerpad::parts
