#include "exact_shell.hpp"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <cmath>
#include <stdexcept>

namespace fingerpad::parts {
namespace {

constexpr double sharp_rad = 0.02;  // a rolling ball's B-spline meets its faces to 1e-3
constexpr double exact_mm = 1e-10;  // of the last Newton step

gp_Vec outward(const TopoDS_Face& face, const gp_Vec& du, const gp_Vec& dv) {
  const gp_Vec normal = du.Crossed(dv);
  return face.Orientation() == TopAbs_REVERSED ? normal.Reversed() : normal;
}

/// The largest angle between two faces' normals along their common edge, at a few of its points.
double turn_over(const TopoDS_Edge& edge, const TopoDS_Face& a, const TopoDS_Face& b) {
  constexpr int places = 9;
  double first = 0, last = 0, worst = 0;
  const auto normal_at = [&](const TopoDS_Face& face, double share) {
    const Handle(Geom2d_Curve) on_face = BRep_Tool::CurveOnSurface(edge, face, first, last);
    const gp_Pnt2d uv = on_face->Value(first + share * (last - first));
    gp_Pnt point;
    gp_Vec du, dv;
    BRepAdaptor_Surface(face).D1(uv.X(), uv.Y(), point, du, dv);
    return outward(face, du, dv);
  };
  for (int i = 0; i < places; ++i) {
    const double share = (i + 0.5) / places;
    worst = std::max(worst, normal_at(a, share).Angle(normal_at(b, share)));
  }
  return worst;
}

/// Newton for the foot on a face from (u, v): the gradient of half the squared distance is zero.
void polish(const TopoDS_Face& face, const gp_Pnt& point, double u, double v, ExactPoint& exact) {
  const BRepAdaptor_Surface surface(face, false);
  gp_Vec du, dv, duu, dvv, duv;
  double step_mm = 0;
  for (int i = 0; i < 20; ++i) {
    surface.D2(u, v, exact.foot, du, dv, duu, dvv, duv);
    const gp_Vec off(point, exact.foot);
    const double gu = off * du, gv = off * dv;
    const double a = du * du + off * duu, b = du * dv + off * duv, c = dv * dv + off * dvv;
    const double det = a * c - b * b;
    if (!(det > 0)) throw std::runtime_error("a foot is no minimum");
    const double su = (-c * gu + b * gv) / det, sv = (b * gu - a * gv) / det;
    u += su;
    v += sv;
    step_mm = (du * su + dv * sv).Magnitude();
    if (step_mm < 1e-13) break;
  }
  if (!(step_mm < exact_mm)) throw std::runtime_error("a foot does not converge");
  surface.D1(u, v, exact.foot, du, dv);
  exact.normal = gp_Dir(outward(face, du, dv));
  constexpr const char* names[] = {"plane", "cylinder", "cone", "sphere", "torus", "bezier", "bspline"};
  exact.surface = surface.GetType() <= GeomAbs_BSplineSurface ? names[surface.GetType()] : "other";
}

void polish(const TopoDS_Edge& edge, const gp_Pnt& point, double t, ExactPoint& exact) {
  const BRepAdaptor_Curve curve(edge);
  gp_Vec d1, d2;
  double step_mm = 0;
  for (int i = 0; i < 20; ++i) {
    curve.D2(t, exact.foot, d1, d2);
    const gp_Vec off(point, exact.foot);
    const double step = -(off * d1) / (d1 * d1 + off * d2);
    t += step;
    step_mm = std::abs(step) * d1.Magnitude();
    if (step_mm < 1e-13) break;
  }
  if (!(step_mm < exact_mm)) throw std::runtime_error("a foot on an edge does not converge");
  exact.foot = curve.Value(t);
}

/// The first of the nearest points that lies on a face, or else the first.
int best_solution(const BRepExtrema_DistShapeShape& search) {
  for (int i = 1; i <= search.NbSolution(); ++i) {
    if (search.SupportTypeShape2(i) == BRepExtrema_IsInFace) return i;
  }
  return 1;
}

}  // namespace

ExactShell::ExactShell(const TopoDS_Shape& solid) : solid_(solid) {
  TopExp_Explorer shells(solid, TopAbs_SHELL);
  shell_ = shells.Current();
  TopTools_IndexedDataMapOfShapeListOfShape faces_of;
  TopExp::MapShapesAndAncestors(solid, TopAbs_EDGE, TopAbs_FACE, faces_of);
  const BRep_Builder builder;
  builder.MakeCompound(sharp_edges_);
  for (int i = 1; i <= faces_of.Extent(); ++i) {
    const TopoDS_Edge& edge = TopoDS::Edge(faces_of.FindKey(i));
    if (BRep_Tool::Degenerated(edge) || faces_of(i).Extent() != 2) continue;
    const TopoDS_Face a = TopoDS::Face(faces_of(i).First()), b = TopoDS::Face(faces_of(i).Last());
    if (a.IsSame(b) || turn_over(edge, a, b) < sharp_rad) continue;
    builder.Add(sharp_edges_, edge);
    sharp_.Add(edge);
    for (TopExp_Explorer ends(edge, TopAbs_VERTEX); ends.More(); ends.Next()) sharp_.Add(ends.Current());
  }
}

ExactPoint ExactShell::closest(const gp_Pnt& point) const {
  const BRepExtrema_DistShapeShape search(BRepBuilderAPI_MakeVertex(point).Vertex(), shell_);
  if (!search.IsDone() || search.NbSolution() < 1) throw std::runtime_error("no nearest point was found");
  const int best = best_solution(search);
  const TopoDS_Shape support = search.SupportOnShape2(best);
  ExactPoint exact;
  exact.foot = search.PointOnShape2(best);
  const bool in_face = search.SupportTypeShape2(best) == BRepExtrema_IsInFace;
  if (in_face) {
    double u = 0, v = 0;
    search.ParOnFaceS2(best, u, v);
    polish(TopoDS::Face(support), point, u, v, exact);
  } else if (search.SupportTypeShape2(best) == BRepExtrema_IsOnEdge) {
    double t = 0;
    search.ParOnEdgeS2(best, t);
    polish(TopoDS::Edge(support), point, t, exact);
  }
  const double distance_mm = point.Distance(exact.foot);
  if (std::abs(distance_mm - search.Value()) > 1e-6) throw std::runtime_error("Newton left the nearest foot");
  BRepClass3d_SolidClassifier side(solid_, point, 1e-9);
  exact.signed_distance_mm = side.State() == TopAbs_IN ? -distance_mm : distance_mm;
  exact.on_face = in_face || !sharp_.Contains(support);
  if (!in_face) {
    exact.surface = exact.on_face ? "smooth-edge" : "edge";
    exact.normal = gp_Dir(gp_Vec(exact.foot, point) / exact.signed_distance_mm);
  }
  const BRepExtrema_DistShapeShape to_sharp(BRepBuilderAPI_MakeVertex(exact.foot).Vertex(), sharp_edges_);
  exact.to_sharp_edge_mm = to_sharp.Value();
  return exact;
}

}  // namespace fingerpad::parts
