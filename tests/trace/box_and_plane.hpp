#pragma once

#include <memory>
#include <numbers>

#include "support/shapes.hpp"
#include "touch/world.hpp"

namespace fingerpad::test {

/// A box of 40 x 30 x 20 mm that is turned and moved, and a plane.
inline World box_and_plane() {
  World world;
  Surface box;
  box.properties = {1500, 0.5, 0.4, 0.25};
  const TriangleSoup soup = moved(box_soup(Vec3(0.04, 0.03, 0.02)), Vec3(10, 0, 0));
  box.part = std::make_shared<const Part>(make_part(soup, 100 * std::numbers::pi / 180));
  box.p_WP = Vec3(1, 2, 3);
  box.R_WP << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  box.mesh = "box.stl";
  box.mesh_hash = "0123456789abcdef";
  world.surfaces.push_back(box);
  Surface plane;
  plane.plane_point_W = Vec3(0, 0, 0.5);
  plane.plane_normal_W = Vec3(0.6, 0, 0.8);
  world.surfaces.push_back(plane);
  return world;
}

}  // namespace fingerpad::test
