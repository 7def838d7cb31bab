#include "touch/world.hpp"

#include "touch/mesh_store.hpp"

namespace fingerpad {

std::vector<PlacedSurface> placed_surfaces(const World& world) {
  return {world.surfaces.begin(), world.surfaces.end()};
}

void settle_contact(World& world, const Scene& scene, std::span<const PartMeasures> measures) {
  world.contact = choose_contact(scene, world.surfaces, measures);
  const auto prepare = settled_contact(scene, world).normals->prepare;
  if (prepare == nullptr) return;
  for (const Surface& surface : world.surfaces) {
    if (surface.tree) prepare(*surface.tree);
  }
}

std::shared_ptr<const World> load_world(const Scene& scene, const LoadProgress& progress) {
  MeshStore meshes(scene.parts.size() + 1, progress);
  return load_world(scene, meshes);
}

std::shared_ptr<const World> load_world(const Scene& scene, MeshStore& meshes) {
  auto world = std::make_shared<World>();
  std::vector<PartMeasures> measures;
  for (const PartEntry& entry : scene.parts) {
    const auto mesh = meshes.load(entry);
    Surface surface;
    surface.properties = entry.surface;
    surface.part = mesh->part;
    surface.tree = mesh->tree;
    surface.p_WP = entry.position_m;
    surface.R_WP = entry.rotation;
    surface.mesh = entry.mesh;
    surface.mesh_hash = mesh->hash;
    world->surfaces.push_back(std::move(surface));
    world->verdicts.push_back(mesh->verdict);
    if (leaves_a_choice(scene.contact)) measures.push_back(meshes.measure(entry, *mesh));
  }
  for (const PlaneEntry& entry : scene.planes) {
    Surface surface;
    surface.properties = entry.surface;
    surface.plane_point_W = entry.point_m;
    surface.plane_normal_W = entry.normal;
    world->surfaces.push_back(std::move(surface));
  }
  settle_contact(*world, scene, measures);
  return world;
}

}  // namespace fingerpad
