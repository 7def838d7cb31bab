#include "parts.hpp"
#include "solids.hpp"

namespace fingerpad::parts {
namespace {

constexpr double base_x = 130, base_y = 80, base_z = 12;  // the base lies at x 0.., y 0.., z 0..
constexpr double upright_y0 = 66, upright_z = 82, upright_inset = 15;
constexpr double bend_radius = 6, upright_corner = 18;
constexpr double gusset_y0 = 26, gusset_z1 = 56, gusset_half_thickness = 4;
constexpr double gusset_at[] = {32, base_x - 32};
constexpr double bore_z = 56, bore_radius = 14, ring_radius = 22, ring_height = 4, ring_fillet = 2;
constexpr double pocket_x = 44, pocket_y = 34, pocket_depth = 6, pocket_corner = 7, pocket_floor_fillet = 2;
constexpr double pocket_centre_x = base_x / 2, pocket_centre_y = 29;
constexpr double bolt_radius = 4.5, counterbore_radius = 7.5, counterbore_depth = 5;
constexpr double bolt_at[][2] = {{14, 14}, {base_x - 14, 14}, {14, 48}, {base_x - 14, 48}};
constexpr double small_bolt_radius = 2.75, small_bolt_offset = 18;
constexpr double edge_chamfer = 1.5, base_corner = 8;

const gp_Dir x_axis(1, 0, 0), y_axis(0, 1, 0), z_axis(0, 0, 1);

/// Stands a solid drawn along z up so that its z points to -y and its y to z, at y = from_y.
TopoDS_Shape facing_front(const TopoDS_Shape& solid, double from_y) {
  return moved(solid, shift(0, from_y, 0) * turn(gp_Pnt(0, 0, 0), x_axis, M_PI / 2));
}

TopoDS_Shape base_with_upright() {
  const Outline base = {{0, 0, base_corner}, {base_x, 0, base_corner}, {base_x, base_y, 0}, {0, base_y, 0}};
  const Outline upright = {{upright_inset, 1, 0},
                           {base_x - upright_inset, 1, 0},
                           {base_x - upright_inset, upright_z, upright_corner},
                           {upright_inset, upright_z, upright_corner}};
  TopoDS_Shape solid =
      fuse(prism(base, 0, base_z), {facing_front(prism(upright, 0, base_y - upright_y0), base_y)});
  solid = fillet(solid, bend_radius, [](const gp_Pnt& middle, const gp_Dir& tangent) {
    return along(tangent, x_axis) && near(middle.Y(), upright_y0) && near(middle.Z(), base_z);
  });
  return chamfer(solid, edge_chamfer, [](const gp_Pnt& middle, const gp_Dir&) {
    const bool rim = near(middle.Z(), base_z) && middle.Y() < upright_y0 - bend_radius - 1;
    return rim && (middle.Y() < 4 || middle.X() < 4 || middle.X() > base_x - 4);
  });
}

TopoDS_Shape gussets(const TopoDS_Shape& solid) {
  const Outline side = {{gusset_y0, base_z - 1, 0},
                        {upright_y0 + 1, base_z - 1, 0},
                        {upright_y0 + 1, gusset_z1, 0},
                        {upright_y0 - 8, gusset_z1, 3},
                        {gusset_y0, base_z + 3, 3}};
  std::vector<TopoDS_Shape> both;
  for (const double x : gusset_at) {
    // Drawn over (y, z), so stand it up: x of the drawing to y, y to z, and its z to x.
    gp_Trsf pose;
    pose.SetDisplacement(gp_Ax3(gp_Pnt(0, 0, 0), z_axis, x_axis), gp_Ax3(gp_Pnt(x, 0, 0), x_axis, y_axis));
    both.push_back(moved(prism(side, -gusset_half_thickness, gusset_half_thickness), pose));
  }
  return fuse(solid, both);
}

TopoDS_Shape bore(const TopoDS_Shape& solid) {
  const double wall = base_y - upright_y0;
  const double top = wall + ring_height;
  const Outline ring = {
      {0, wall - 2, 0}, {ring_radius, wall - 2, 0}, {ring_radius, top, ring_fillet}, {0, top, 0}};
  const gp_Trsf place = shift(base_x / 2, 0, bore_z);
  std::vector<TopoDS_Shape> holes = {
      moved(facing_front(cylinder(0, 0, bore_radius, -1, top + 1), base_y), place)};
  for (const double side : {-1.0, 1.0}) {
    holes.push_back(moved(facing_front(cylinder(side * (ring_radius + 6), small_bolt_offset - 4,
                                                small_bolt_radius, -1, wall + 1),
                                       base_y),
                          place));
  }
  return cut(fuse(solid, {moved(facing_front(turned(ring), base_y), place)}), holes);
}

TopoDS_Shape pocket_and_bolts(const TopoDS_Shape& solid) {
  TopoDS_Shape pocket =
      prism(rounded_rectangle(pocket_x, pocket_y, pocket_corner), base_z - pocket_depth, base_z + 5);
  pocket = fillet(pocket, pocket_floor_fillet, [](const gp_Pnt& middle, const gp_Dir&) {
    return near(middle.Z(), base_z - pocket_depth);
  });
  std::vector<TopoDS_Shape> tools = {shifted(pocket, pocket_centre_x, pocket_centre_y, 0)};
  for (const auto& at : bolt_at) {
    const Outline stepped = {{0, -1, 0},
                             {bolt_radius, -1, 0},
                             {bolt_radius, base_z - counterbore_depth, 0},
                             {counterbore_radius, base_z - counterbore_depth, 0},
                             {counterbore_radius, base_z + 5, 0},
                             {0, base_z + 5, 0}};
    tools.push_back(shifted(turned(stepped), at[0], at[1], 0));
  }
  return cut(solid, tools);
}

}  // namespace

TopoDS_Shape bracket() {
  return pocket_and_bolts(bore(gussets(base_with_upright())));
}

}  // namespace fingerpad::parts
