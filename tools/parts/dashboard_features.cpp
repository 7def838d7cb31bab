#include "dashboard_features.hpp"

#include <cmath>

#include "solids.hpp"

namespace fingerpad::parts {
namespace {

constexpr double insert_bottom = -9, hole_bottom = -30, hole_top = 30;

constexpr double bezel_width = 9, bezel_height = 7, bezel_fillet = 3, dial_z = -5, dial_fillet = 2;
constexpr double hub_radius = 6, hub_top = 0.5, tick_width = 1.6, tick_height = 0.8;
constexpr double needle_width = 3, needle_rad = 0.9;

constexpr double knob_base_radius = 30, knob_base_top = 2.2, knob_dish_radius = 25, knob_dish_z = -2;
constexpr double knob_radius = 19, knob_top = 16, knob_fillet = 2.5, knob_dip_radius = 13, knob_dip = 1;
constexpr int knob_grips = 30;
constexpr double grip_radius = 1.3, pointer_width = 2.6;

constexpr double button_frame_x = 112, button_frame_y = 46, button_border = 3, button_frame_top = 1.4;
constexpr double button_x = 24, button_y = 18, button_gap = 2, button_floor = -3.5, button_top = 1.2;
constexpr int button_columns = 4, button_rows = 2;

constexpr double tray_x = 90, tray_y = 54, tray_border = 4, tray_depth = 14, tray_corner = 12,
                 tray_floor_fillet = 6;
constexpr double tray_rim = 1.5;

EdgeChoice at_height(double z) {
  return [z](const gp_Pnt& middle, const gp_Dir&) { return near(middle.Z(), z); };
}

}  // namespace

Feature instrument(double bezel_radius_mm, int tick_marks) {
  const double dial_radius = bezel_radius_mm - bezel_width;
  const Outline section = {{0, insert_bottom, 0},
                           {bezel_radius_mm, insert_bottom, 0},
                           {bezel_radius_mm, bezel_height, bezel_fillet},
                           {dial_radius, bezel_height, bezel_fillet},
                           {dial_radius, dial_z, dial_fillet},
                           {hub_radius, dial_z, 1},
                           {hub_radius, hub_top, 1},
                           {0, hub_top, 0}};
  std::vector<TopoDS_Shape> marks;
  constexpr double sweep_rad = 4.4;  // of the scale, open towards the driver
  for (int i = 0; i < tick_marks; ++i) {
    const double angle = -M_PI / 2 + (2 * M_PI - sweep_rad) / 2 + sweep_rad * i / (tick_marks - 1);
    const double length = i % 5 == 0 ? 9 : 5.5;
    const double outer = dial_radius - dial_fillet - 1.5;
    marks.push_back(
        moved(box(outer - length, -tick_width / 2, dial_z - 1, outer, tick_width / 2, dial_z + tick_height),
              turn(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1), angle)));
  }
  const double tip = dial_radius - dial_fillet - 12;
  const Outline needle = {
      {0, -needle_width, 0}, {tip, -needle_width / 3, 0}, {tip, needle_width / 3, 0}, {0, needle_width, 0}};
  marks.push_back(moved(prism(needle, dial_z + 2, dial_z + 3.5),
                        turn(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1), M_PI - needle_rad)));
  return {cylinder(0, 0, bezel_radius_mm - bezel_width / 2, hole_bottom, hole_top),
          fuse(turned(section), marks)};
}

Feature knob() {
  const Outline section = {{0, insert_bottom, 0},
                           {knob_base_radius, insert_bottom, 0},
                           {knob_base_radius, knob_base_top, 1.5},
                           {knob_dish_radius, knob_base_top, 1.5},
                           {knob_dish_radius - 2, knob_dish_z, 1},
                           {knob_radius, knob_dish_z, 0},
                           {knob_radius, knob_top, knob_fillet},
                           {knob_dip_radius, knob_top, 1},
                           {knob_dip_radius - 2, knob_top - knob_dip, 1},
                           {0, knob_top - knob_dip, 0}};
  std::vector<TopoDS_Shape> grips;
  for (int i = 0; i < knob_grips; ++i) {
    const double angle = 2 * M_PI * (i + 0.5) / knob_grips;
    grips.push_back(cylinder((knob_radius + 0.5) * std::cos(angle), (knob_radius + 0.5) * std::sin(angle),
                             grip_radius, knob_dish_z + 1.5, knob_top + 5));
  }
  const TopoDS_Shape pointer = fillet(box(-pointer_width / 2, -2, knob_top - knob_dip - 1, pointer_width / 2,
                                          knob_dip_radius + 2, knob_top + 1),
                                      0.8, at_height(knob_top + 1));
  return {cylinder(0, 0, knob_base_radius - 2, hole_bottom, hole_top),
          fuse(cut(turned(section), grips), {pointer})};
}

Feature buttons() {
  const double inner_x = button_frame_x - 2 * button_border;
  const double inner_y = button_frame_y - 2 * button_border;
  const TopoDS_Shape frame =
      fillet(prism(rounded_rectangle(button_frame_x, button_frame_y, 6), insert_bottom, button_frame_top), 1,
             at_height(button_frame_top));
  TopoDS_Shape insert = cut(frame, {prism(rounded_rectangle(inner_x, inner_y, 3), button_floor, hole_top)});
  const TopoDS_Shape key =
      fillet(prism(rounded_rectangle(button_x, button_y, 3), button_floor - 1, button_top), 1,
             at_height(button_top));
  std::vector<TopoDS_Shape> keys;
  for (int column = 0; column < button_columns; ++column) {
    for (int row = 0; row < button_rows; ++row) {
      keys.push_back(shifted(key, (column - (button_columns - 1) / 2.0) * (button_x + button_gap),
                             (row - (button_rows - 1) / 2.0) * (button_y + button_gap), 0));
    }
  }
  return {prism(rounded_rectangle(button_frame_x - 4, button_frame_y - 4, 4), hole_bottom, hole_top),
          fuse(insert, keys)};
}

Feature tray() {
  const TopoDS_Shape block =
      fillet(prism(rounded_rectangle(tray_x, tray_y, tray_corner), -tray_depth - 3, tray_rim), 1.2,
             at_height(tray_rim));
  TopoDS_Shape cavity =
      prism(rounded_rectangle(tray_x - 2 * tray_border, tray_y - 2 * tray_border, tray_corner - tray_border),
            -tray_depth, hole_top);
  cavity = fillet(cavity, tray_floor_fillet, at_height(-tray_depth));
  TopoDS_Shape insert = fillet(cut(block, {cavity}), 1.2, [](const gp_Pnt& middle, const gp_Dir&) {
    const bool inside = std::abs(middle.X()) < tray_x / 2 - tray_border + 1e-3 &&
                        std::abs(middle.Y()) < tray_y / 2 - tray_border + 1e-3;
    return near(middle.Z(), tray_rim) && inside;
  });
  return {prism(rounded_rectangle(tray_x - tray_border, tray_y - tray_border, tray_corner - tray_border / 2),
                hole_bottom, hole_top),
          insert};
}

}  // namespace fingerpad::parts
