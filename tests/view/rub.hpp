#pragma once

#include <cmath>
#include <numbers>

#include "contact/triangle_tree.hpp"
#include "part/part.hpp"
#include "support/shapes.hpp"
#include "touch/world.hpp"
#include "view/view_input.hpp"

namespace fingerpad::test {

/// A torus that a finger rubs to and fro along the tube: a tenth of a second in the air, then `seconds` of
/// contact, slip where it is fast and stick at the turning points. Made from formulas, so that pictures can
/// be tested without the physics.
inline ViewInput torus_rub(double seconds = 1.0) {
  ViewInput input;
  input.title = "torus";
  auto world = std::make_shared<World>();
  Surface surface;
  surface.part = std::make_shared<const Part>(make_part(torus_soup(0.05, 0.02, 64, 32), 0.5));
  surface.tree = std::make_shared<const TriangleTree>(surface.part);
  surface.mesh = "parts/torus.stl";
  world->surfaces.push_back(surface);
  input.world = world;
  Scene scene;
  scene.name = "torus";
  input.scene = scene;

  constexpr double pi = std::numbers::pi, tube_angle = 1.2, turn_rad = 0.5;
  const int in_air = 100;
  for (int i = 0; i < in_air + static_cast<int>(1000 * seconds); ++i) {
    TickRecord row;
    row.t_s = 1e-3 * i;
    const double around = -1.2 + turn_rad * std::sin(2 * pi * row.t_s);
    const double pace = std::cos(2 * pi * row.t_s);  // of the fastest
    const Vec3 outwards(std::cos(around), std::sin(around), 0);
    const Vec3 along(-std::sin(around), std::cos(around), 0);
    const Vec3 normal = outwards * std::cos(tube_angle) + Vec3(0, 0, std::sin(tube_angle));
    const Vec3 contact = 0.05 * outwards + 0.02 * normal;
    if (i < in_air) {
      row.p_WQ = contact + 1e-4 * (in_air - i) * normal;
    } else {
      row.phase = std::abs(pace) > 0.4 ? Phase::slip : Phase::stick;
      row.depth_m = 1e-3;
      row.p_WQ = contact - row.depth_m * normal;
      row.contact_W = contact;
      row.normal_W = normal;
      row.normal_force_n = 1;
      row.friction_W_n = along * (-0.2 * std::tanh(4 * pace));
      row.force_W_n = row.normal_force_n * normal + row.friction_W_n;
      row.mu = row.friction_W_n.norm();
      row.inclination_rad = 0.8;
      row.surface = 0;
      row.triangle = 7;
      if (row.phase == Phase::stick) row.stick_centre_W = contact + row.friction_W_n * 1e-3;
    }
    input.rows.push_back(row);
  }
  return input;
}

}  // namespace fingerpad::test
