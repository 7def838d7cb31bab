#include <BRepPrimAPI_MakeRevol.hxx>
#include <cmath>
#include <gp_Ax1.hxx>

#include "dashboard_features.hpp"
#include "parts.hpp"
#include "solids.hpp"

namespace fingerpad::parts {
namespace {

constexpr double length_mm = 600, bow_radius = 2400;  // along x the panel bows about an axis far below
constexpr double thickness = 3;
constexpr double end_fillet = 5;

// The section (y, z): skirt, lip, fascia, brow, pad, back.
constexpr double skirt_z = -22, lip_radius = 9, fascia_y1 = 150, fascia_z1 = 16;
constexpr double brow_y = 160, brow_z = 36, brow_foot_radius = 8, brow_radius = 12;
constexpr double back_y = 220, back_z = 44, back_radius = 10;
constexpr double groove_y = 190, groove_radius = 1.5;  // the pad's seam

struct Placed {
  Feature feature;
  double x_mm, y_mm;
};

Outline section() {
  return {{0, skirt_z, 0},
          {back_y, skirt_z, 0},
          {back_y, back_z, back_radius},
          {brow_y, brow_z, brow_radius},
          {fascia_y1, fascia_z1, brow_foot_radius},
          {0, 0, lip_radius}};
}

/// A section swept along the bow, both ways from the middle.
TopoDS_Shape swept(const TopoDS_Face& section_face, double half_angle_rad) {
  const gp_Pnt below(0, 0, -bow_radius);
  const TopoDS_Shape start = moved(section_face, turn(below, gp_Dir(0, 1, 0), -half_angle_rad));
  return BRepPrimAPI_MakeRevol(start, gp_Ax1(below, gp_Dir(0, 1, 0)), 2 * half_angle_rad).Shape();
}

TopoDS_Shape panel() {
  const gp_Ax3 section_frame(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0), gp_Dir(0, 1, 0));
  const double half_angle = length_mm / 2 / bow_radius;
  TopoDS_Shape solid = swept(face(section(), section_frame), half_angle);
  solid = fillet(solid, end_fillet, [&](const gp_Pnt& middle, const gp_Dir&) {
    const double angle = std::atan2(middle.X(), middle.Z() + bow_radius);
    return std::abs(std::abs(angle) - half_angle) < 1e-9 &&
           !near(std::hypot(middle.X(), middle.Z() + bow_radius), bow_radius + skirt_z);
  });
  Outline inner = inset(section(), {-10, thickness, thickness, thickness, thickness, thickness});
  const TopoDS_Shape hollow = swept(face(inner, section_frame), half_angle - thickness / bow_radius);
  const double pad_z = brow_z + (back_z - brow_z) * (groove_y - brow_y) / (back_y - brow_y);
  const gp_Ax3 groove_frame(gp_Pnt(0, groove_y, pad_z), gp_Dir(1, 0, 0), gp_Dir(0, 1, 0));
  const Outline groove = {{-groove_radius, 0, 0},
                          {0, -groove_radius, 0.4},
                          {groove_radius, 0, 0},
                          {groove_radius, 3, 0},
                          {-groove_radius, 3, 0}};
  return cut(solid, {hollow, swept(face(groove, groove_frame), half_angle + 0.01)});
}

/// Where a feature drawn about the origin goes: x along the bow, y as in the section, z out of the fascia.
gp_Trsf on_fascia(double x_mm, double y_mm) {
  const double slope = std::atan2(fascia_z1, fascia_y1);
  return turn(gp_Pnt(0, 0, -bow_radius), gp_Dir(0, 1, 0), x_mm / bow_radius) *
         shift(0, y_mm, y_mm * fascia_z1 / fascia_y1) * turn(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0), slope);
}

}  // namespace

TopoDS_Shape dashboard() {
  const std::vector<Placed> layout = {
      {instrument(58, 31), -212, 76},
      {instrument(44, 26), -98, 68},
      {vent(), 10, 112},
      {vent(), 118, 112},
      {vent(), 226, 112},
      {knob(), -6, 46},
      {buttons(), 96, 48},
      {tray(), 218, 48},
  };
  std::vector<TopoDS_Shape> holes, inserts;
  for (const Placed& placed : layout) {
    const gp_Trsf pose = on_fascia(placed.x_mm, placed.y_mm);
    holes.push_back(moved(placed.feature.hole, pose));
    inserts.push_back(moved(placed.feature.insert, pose));
  }
  return fuse(cut(panel(), holes), inserts);
}

}  // namespace fingerpad::parts
