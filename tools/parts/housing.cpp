#include "parts.hpp"
#include "solids.hpp"

namespace fingerpad::parts {
namespace {

constexpr double size_x = 150, size_y = 95, size_z = 40, wall = 1.2;
constexpr double corner = 12, floor_fillet = 5;
constexpr double boss_radius = 4, boss_hole_radius = 1.6, boss_height = 26, boss_inset = 13, boss_foot = 1.5;
constexpr double fin_length = 9, fin_height = 18;
constexpr double rib_height = 10, rib_lengthwise_y[] = {-16, 16}, rib_crosswise_x[] = {-22, 30};
constexpr double slot_width = 3, slot_length = 26, slot_pitch = 7;
constexpr int floor_slots = 6, side_slots = 7;
constexpr double plug_width = 24, plug_height = 11, plug_z = 22;

const gp_Dir x_axis(1, 0, 0), y_axis(0, 1, 0), z_axis(0, 0, 1);

/// The outside moved inwards, up to some height.
TopoDS_Shape body(double inset_mm, double top_z) {
  const Outline outline = rounded_rectangle(size_x - 2 * inset_mm, size_y - 2 * inset_mm, corner - inset_mm);
  return fillet(prism(outline, inset_mm, top_z), floor_fillet - inset_mm,
                [&](const gp_Pnt& middle, const gp_Dir&) { return near(middle.Z(), inset_mm); });
}

TopoDS_Shape shell() {
  return cut(body(0, size_z), {body(wall, size_z + 10)});
}

/// Four posts for screws, each with a rounded foot and two fins.
std::vector<TopoDS_Shape> bosses() {
  std::vector<TopoDS_Shape> all;
  const double foot = boss_radius + boss_foot;
  const double under = wall / 2;
  const Outline post = {{0, under, 0},
                        {foot, under, 0},
                        {foot, wall - 0.1, 0},
                        {boss_radius, wall - 0.1, boss_foot},
                        {boss_radius, boss_height, 0.5},
                        {0, boss_height, 0}};
  for (const double sx : {-1.0, 1.0}) {
    for (const double sy : {-1.0, 1.0}) {
      const double x = sx * (size_x / 2 - boss_inset);
      const double y = sy * (size_y / 2 - boss_inset);
      const TopoDS_Shape fin_x = box(-fin_length, -wall / 2, under, 0, wall / 2, fin_height);
      const TopoDS_Shape fin_y = box(-wall / 2, -fin_length, under, wall / 2, 0, fin_height);
      const TopoDS_Shape to_middle_x = sx > 0 ? fin_x : shifted(fin_x, fin_length, 0, 0);
      const TopoDS_Shape to_middle_y = sy > 0 ? fin_y : shifted(fin_y, 0, fin_length, 0);
      all.push_back(shifted(fuse(turned(post), {to_middle_x, to_middle_y}), x, y, 0));
    }
  }
  return all;
}

std::vector<TopoDS_Shape> boss_holes() {
  std::vector<TopoDS_Shape> all;
  for (const double sx : {-1.0, 1.0}) {
    for (const double sy : {-1.0, 1.0}) {
      all.push_back(cylinder(sx * (size_x / 2 - boss_inset), sy * (size_y / 2 - boss_inset), boss_hole_radius,
                             6, boss_height + 1));
    }
  }
  return all;
}

/// Ribs over the floor from wall to wall, ending half way into the walls.
std::vector<TopoDS_Shape> ribs() {
  const TopoDS_Shape limit = body(wall / 2, size_z);
  std::vector<TopoDS_Shape> all;
  for (const double y : rib_lengthwise_y) {
    all.push_back(common(box(-size_x, y - wall / 2, 0, size_x, y + wall / 2, rib_height), limit));
  }
  for (const double x : rib_crosswise_x) {
    all.push_back(common(box(x - wall / 2, -size_y, 0, x + wall / 2, size_y, rib_height - 2), limit));
  }
  return all;
}

std::vector<TopoDS_Shape> openings() {
  std::vector<TopoDS_Shape> all;
  for (int i = 0; i < floor_slots; ++i) {  // in the floor, between the ribs
    const TopoDS_Shape slot = prism(rounded_rectangle(slot_width, slot_length, slot_width / 2 - 0.01), -5, 5);
    all.push_back(shifted(slot, 4 + (i - (floor_slots - 1) / 2.0) * slot_pitch, 0, 0));
  }
  for (int i = 0; i < side_slots; ++i) {  // in the front wall
    const TopoDS_Shape slot = prism(rounded_rectangle(slot_width, 16, slot_width / 2 - 0.01), -5, 5);
    const gp_Trsf upright = shift((i - (side_slots - 1) / 2.0) * slot_pitch, -size_y / 2, 24) *
                            turn(gp_Pnt(0, 0, 0), x_axis, M_PI / 2);
    all.push_back(moved(slot, upright));
  }
  // The connector's opening in the right wall: a D with sharp corners.
  const Outline plug = {{-plug_width / 2 + 2.5, -plug_height / 2, 0},
                        {plug_width / 2 - 2.5, -plug_height / 2, 0},
                        {plug_width / 2, plug_height / 2, 0},
                        {-plug_width / 2, plug_height / 2, 0}};
  gp_Trsf pose;
  pose.SetDisplacement(gp_Ax3(gp_Pnt(0, 0, 0), z_axis, x_axis),
                       gp_Ax3(gp_Pnt(size_x / 2, 0, plug_z), x_axis, y_axis));
  all.push_back(moved(prism(plug, -5, 5), pose));
  return all;
}

}  // namespace

TopoDS_Shape housing() {
  std::vector<TopoDS_Shape> inside = bosses();
  for (const TopoDS_Shape& rib : ribs()) inside.push_back(rib);
  std::vector<TopoDS_Shape> tools = openings();
  for (const TopoDS_Shape& hole : boss_holes()) tools.push_back(hole);
  return cut(fuse(shell(), inside), tools);
}

}  // namespace fingerpad::parts
