#include "view/recorded_parts.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "base/content_hash.hpp"
#include "base/error.hpp"
#include "scene/scene_file.hpp"
#include "touch/mesh_store.hpp"

namespace fingerpad {
namespace {

std::optional<Scene> scene_of(const Trace& trace, const std::string& path) {
  if (trace.info.scene_text.empty()) return std::nullopt;
  try {
    return read_recorded_scene(trace.info.scene_text, trace.info.profile_text, path);
  } catch (const Error&) {  // its files are gone perhaps
    return std::nullopt;
  }
}

/// What has become of the mesh of a part whose shape the trace holds; nothing where that is as it was.
std::string fate_of(const PartEntry& entry, const std::string& hash) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(entry.mesh_path, none)) {
    // A trace does not know the folder of its scene: from elsewhere a mesh beside that cannot be missed.
    if (std::filesystem::path(entry.mesh).is_relative()) return "";
    return fmt::format("{}: is no longer there; the shape is the one that the trace holds", entry.mesh_path);
  }
  if (!hash.empty() && file_hash(entry.mesh_path) != hash)
    return fmt::format("{}: has changed since; the shape is the one that the trace holds", entry.mesh_path);
  return "";
}

/// A part that the trace holds by name alone.
void load_part(const PartEntry& entry, const std::string& hash, MeshStore& meshes, RecordedParts& parts) {
  try {
    const auto mesh = meshes.load(entry);
    Surface surface;
    surface.part = mesh->part;
    surface.p_WP = entry.position_m;
    surface.R_WP = entry.rotation;
    surface.mesh = entry.mesh;
    parts.surfaces.push_back(std::move(surface));
    if (!hash.empty() && mesh->hash != hash)
      parts.missing.push_back(
          fmt::format("{}: has changed since the trace was made; it is shown as it is now", entry.mesh_path));
  } catch (const Error& error) {
    parts.missing.push_back(fmt::format(
        "{}; the trace does not hold its shape, so it is left out: put it back where it was", error.what()));
  }
}

std::string hash_at(const TraceInfo& info, std::size_t i) {
  return i < info.mesh_hashes.size() ? info.mesh_hashes[i] : "";
}

}  // namespace

RecordedParts recorded_parts(const Trace& trace, const std::string& path) {
  RecordedParts parts;
  const std::optional<Scene> scene = scene_of(trace, path);
  if (trace.world) {
    parts.surfaces = trace.world->surfaces;
    for (std::size_t i = 0; scene && i < scene->parts.size(); ++i) {
      const std::string fate = fate_of(scene->parts[i], hash_at(trace.info, i));
      if (!fate.empty()) parts.missing.push_back(fate);
    }
    return parts;
  }
  if (!scene) {
    parts.missing.push_back(fmt::format(
        "{}: does not say what the finger touched, so no parts are beside the path; an HDF5 trace "
        "does",
        path));
    return parts;
  }
  MeshStore meshes(scene->parts.size() + 1);
  for (std::size_t i = 0; i < scene->parts.size(); ++i) {
    load_part(scene->parts[i], hash_at(trace.info, i), meshes, parts);
  }
  for (const PlaneEntry& entry : scene->planes) {
    Surface plane;
    plane.plane_point_W = entry.point_m;
    plane.plane_normal_W = entry.normal;
    parts.surfaces.push_back(std::move(plane));
  }
  return parts;
}

}  // namespace fingerpad
