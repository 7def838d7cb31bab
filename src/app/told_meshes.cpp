#include "app/told_meshes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>

#include "base/file_identity.hpp"

namespace fingerpad {

std::string file_words(const std::string& path) {
  const std::filesystem::path name(path);
  if (const auto identity = file_identity(path)) return *identity + name.extension().string();
  std::error_code failed;
  const std::string whole = std::filesystem::weakly_canonical(name, failed).string();
  return failed ? path : whole;
}

std::string mesh_keys(const PartEntry& entry) {
  return fmt::format("{}\n{} {} {}\n", file_words(entry.mesh_path), entry.metres_per_unit, entry.crease_deg,
                     entry.repair);
}

std::string part_keys(const Scene& scene) {
  std::string keys;
  for (const PartEntry& entry : scene.parts) keys += mesh_keys(entry);
  return keys;
}

bool ToldMeshes::look_at(const Scene& scene) {
  turn_to(scene);
  bool all_touchable = true;
  std::map<std::string, std::size_t> times;
  for (const PartEntry& entry : scene.parts) {
    const std::string keys = mesh_keys(entry);
    const std::size_t time = times[keys]++;
    const auto known = told_.find(keys);
    const bool is_told =
        known != told_.end() && (!known->second.verdict.touchable || time < known->second.objects.size());
    if (!is_told) {
      const CheckedMesh& mesh = read(entry);
      Told& told = told_[keys];
      told.objects.push_back(report_->size());
      tell_mesh(mesh, as_json_, *report_);
      told.verdict = mesh.imported.verdict;
    }
    all_touchable &= told_[keys].verdict.touchable;
  }
  return all_touchable;
}

World ToldMeshes::world(const Scene& scene) {
  turn_to(scene);
  World world = world_in_words(scene);
  for (const PartEntry& entry : scene.parts) {
    const CheckedMesh& mesh = read(entry);
    Surface& surface = world.surfaces.emplace_back();
    surface.mesh = entry.mesh;
    surface.part = mesh.imported.part;
    surface.tree = mesh.tree;
    surface.p_WP = entry.position_m;
    surface.R_WP = entry.rotation;
  }
  for (const PlaneEntry& plane : scene.planes) {
    Surface& surface = world.surfaces.emplace_back();
    surface.plane_point_W = plane.point_m;
    surface.plane_normal_W = plane.normal;
  }
  return world;
}

World ToldMeshes::world_in_words(const Scene& scene) const {
  World world;
  for (const PartEntry& entry : scene.parts) world.verdicts.push_back(told_.at(mesh_keys(entry)).verdict);
  return world;
}

std::vector<std::size_t> ToldMeshes::objects(const Scene& scene) const {
  std::vector<std::size_t> objects;
  std::map<std::string, std::size_t> times;
  for (const PartEntry& entry : scene.parts) {
    const std::string keys = mesh_keys(entry);
    objects.push_back(told_.at(keys).objects[times[keys]++]);
  }
  return objects;
}

int ToldMeshes::count() const noexcept {
  return static_cast<int>(told_.size());
}

int ToldMeshes::refused() const noexcept {
  return static_cast<int>(std::count_if(told_.begin(), told_.end(),
                                        [](const auto& mesh) { return !mesh.second.verdict.touchable; }));
}

void ToldMeshes::turn_to(const Scene& scene) {
  at_hand_.clear();
  for (const PartEntry& entry : scene.parts) at_hand_.insert(mesh_keys(entry));
}

/// From memory, where the scene at hand, or the one before, has it.
const CheckedMesh& ToldMeshes::read(const PartEntry& entry) {
  const std::string keys = mesh_keys(entry);
  const auto known = kept_.find(keys);
  if (known != kept_.end()) return known->second;
  std::erase_if(kept_, [this](const auto& kept) { return !at_hand_.contains(kept.first); });
  ImportOptions how;
  how.metres_per_unit = entry.metres_per_unit;
  how.crease_rad = entry.crease_deg * std::numbers::pi / 180;
  how.repair = entry.repair;
  return kept_.emplace(keys, checked(entry.mesh_path, how)).first->second;
}

}  // namespace fingerpad
