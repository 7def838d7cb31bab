#include "touch/world.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <limits>

#include "base/printable_text.hpp"
#include "part/part.hpp"
#include "touch/mesh_store.hpp"
#include "touch/unit_hints.hpp"

namespace fingerpad {

std::string shown_name(const Surface& surface) {
  return surface.is_plane() ? std::string(surface.kind().name)
                            : std::filesystem::path(surface.mesh).filename().string();
}

std::string counted_name(const World& world, std::size_t surface) {
  const Surface& named = world.surfaces[surface];
  const auto before = world.surfaces.begin() + static_cast<std::ptrdiff_t>(surface);
  const auto alike = std::count_if(world.surfaces.begin(), before, [&named](const Surface& other) {
    return other.is_plane() == named.is_plane();
  });
  if (named.is_plane()) return fmt::format("plane {}", alike + 1);
  return fmt::format("part {} ({})", alike + 1, printable(named.mesh, 200));
}

bool any_planes_meet(std::span<const Surface> surfaces) noexcept {
  constexpr double parallel2 = 1e-24;
  const auto is_plane = [](const Surface& surface) { return surface.is_plane(); };
  const auto first = std::ranges::find_if(surfaces, is_plane);
  return std::any_of(first, surfaces.end(), [&](const Surface& other) {
    return is_plane(other) && first->plane_normal_W.cross(other.plane_normal_W).squaredNorm() > parallel2;
  });
}

bool needs_no_method(const World& world) noexcept {
  return std::ranges::all_of(world.surfaces, [](const Surface& surface) { return surface.is_plane(); }) &&
         !any_planes_meet(world.surfaces);
}

int triangles_of(std::span<const Surface> surfaces) {
  std::int64_t sum = 0;  // of parts that each fit into an int
  for (const Surface& surface : surfaces) sum += surface.part ? surface.part->triangle_count() : 0;
  return static_cast<int>(std::min<std::int64_t>(sum, std::numeric_limits<int>::max()));
}

std::vector<PlacedSurface> placed_surfaces(const World& world) {
  return {world.surfaces.begin(), world.surfaces.end()};
}

namespace {

void prepare_normals(const World& world, const Scene& scene) {
  const auto prepare = settled_contact(scene, world).normals->prepare;
  if (prepare == nullptr) return;
  for (const Surface& surface : world.surfaces) {
    if (surface.tree) prepare(*surface.tree);
  }
}

/// Chosen for the world, or for another like it.
ContactChoice chosen_contact(const World& world, const Scene& scene, MeshStore& meshes,
                             std::span<const std::shared_ptr<const LoadedMesh>> loaded) {
  if (!leaves_a_choice(scene.contact)) return choose_contact(scene, world.surfaces, {});
  const std::string key = choice_key(scene, world);
  if (const auto known = meshes.choices().find(key)) return *known;
  std::vector<PartMeasures> measures;
  for (std::size_t i = 0; i < loaded.size(); ++i)
    measures.push_back(meshes.measure(scene.parts[i], *loaded[i]));
  const ContactChoice choice = choose_contact(scene, world.surfaces, measures);
  meshes.choices().keep(key, choice);
  return choice;
}

}  // namespace

void settle_contact(World& world, const Scene& scene, std::span<const PartMeasures> measures) {
  world.contact = choose_contact(scene, world.surfaces, measures);
  prepare_normals(world, scene);
}

std::shared_ptr<const World> load_world(const Scene& scene, const LoadProgress& progress) {
  MeshStore meshes(scene.parts.size() + 1, progress);
  return load_world(scene, meshes);
}

std::shared_ptr<const World> load_world(const Scene& scene, MeshStore& meshes) {
  auto world = std::make_shared<World>();
  std::vector<std::shared_ptr<const LoadedMesh>> loaded;
  for (const PartEntry& entry : scene.parts) {
    const auto& mesh = loaded.emplace_back(meshes.load(entry));
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
  }
  for (const PlaneEntry& entry : scene.planes) {
    Surface surface;
    surface.properties = entry.surface;
    surface.plane_point_W = entry.point_m;
    surface.plane_normal_W = entry.normal;
    world->surfaces.push_back(std::move(surface));
  }
  refuse_huge_finger(*world, scene);  // before a choice is reckoned for it
  world->contact = chosen_contact(*world, scene, meshes, loaded);
  prepare_normals(*world, scene);
  return world;
}

}  // namespace fingerpad
