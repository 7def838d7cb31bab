#include "touch/mesh_store.hpp"

#include <algorithm>
#include <filesystem>
#include <numbers>

#include "base/content_hash.hpp"
#include "part/import.hpp"

namespace fingerpad {
namespace {

// How a load's time is shared out, by the million-triangle mesh.
constexpr double imported_at = 0.5, hashed_at = 0.52, searchable_at = 0.9;

/// Names the mesh that the stages are of.
LoadProgress progress_of(const LoadProgress& whole, const PartEntry& entry) {
  if (!whole) return {};
  return [&whole, file = std::filesystem::path(entry.mesh_path).filename().string()](
             std::string_view stage, double share) { whole(file + ": " + std::string(stage), share); };
}

std::shared_ptr<const LoadedMesh> load_mesh(const PartEntry& entry, const LoadProgress& progress) {
  auto mesh = std::make_shared<LoadedMesh>();
  ImportedPart imported =
      import_touchable(entry.mesh_path, {entry.metres_per_unit, entry.crease_deg * std::numbers::pi / 180,
                                         entry.repair, false, step_of(progress, 0, imported_at)});
  mesh->part = imported.part;
  mesh->verdict = std::move(imported.verdict);
  tell(progress, "hashing", imported_at);
  mesh->hash = file_hash(entry.mesh_path);
  tell(progress, "building the search tree", hashed_at);
  mesh->tree = std::make_shared<TriangleTree>(mesh->part);
  tell(progress, "ready", searchable_at);
  return mesh;
}

}  // namespace

std::shared_ptr<const LoadedMesh> MeshStore::load(const PartEntry& entry) {
  const Key key{entry.mesh_path, entry.metres_per_unit, entry.crease_deg, entry.repair};
  std::promise<std::shared_ptr<const LoadedMesh>> promise;
  Pending pending;
  bool ours = false;
  {
    const std::lock_guard lock(mutex_);
    std::erase(last_used_, key);
    last_used_.push_front(key);
    while (last_used_.size() > keep_) {
      meshes_.erase(last_used_.back());
      last_used_.pop_back();
    }
    ours = !meshes_.contains(key);
    if (ours) meshes_[key] = promise.get_future().share();
    pending = meshes_[key];
  }
  if (ours) {
    try {
      promise.set_value(load_mesh(entry, progress_of(progress_, entry)));
    } catch (...) {
      promise.set_exception(std::current_exception());
    }
  }
  return pending.get();
}

PartMeasures MeshStore::measure(const PartEntry& entry, const LoadedMesh& mesh) {
  std::shared_ptr<Measured> measured;
  {
    const std::lock_guard lock(mutex_);
    std::shared_ptr<Measured>& kept =
        measured_[{mesh.hash, entry.metres_per_unit, entry.crease_deg, entry.repair}];
    if (!kept) kept = std::make_shared<Measured>();
    measured = kept;
  }
  std::call_once(measured->once, [&] {
    tell(progress_of(progress_, entry), "measuring its walls and edges", searchable_at);
    measured->measures = measure_part(*mesh.part, *mesh.tree);
    ++measured_count_;
  });
  return measured->measures;
}

}  // namespace fingerpad
