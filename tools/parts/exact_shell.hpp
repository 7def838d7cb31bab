#pragma once

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>
#include <string>

namespace fingerpad::parts {

/// The point of a solid's surface nearest to a point.
struct ExactPoint {
  gp_Pnt foot;
  gp_Dir normal;  ///< outward: the surface's; on a sharp edge or vertex the distance's gradient
  double signed_distance_mm = 0;  ///< < 0 inside
  bool on_face = true;            ///< not on a sharp edge or vertex
  double to_sharp_edge_mm = 0;    ///< from the foot
  std::string surface;            ///< the kind of the face under the foot: plane, cylinder, ... ; or edge
};

/// Nearest points on the exact (not tessellated) surface of a solid [mm].
class ExactShell {
 public:
  explicit ExactShell(const TopoDS_Shape& solid);

  /// Found among all faces, edges and vertices (BRepExtrema), then by Newton to rounding. Throws
  /// std::runtime_error where that does not work.
  ExactPoint closest(const gp_Pnt& point) const;

 private:
  TopoDS_Shape solid_, shell_;
  TopTools_IndexedMapOfShape sharp_;  ///< edges, and their vertices
  TopoDS_Compound sharp_edges_;
};

}  // namespace fingerpad::parts
