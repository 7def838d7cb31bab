#pragma once

#include "part/part.hpp"
#include "part/raw_mesh.hpp"

namespace fingerpad {

/// The polygons of a file as triangles: each is fanned from its first corner, in the file's order.
struct Fan {
  TriangleSoup
      soup;  ///< without the triangles of polygons that name missing vertices; file_triangle is filled
  long triangles = 0;           ///< of all polygons
  long out_of_range = 0;        ///< left out
  int first_out_of_range = -1;  ///< the polygon
  long concave = 0;             ///< polygons whose fan folds over itself
};

/// @param metres_per_unit  multiplies the file's numbers, in double
Fan fan_polygons(const RawMesh& mesh, double metres_per_unit);

}  // namespace fingerpad
