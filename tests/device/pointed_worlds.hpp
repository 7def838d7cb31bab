#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "device/pointer_hand.hpp"
#include "scene/scene_file.hpp"
#include "support/paths.hpp"

namespace fingerpad::test {

/// A real part in whatever unit makes it as large as a hand.
inline PointedWorld real_part(const std::filesystem::path& mesh) {
  Scene scene;
  scene.name = mesh.filename().string();
  scene.contact.automatic_normals = true;
  PartEntry& part = scene.parts.emplace_back();
  part.mesh = scene.name;
  part.mesh_path = mesh.string();
  part.metres_per_unit = 1;
  const double radius_m = PointedWorld(scene.name, scene, load_world(scene)).radius_m;
  scene.parts.front().metres_per_unit = 0.08 / radius_m;
  return {scene.name, scene, load_world(scene)};
}

/// Scenes with a ball and with a plane; parts with thin walls, holes, wings, an open mesh, a slot.
inline std::vector<PointedWorld> pointed_worlds() {
  std::vector<PointedWorld> worlds;
  for (const char* name : {"bracket", "housing", "dashboard", "laboratory"}) {
    const auto path = source_dir() / "scenes" / (std::string(name) + ".toml");
    const Scene scene = read_scene_file(path.string()).scene;
    worlds.emplace_back(name, scene, load_world(scene));
  }
  const auto data = real_data();
  if (!data) return worlds;
  for (const char* name : {"so101_base.stl", "trimesh_plate_holes.stl", "wingnut.obj",
                           "prius_steering_wheel.obj", "so101_waveshare_plate.stl"})
    worlds.push_back(real_part(*data / "parts" / name));
  return worlds;
}

}  // namespace fingerpad::test
