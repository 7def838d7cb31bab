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

/// What the arrays of a part take.
std::size_t bytes_of(const Part& part) {
  const auto numbers = part.vertices.size() + part.facet_normals.size() + part.edge_pseudonormals.size() +
                       part.vertex_pseudonormals.size() + part.corner_normals.size();
  const auto indices = part.triangles.size() + part.welded.size() + part.neighbours.size();
  return static_cast<std::size_t>(numbers) * sizeof(double) +
         static_cast<std::size_t>(indices) * sizeof(int) + part.file_triangle.size() * sizeof(int) +
         part.creases.size();
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
  mesh->bytes = bytes_of(*mesh->part) + mesh->tree->memory_bytes();
  tell(progress, "ready", searchable_at);
  return mesh;
}

}  // namespace

std::shared_ptr<const LoadedMesh> MeshStore::load(const PartEntry& entry) {
  const Key key = key_of(entry);
  std::promise<std::shared_ptr<const LoadedMesh>> promise;
  Pending pending;
  bool ours = false;
  {
    const std::lock_guard lock(mutex_);
    std::erase(last_used_, key);
    last_used_.push_front(key);
    drop_beyond_bounds();
    ours = !meshes_.contains(key);
    if (ours) meshes_[key] = promise.get_future().share();
    if (ours) ++loading_;
    pending = meshes_[key];
  }
  if (ours) {
    try {
      const auto mesh = load_mesh(entry, progress_of(progress_, entry));
      promise.set_value(mesh);
      const std::lock_guard lock(mutex_);
      --loading_;
      largest_bytes_ = std::max(largest_bytes_, mesh->bytes);
      if (most_bytes_ > 0 && mesh->bytes > most_bytes_) large_[key] = mesh->bytes;
      if (meshes_.contains(key)) {
        bytes_ -= sizes_[key];  // of one that was dropped and asked for again meanwhile
        bytes_ += sizes_[key] = mesh->bytes;
      }
      drop_beyond_bounds();
    } catch (...) {
      promise.set_exception(std::current_exception());
      const std::lock_guard lock(mutex_);
      --loading_;
    }
  }
  return pending.get();
}

MeshStore::Key MeshStore::key_of(const PartEntry& entry) {
  return {entry.mesh_path, entry.metres_per_unit, entry.crease_deg, entry.repair};
}

void MeshStore::drop(const Key& key) {
  std::erase(last_used_, key);
  meshes_.erase(key);
  if (const auto size = sizes_.find(key); size != sizes_.end()) {
    bytes_ -= size->second;
    sizes_.erase(size);
  }
}

void MeshStore::drop_beyond_bounds() {
  const auto is_beyond = [this] {
    return most_bytes_ > 0 ? bytes_ > most_bytes_ : last_used_.size() > keep_;
  };
  while (is_beyond() && last_used_.size() > 1) drop(Key(last_used_.back()));
}

void MeshStore::bound_memory(std::size_t most_bytes) {
  const std::lock_guard lock(mutex_);
  most_bytes_ = most_bytes;
}

bool MeshStore::has_room_for_another() {
  const std::lock_guard lock(mutex_);
  return most_bytes_ == 0 || (largest_bytes_ > 0 && bytes_ + (loading_ + 1) * largest_bytes_ <= most_bytes_);
}

void MeshStore::expect(const PartEntry& entry) {
  const std::lock_guard lock(mutex_);
  ++uses_left_[key_of(entry)];
}

void MeshStore::done(const PartEntry& entry) {
  const std::lock_guard lock(mutex_);
  const auto uses = uses_left_.find(key_of(entry));
  if (uses == uses_left_.end() || --uses->second > 0) return;
  drop(uses->first);
  uses_left_.erase(uses);
}

std::size_t MeshStore::oversize(const PartEntry& entry) {
  const std::lock_guard lock(mutex_);
  const auto large = large_.find(key_of(entry));
  return large == large_.end() ? 0 : large->second;
}

std::size_t MeshStore::kept_count() {
  const std::lock_guard lock(mutex_);
  return sizes_.size();
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
