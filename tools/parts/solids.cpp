#include "solids.hpp"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeChamfer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRep_Tool.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Ax1.hxx>
#include <gp_Vec2d.hxx>
#include <stdexcept>
#include <string>

namespace fingerpad::parts {
namespace {

/// A corner as the outline passes it: in at `enter`, out at `leave`, the arc's middle between.
struct Rounding {
  gp_XY enter, middle, leave;
};

Rounding round_corner(const gp_XY& before, const Corner& corner, const gp_XY& after) {
  const gp_XY at(corner.u_mm, corner.v_mm);
  if (corner.radius_mm <= 0) return {at, at, at};
  const gp_XY to_before = (before - at).Normalized();
  const gp_XY to_after = (after - at).Normalized();
  const double half = 0.5 * std::acos(to_before * to_after);
  const double cut_back = corner.radius_mm / std::tan(half);
  const gp_XY bisector = (to_before + to_after).Normalized();
  const double to_arc = corner.radius_mm / std::sin(half) - corner.radius_mm;
  return {at + to_before * cut_back, at + bisector * to_arc, at + to_after * cut_back};
}

gp_Pnt in_space(const gp_XY& point, const gp_Ax3& frame) {
  return frame.Location().Translated(gp_Vec(frame.XDirection()) * point.X() +
                                     gp_Vec(frame.YDirection()) * point.Y());
}

TopoDS_Shape checked(BRepBuilderAPI_MakeShape& maker, const char* what) {
  if (!maker.IsDone()) throw std::runtime_error(std::string(what) + " failed");
  return maker.Shape();
}

template <class Boolean>
TopoDS_Shape boolean(const TopoDS_Shape& a, const std::vector<TopoDS_Shape>& others, const char* what) {
  TopTools_ListOfShape arguments, tools;
  arguments.Append(a);
  for (const TopoDS_Shape& other : others) tools.Append(other);
  Boolean maker;
  maker.SetArguments(arguments);
  maker.SetTools(tools);
  maker.Build();
  return checked(maker, what);
}

/// Hands each chosen edge to `add`; choosing none is a mistake in the part and told.
template <class Add>
void for_chosen_edges(const TopoDS_Shape& shape, const EdgeChoice& choice, const Add& add) {
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  int chosen = 0;
  for (int i = 1; i <= edges.Extent(); ++i) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges(i));
    if (BRep_Tool::Degenerated(edge)) continue;
    const BRepAdaptor_Curve curve(edge);
    gp_Pnt middle;
    gp_Vec tangent;
    curve.D1(0.5 * (curve.FirstParameter() + curve.LastParameter()), middle, tangent);
    if (!choice(middle, gp_Dir(tangent))) continue;
    add(edge);
    ++chosen;
  }
  if (chosen == 0) throw std::runtime_error("no edge is where a fillet or chamfer was asked for");
}

}  // namespace

Outline rounded_rectangle(double width_mm, double height_mm, double corner_mm) {
  const double u = width_mm / 2;
  const double v = height_mm / 2;
  return {{-u, -v, corner_mm}, {u, -v, corner_mm}, {u, v, corner_mm}, {-u, v, corner_mm}};
}

Outline inset(const Outline& outline, const std::vector<double>& inset_mm) {
  const size_t n = outline.size();
  const auto at = [&](size_t i) { return gp_XY(outline[i % n].u_mm, outline[i % n].v_mm); };
  Outline moved_outline(n);
  for (size_t i = 0; i < n; ++i) {
    const size_t before = (i + n - 1) % n;
    const gp_XY in = (at(i) - at(before)).Normalized();
    const gp_XY out = (at(i + 1) - at(i)).Normalized();
    const double turn_sine = in ^ out;  // > 0: the outline turns left here
    // The point at inset d_before left of the side that comes in and d_i left of the one that goes out.
    const gp_XY point = at(i) + out * (inset_mm[before] / turn_sine) - in * (inset_mm[i] / turn_sine);
    const double radius = outline[i].radius_mm - (turn_sine > 0 ? 1 : -1) * inset_mm[i];
    moved_outline[i] = {point.X(), point.Y(), outline[i].radius_mm > 0 ? std::max(radius, 0.5) : 0};
  }
  return moved_outline;
}

TopoDS_Face face(const Outline& outline, const gp_Ax3& frame) {
  const size_t n = outline.size();
  const auto at = [&](size_t i) { return gp_XY(outline[i % n].u_mm, outline[i % n].v_mm); };
  std::vector<Rounding> roundings;
  for (size_t i = 0; i < n; ++i) roundings.push_back(round_corner(at(i + n - 1), outline[i], at(i + 1)));
  BRepBuilderAPI_MakeWire wire;
  for (size_t i = 0; i < n; ++i) {
    const Rounding& here = roundings[i];
    const Rounding& next = roundings[(i + 1) % n];
    if (outline[i].radius_mm > 0) {
      const GC_MakeArcOfCircle arc(in_space(here.enter, frame), in_space(here.middle, frame),
                                   in_space(here.leave, frame));
      wire.Add(BRepBuilderAPI_MakeEdge(arc.Value()).Edge());
    }
    if ((next.enter - here.leave).Modulus() > 1e-6) {
      wire.Add(BRepBuilderAPI_MakeEdge(in_space(here.leave, frame), in_space(next.enter, frame)).Edge());
    }
  }
  if (!wire.IsDone()) throw std::runtime_error("an outline does not close");
  return BRepBuilderAPI_MakeFace(wire.Wire(), true).Face();
}

TopoDS_Shape prism(const Outline& outline, double z0_mm, double z1_mm) {
  const gp_Ax3 frame(gp_Pnt(0, 0, z0_mm), gp_Dir(0, 0, 1), gp_Dir(1, 0, 0));
  BRepPrimAPI_MakePrism maker(face(outline, frame), gp_Vec(0, 0, z1_mm - z0_mm));
  return checked(maker, "prism");
}

TopoDS_Shape turned(const Outline& radius_height) {
  const gp_Ax3 frame(gp_Pnt(0, 0, 0), gp_Dir(0, -1, 0), gp_Dir(1, 0, 0));
  BRepPrimAPI_MakeRevol maker(face(radius_height, frame), gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)));
  return checked(maker, "revolution");
}

TopoDS_Shape box(double x0, double y0, double z0, double x1, double y1, double z1) {
  return BRepPrimAPI_MakeBox(gp_Pnt(x0, y0, z0), gp_Pnt(x1, y1, z1)).Shape();
}

TopoDS_Shape cylinder(double x, double y, double radius_mm, double z0, double z1) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, y, z0), gp_Dir(0, 0, 1)), radius_mm, z1 - z0).Shape();
}

TopoDS_Shape fuse(const TopoDS_Shape& a, const std::vector<TopoDS_Shape>& others) {
  return boolean<BRepAlgoAPI_Fuse>(a, others, "fuse");
}

TopoDS_Shape cut(const TopoDS_Shape& a, const std::vector<TopoDS_Shape>& tools) {
  return boolean<BRepAlgoAPI_Cut>(a, tools, "cut");
}

TopoDS_Shape common(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  return boolean<BRepAlgoAPI_Common>(a, {b}, "common");
}

TopoDS_Shape moved(const TopoDS_Shape& shape, const gp_Trsf& pose) {
  return BRepBuilderAPI_Transform(shape, pose, true).Shape();
}

TopoDS_Shape shifted(const TopoDS_Shape& shape, double x, double y, double z) {
  return moved(shape, shift(x, y, z));
}

gp_Trsf shift(double x, double y, double z) {
  gp_Trsf pose;
  pose.SetTranslation(gp_Vec(x, y, z));
  return pose;
}

gp_Trsf turn(const gp_Pnt& point, const gp_Dir& axis, double angle_rad) {
  gp_Trsf pose;
  pose.SetRotation(gp_Ax1(point, axis), angle_rad);
  return pose;
}

TopoDS_Shape fillet(const TopoDS_Shape& shape, double radius_mm, const EdgeChoice& choice) {
  BRepFilletAPI_MakeFillet maker(shape);
  for_chosen_edges(shape, choice, [&](const TopoDS_Edge& edge) { maker.Add(radius_mm, edge); });
  maker.Build();
  return checked(maker, "fillet");
}

TopoDS_Shape chamfer(const TopoDS_Shape& shape, double width_mm, const EdgeChoice& choice) {
  BRepFilletAPI_MakeChamfer maker(shape);
  for_chosen_edges(shape, choice, [&](const TopoDS_Edge& edge) { maker.Add(width_mm, edge); });
  maker.Build();
  return checked(maker, "chamfer");
}

bool near(double a_mm, double b_mm) {
  return std::abs(a_mm - b_mm) < 1e-4;
}

bool along(const gp_Dir& tangent, const gp_Dir& axis) {
  return std::abs(tangent * axis) > 1 - 1e-9;
}

}  // namespace fingerpad::parts
