#include "touch/world.hpp"

#include <map>
#include <tuple>

#include "base/content_hash.hpp"
#include "part/import.hpp"

namespace fingerpad {
namespace {

struct LoadedMesh {
  std::shared_ptr<const Part> part;
  std::shared_ptr<const TriangleTree> tree;
  Verdict verdict;
  std::string hash;
};

LoadedMesh load_mesh(const PartEntry& entry) {
  constexpr double rad_per_deg = 0.017453292519943295;
  LoadedMesh mesh;
  ImportedPart imported =
      import_touchable(entry.mesh_path, entry.metres_per_unit, entry.crease_deg * rad_per_deg);
  mesh.part = imported.part;
  mesh.verdict = std::move(imported.verdict);
  mesh.tree = std::make_shared<TriangleTree>(mesh.part);
  mesh.hash = file_hash(entry.mesh_path);
  return mesh;
}

}  // namespace

std::shared_ptr<const World> load_world(const Scene& scene) {
  auto world = std::make_shared<World>();
  // A mesh that stands in several places is read once.
  std::map<std::tuple<std::string, double, double>, LoadedMesh> loaded;
  for (const PartEntry& entry : scene.parts) {
    const auto key = std::make_tuple(entry.mesh_path, entry.metres_per_unit, entry.crease_deg);
    if (!loaded.contains(key)) loaded[key] = load_mesh(entry);
    const LoadedMesh& mesh = loaded[key];
    Surface surface;
    surface.properties = entry.surface;
    surface.part = mesh.part;
    surface.tree = mesh.tree;
    surface.p_WP = entry.position_m;
    surface.R_WP = entry.rotation;
    surface.mesh = entry.mesh;
    surface.mesh_hash = mesh.hash;
    world->surfaces.push_back(std::move(surface));
    world->verdicts.push_back(mesh.verdict);
  }
  for (const PlaneEntry& entry : scene.planes) {
    Surface surface;
    surface.properties = entry.surface;
    surface.plane_point_W = entry.point_m;
    surface.plane_normal_W = entry.normal;
    world->surfaces.push_back(std::move(surface));
  }
  return world;
}

}  // namespace fingerpad
