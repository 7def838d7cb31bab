#include "view/part_mesh_vtk.hpp"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include "part/part.hpp"

namespace fingerpad {

vtkSmartPointer<vtkFloatArray> new_normals() {
  auto normals = vtkSmartPointer<vtkFloatArray>::New();
  normals->SetNumberOfComponents(3);
  normals->SetName("Normals");
  return normals;
}

void add_segment(vtkPoints* points, vtkCellArray* lines, const Vec3& a, const Vec3& b) {
  const vtkIdType ids[] = {points->InsertNextPoint(a.data()), points->InsertNextPoint(b.data())};
  lines->InsertNextCell(2, ids);
}

namespace {

/// From a part's own vertices to the draw space.
struct PartPlacement {
  Mat3 turn;
  Vec3 shift_mm;
  PartPlacement(const Surface& surface, const DrawSpace& space)
      : turn(surface.R_WP), shift_mm(space.to_draw(surface.p_WP + surface.R_WP * surface.part->centre_P)) {}
  Vec3 operator()(const Vec3& vertex) const { return turn * vertex * 1e3 + shift_mm; }
};

/// Points that differ by their vertex or its normal, numbered as they come.
class SharedCorners {
 public:
  SharedCorners(Eigen::Index vertices, vtkPoints* points, vtkFloatArray* normals)
      : first_(static_cast<std::size_t>(vertices), -1), points_(points), normals_(normals) {}

  template <typename MakePoint>
  vtkIdType id_of(int vertex, const Eigen::Vector3f& normal, MakePoint make_point) {
    for (vtkIdType id = first_[static_cast<std::size_t>(vertex)]; id >= 0;
         id = next_[static_cast<std::size_t>(id)]) {
      if (known_[static_cast<std::size_t>(id)] == normal) return id;
    }
    const Vec3 at = make_point();
    const vtkIdType id = points_->InsertNextPoint(at.data());
    normals_->InsertNextTypedTuple(normal.data());
    known_.push_back(normal);
    next_.push_back(first_[static_cast<std::size_t>(vertex)]);
    first_[static_cast<std::size_t>(vertex)] = id;
    return id;
  }

 private:
  std::vector<vtkIdType> first_, next_;  // points of one vertex, as a list through next_
  std::vector<Eigen::Vector3f> known_;
  vtkPoints* points_;
  vtkFloatArray* normals_;
};

Eigen::Vector3f corner_normal(const Part& part, const PartPlacement& place, int triangle, int corner) {
  return (place.turn * part.corner_normals.col(3 * triangle + corner)).cast<float>();
}

/// The creases among a triangle's edges, each by the lower of the two triangles that share it.
void add_creases(const Part& part, const PartPlacement& place, int t, vtkPoints* points,
                 vtkCellArray* lines) {
  for (int k = 0; k < 3; ++k) {
    const bool crease = (part.creases[static_cast<std::size_t>(t)] >> k & 1) != 0;
    const int neighbour = part.neighbours(k, t);
    if (!crease || (neighbour >= 0 && neighbour < t)) continue;
    add_segment(points, lines, place(part.vertices.col(part.triangles(k, t))),
                place(part.vertices.col(part.triangles((k + 1) % 3, t))));
  }
}

vtkSmartPointer<vtkPolyData> line_mesh(vtkPoints* points, vtkCellArray* lines) {
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetLines(lines);
  return mesh;
}

vtkSmartPointer<vtkPolyData> shaded_mesh(vtkPoints* points, vtkCellArray* cells, vtkFloatArray* normals) {
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  mesh->GetPointData()->SetNormals(normals);
  return mesh;
}

}  // namespace

vtkSmartPointer<vtkPolyData> part_mesh(const Surface& surface, const DrawSpace& space) {
  const Part& part = *surface.part;
  const PartPlacement place(surface, space);
  auto points = vtkSmartPointer<vtkPoints>::New();
  const auto normals = new_normals();
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->AllocateExact(part.triangle_count(), 3 * static_cast<vtkIdType>(part.triangle_count()));
  SharedCorners corners(part.vertices.cols(), points, normals);
  for (int t = 0; t < part.triangle_count(); ++t) {
    vtkIdType ids[3];
    for (int k = 0; k < 3; ++k) {
      const int vertex = part.triangles(k, t);
      ids[k] = corners.id_of(vertex, corner_normal(part, place, t, k),
                             [&] { return place(part.vertices.col(vertex)); });
    }
    cells->InsertNextCell(3, ids);
  }
  return shaded_mesh(points, cells, normals);
}

vtkSmartPointer<vtkPolyData> part_triangles(const Surface& surface, const DrawSpace& space) {
  const Part& part = *surface.part;
  const PartPlacement place(surface, space);
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetNumberOfPoints(part.vertices.cols());
  for (Eigen::Index v = 0; v < part.vertices.cols(); ++v)
    points->SetPoint(v, place(part.vertices.col(v)).data());
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->AllocateExact(part.triangle_count(), 3 * static_cast<vtkIdType>(part.triangle_count()));
  for (int t = 0; t < part.triangle_count(); ++t) {
    const vtkIdType ids[] = {part.triangles(0, t), part.triangles(1, t), part.triangles(2, t)};
    cells->InsertNextCell(3, ids);
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  return mesh;
}

PartPiece part_piece(const Surface& surface, const DrawSpace& space, std::span<const int> triangles) {
  const Part& part = *surface.part;
  const PartPlacement place(surface, space);
  auto points = vtkSmartPointer<vtkPoints>::New();
  const auto normals = new_normals();
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  auto crease_points = vtkSmartPointer<vtkPoints>::New();
  auto lines = vtkSmartPointer<vtkCellArray>::New();
  for (const int t : triangles) {
    vtkIdType ids[3];
    for (int k = 0; k < 3; ++k) {
      ids[k] = points->InsertNextPoint(place(part.vertices.col(part.triangles(k, t))).data());
      normals->InsertNextTypedTuple(corner_normal(part, place, t, k).data());
    }
    cells->InsertNextCell(3, ids);
    add_creases(part, place, t, crease_points, lines);
  }
  return {shaded_mesh(points, cells, normals), line_mesh(crease_points, lines)};
}

vtkSmartPointer<vtkPolyData> crease_lines(const Surface& surface, const DrawSpace& space) {
  const Part& part = *surface.part;
  const PartPlacement place(surface, space);
  auto points = vtkSmartPointer<vtkPoints>::New();
  auto lines = vtkSmartPointer<vtkCellArray>::New();
  for (int t = 0; t < part.triangle_count(); ++t) add_creases(part, place, t, points, lines);
  return line_mesh(points, lines);
}

}  // namespace fingerpad
