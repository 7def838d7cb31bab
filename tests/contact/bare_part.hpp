#pragma once

#include "part/part.hpp"

namespace fingerpad::test {

/// A part of corners and triangles alone, without connectivity or normals: enough for distances. Vertices are
/// taken as they are (nothing is welded or moved), so that a test knows every bit.
inline Part bare_part(const Points& vertices, const IndexTriples& triangles) {
  Part part;
  part.vertices = vertices;
  part.triangles = triangles;
  part.welded = triangles;
  part.welded_count = static_cast<int>(vertices.cols());
  part.half_extent = vertices.cwiseAbs().rowwise().maxCoeff();
  return part;
}

}  // namespace fingerpad::test
