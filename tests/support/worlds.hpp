#pragma once

#include <memory>

#include "contact/triangle_tree.hpp"
#include "part/part.hpp"
#include "scene/scene.hpp"
#include "touch/world.hpp"

namespace fingerpad::test {

/// The plane z = 0, outward +z, with the default surface: 1000 N/m, mu 0.3 and 0.2.
inline std::shared_ptr<const World> plane_world() {
  auto world = std::make_shared<World>();
  world->surfaces.emplace_back();
  return world;
}

/// One part at the origin with the default surface.
inline std::shared_ptr<const World> world_of(const TriangleSoup& soup) {
  auto world = std::make_shared<World>();
  Surface surface;
  surface.part = std::make_shared<const Part>(make_part(soup, 30 * 0.017453292519943295));
  surface.tree = std::make_shared<const TriangleTree>(surface.part);
  world->surfaces.push_back(surface);
  return world;
}

/// A scene of defaults with this law.
inline Scene plane_scene(const std::string& law) {
  Scene scene;
  scene.name = "test";
  scene.friction.law = law;
  return scene;
}

}  // namespace fingerpad::test
