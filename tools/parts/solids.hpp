#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <functional>
#include <gp_Ax3.hxx>
#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>
#include <gp_Trsf.hxx>
#include <vector>

/// Small words for building solids out of OpenCASCADE's; all lengths in mm, angles in radians. Each throws
/// std::runtime_error where OpenCASCADE cannot do it.
namespace fingerpad::parts {

/// A corner of a plane outline, rounded by an arc of the given radius (0: sharp).
struct Corner {
  double u_mm = 0, v_mm = 0;
  double radius_mm = 0;
};
using Outline = std::vector<Corner>;

/// A rectangle about the origin with all four corners rounded alike.
Outline rounded_rectangle(double width_mm, double height_mm, double corner_mm);

/// The outline with side i (from corner i to the next) moved to its left by inset_mm[i]; for a
/// counterclockwise outline the left is the inside. Radii follow, so that arcs stay concentric.
Outline inset(const Outline& outline, const std::vector<double>& inset_mm);

/// The face inside a closed outline; u and v run along the frame's x and y.
TopoDS_Face face(const Outline& outline, const gp_Ax3& frame);

/// An outline in the xy plane, drawn up from z0 to z1.
TopoDS_Shape prism(const Outline& outline, double z0_mm, double z1_mm);
/// An outline of (radius, height) turned fully about the z axis.
TopoDS_Shape turned(const Outline& radius_height);
TopoDS_Shape box(double x0, double y0, double z0, double x1, double y1, double z1);
TopoDS_Shape cylinder(double x, double y, double radius_mm, double z0, double z1);

TopoDS_Shape fuse(const TopoDS_Shape& a, const std::vector<TopoDS_Shape>& others);
TopoDS_Shape cut(const TopoDS_Shape& a, const std::vector<TopoDS_Shape>& tools);
TopoDS_Shape common(const TopoDS_Shape& a, const TopoDS_Shape& b);
TopoDS_Shape moved(const TopoDS_Shape& shape, const gp_Trsf& pose);
TopoDS_Shape shifted(const TopoDS_Shape& shape, double x, double y, double z);
gp_Trsf shift(double x, double y, double z);
gp_Trsf turn(const gp_Pnt& point, const gp_Dir& axis, double angle_rad);

/// What an edge is chosen by: the point and the unit tangent at its middle.
using EdgeChoice = std::function<bool(const gp_Pnt& middle, const gp_Dir& tangent)>;
TopoDS_Shape fillet(const TopoDS_Shape& shape, double radius_mm, const EdgeChoice& choice);
TopoDS_Shape chamfer(const TopoDS_Shape& shape, double width_mm, const EdgeChoice& choice);

bool near(double a_mm, double b_mm);                    ///< to 1e-4 mm
bool along(const gp_Dir& tangent, const gp_Dir& axis);  ///< parallel, either way

}  // namespace fingerpad::parts
