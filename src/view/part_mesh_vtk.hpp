#pragma once

#include <vtkSmartPointer.h>

#include <span>

#include "touch/world.hpp"
#include "view/draw_space.hpp"

class vtkCellArray;
class vtkFloatArray;
class vtkPoints;
class vtkPolyData;

namespace fingerpad {

/// A part's triangles in the draw space with the normals of their corners; corners of a vertex that have the
/// same normal share a point. Cell t is triangle t.
vtkSmartPointer<vtkPolyData> part_mesh(const Surface& surface, const DrawSpace& space);

/// A part's triangles in the draw space, without normals: corners share the part's vertices.
vtkSmartPointer<vtkPolyData> part_triangles(const Surface& surface, const DrawSpace& space);

/// Some of a part's triangles as part_mesh has them, and their creases.
struct PartPiece {
  vtkSmartPointer<vtkPolyData> mesh, creases;
};
PartPiece part_piece(const Surface& surface, const DrawSpace& space, std::span<const int> triangles);

/// The edges that a part marks as creases, each once.
vtkSmartPointer<vtkPolyData> crease_lines(const Surface& surface, const DrawSpace& space);

/// An array for the normals of points, and a line between two new points: what meshes are made of.
vtkSmartPointer<vtkFloatArray> new_normals();
void add_segment(vtkPoints* points, vtkCellArray* lines, const Vec3& a, const Vec3& b);

}  // namespace fingerpad
