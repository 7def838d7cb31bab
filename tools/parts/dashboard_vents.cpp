#include <cmath>
#include <iterator>

#include "dashboard_features.hpp"
#include "solids.hpp"

namespace fingerpad::parts {
namespace {

constexpr double frame_x = 98, frame_y = 44, frame_corner = 9, frame_border = 4, frame_top = 3,
                 frame_fillet = 1.6;
constexpr double duct_depth = 24;
constexpr double slat_thickness = 1.6, slat_chord = 8, slat_pitch = 6.6, slat_centre_z = -4.2,
                 slat_tilt_rad = -0.2;
constexpr int slats = 5;
constexpr double vane_thickness = 1.8, vane_at[] = {-15, 15};
constexpr double tab_x = 14, tab_y = 5;

/// The chord of a slat with both long edges round, drawn about the origin, lying along x.
TopoDS_Shape slat() {
  const double half_length = frame_x / 2 - frame_border + 1;  // into the frame
  const Outline section = {{-slat_chord / 2, -slat_thickness / 2, 0},
                           {slat_chord / 2, -slat_thickness / 2, 0.45 * slat_thickness},
                           {slat_chord / 2, slat_thickness / 2, 0.45 * slat_thickness},
                           {-slat_chord / 2, slat_thickness / 2, 0}};
  gp_Trsf pose;  // section (u, v) to (z, -y) turned by the tilt, its z to x
  pose.SetDisplacement(
      gp_Ax3(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1), gp_Dir(1, 0, 0)),
      gp_Ax3(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0), gp_Dir(0, -std::sin(slat_tilt_rad), std::cos(slat_tilt_rad))));
  return moved(prism(section, -half_length, half_length), pose);
}

}  // namespace

Feature vent() {
  const double inner_x = frame_x - 2 * frame_border;
  const double inner_y = frame_y - 2 * frame_border;
  const Outline outer = rounded_rectangle(frame_x, frame_y, frame_corner);
  const Outline inner = rounded_rectangle(inner_x, inner_y, frame_corner - frame_border);
  TopoDS_Shape frame =
      cut(prism(outer, -duct_depth, frame_top), {prism(inner, -duct_depth - 5, frame_top + 5)});
  frame = fillet(frame, frame_fillet,
                 [](const gp_Pnt& middle, const gp_Dir&) { return near(middle.Z(), frame_top); });
  std::vector<TopoDS_Shape> blades;
  blades.reserve(slats + std::size(vane_at) + 1);
  for (int i = 0; i < slats; ++i) {
    blades.push_back(shifted(slat(), 0, (i - (slats - 1) / 2.0) * slat_pitch, slat_centre_z));
  }
  for (const double x : vane_at) {
    blades.push_back(box(x - vane_thickness / 2, -inner_y / 2 - 1, -18, x + vane_thickness / 2,
                         inner_y / 2 + 1, slat_centre_z - 1));
  }
  // The tab by which the middle slat is turned.
  blades.push_back(
      shifted(prism(rounded_rectangle(tab_x, tab_y, 1.5), slat_centre_z - 2, frame_top - 0.5), 0, -1.5, 0));
  return {prism(rounded_rectangle(frame_x - frame_border, frame_y - frame_border,
                                  frame_corner - frame_border / 2),
                -duct_depth - 5, 20),
          fuse(frame, blades)};
}

}  // namespace fingerpad::parts
