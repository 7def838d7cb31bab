#include "grip.hpp"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <cmath>

#include "parts.hpp"

namespace fingerpad::parts {
namespace {

using namespace grip_size;

constexpr double tool_z = 40, boss_chamfer = 0.8;
/// The top is one span over this rectangle about the origin, wider than the grip.
constexpr double half_x = 20, half_y = 15;
/// Coefficients of the top's height: row i is a power of x, column j one of y [mm^(1 - i - j)].
constexpr double height[4][4] = {
    {14, 0.02, -0.02, 0.0002}, {0.03, 0.004, 0, 0}, {-0.018, 0, 3e-5, 0}, {4e-4, 0, 0, 4e-8}};

const gp_Dir z_axis(0, 0, 1);

/// The height's control points: polar form, exact up to rounding.
TopoDS_Shape below_the_top() {
  // The blossom of u^i at Bezier point p of 3 over [-half, half]: the mean, over the ways to choose i of the
  // three arguments (p of them +half, the others -half), of their product.
  const auto blossom = [](int i, int p, double half) {
    const double a[3] = {p > 0 ? half : -half, p > 1 ? half : -half, p > 2 ? half : -half};
    const double powers[4] = {1, (a[0] + a[1] + a[2]) / 3, (a[0] * a[1] + a[1] * a[2] + a[2] * a[0]) / 3,
                              a[0] * a[1] * a[2]};
    return powers[i];
  };
  TColgp_Array2OfPnt poles(1, 4, 1, 4);
  for (int p = 0; p < 4; ++p) {
    for (int q = 0; q < 4; ++q) {
      double z = 0;
      for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) z += height[i][j] * blossom(i, p, half_x) * blossom(j, q, half_y);
      }
      poles.SetValue(p + 1, q + 1, gp_Pnt(blossom(1, p, half_x), blossom(1, q, half_y), z));
    }
  }
  const Handle(Geom_BSplineSurface) top =
      GeomConvert::SurfaceToBSplineSurface(Handle(Geom_Surface)(new Geom_BezierSurface(poles)));
  const TopoDS_Shape face = BRepBuilderAPI_MakeFace(top, 1e-7).Face();
  return BRepPrimAPI_MakePrism(face, gp_Vec(0, 0, -2 * tool_z)).Shape();
}

double from_boss(const gp_Pnt& point) {
  return std::hypot(point.X() - boss_x, point.Y() - boss_y);
}

}  // namespace

double grip_top_mm(double x_mm, double y_mm) {
  double z = 0;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) z += height[i][j] * std::pow(x_mm, i) * std::pow(y_mm, j);
  }
  return z;
}

TopoDS_Shape grip() {
  TopoDS_Shape solid = common(prism(rounded_rectangle(x, y, corner), 0, tool_z), below_the_top());
  solid = fillet(solid, rim, [](const gp_Pnt& middle, const gp_Dir& tangent) {
    return middle.Z() > 1 && !along(tangent, z_axis);
  });
  solid = fuse(solid, {cylinder(boss_x, boss_y, boss_radius, 2, boss_top)});
  solid = fillet(solid, boss_fillet, [](const gp_Pnt& middle, const gp_Dir& tangent) {
    return near(from_boss(middle), boss_radius) && middle.Z() < boss_top - 1 && !along(tangent, z_axis);
  });
  solid = chamfer(solid, boss_chamfer,
                  [](const gp_Pnt& middle, const gp_Dir&) { return near(middle.Z(), boss_top); });
  return cut(solid, {cylinder(bore_x, bore_y, bore_radius, -1, tool_z)});
}

}  // namespace fingerpad::parts
