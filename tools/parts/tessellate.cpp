#include "tessellate.hpp"

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <cmath>
#include <map>
#include <utility>

namespace fingerpad::parts {
namespace {

constexpr double weld_mm = 1e-4;  // float32 carries 3e-5 mm at 300 mm

/// Finds the vertex within weld_mm of a point, or makes it; the first to come stays.
class Welder {
 public:
  std::uint32_t operator()(const gp_Pnt& point, ClosedMesh& mesh) {
    const Cell cell{cell_of(point.X()), cell_of(point.Y()), cell_of(point.Z())};
    for (long i = -1; i <= 1; ++i) {
      for (long j = -1; j <= 1; ++j) {
        for (long k = -1; k <= 1; ++k) {
          const auto found = vertex_at_.find({cell[0] + i, cell[1] + j, cell[2] + k});
          if (found != vertex_at_.end()) return found->second;
        }
      }
    }
    mesh.vertices.push_back({float(point.X()), float(point.Y()), float(point.Z())});
    return vertex_at_[cell] = std::uint32_t(mesh.vertices.size() - 1);
  }

 private:
  using Cell = std::array<long, 3>;
  static long cell_of(double x_mm) { return std::lround(x_mm / weld_mm); }
  std::map<Cell, std::uint32_t> vertex_at_;
};

void add_face(const TopoDS_Face& face, Welder& weld, ClosedMesh& mesh) {
  TopLoc_Location location;
  const Handle(Poly_Triangulation) triangulation = BRep_Tool::Triangulation(face, location);
  if (triangulation.IsNull()) return;
  for (int i = 1; i <= triangulation->NbTriangles(); ++i) {
    std::array<int, 3> node{};
    triangulation->Triangle(i).Get(node[0], node[1], node[2]);
    if (face.Orientation() == TopAbs_REVERSED) std::swap(node[1], node[2]);
    std::array<std::uint32_t, 3> triangle{};
    for (int k = 0; k < 3; ++k) triangle[k] = weld(triangulation->Node(node[k]).Transformed(location), mesh);
    const bool collapsed =
        triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0];
    if (!collapsed) mesh.triangles.push_back(triangle);
  }
}

}  // namespace

ClosedMesh tessellate(const TopoDS_Shape& solid, const Fineness& fineness) {
  BRepTools::Clean(solid);
  const BRepMesh_IncrementalMesh mesher(solid, fineness.deflection_mm, false, fineness.turn_rad, false);
  ClosedMesh mesh;
  Welder weld;
  for (TopExp_Explorer faces(solid, TopAbs_FACE); faces.More(); faces.Next()) {
    add_face(TopoDS::Face(faces.Current()), weld, mesh);
  }
  return mesh;
}

}  // namespace fingerpad::parts
