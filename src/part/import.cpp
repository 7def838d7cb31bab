#include "part/import.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <utility>

#include "base/error.hpp"
#include "base/input_file.hpp"
#include "part/build_part.hpp"
#include "part/fan.hpp"
#include "part/mesh_format.hpp"
#include "part/plain_text.hpp"
#include "part/raw_mesh.hpp"
#include "part/reconcile.hpp"
#include "part/sniff.hpp"
#include "part/verdict_words.hpp"

namespace fingerpad {
namespace {

std::vector<bool> used_vertices(const RawMesh& mesh) {
  std::vector<bool> used(mesh.vertices.size(), false);
  for (const int corner : mesh.corners) {
    if (corner >= 0) used[static_cast<std::size_t>(corner)] = true;
  }
  return used;
}

/// Throws where a face uses a vertex that is nowhere.
void refuse_nonfinite(const RawMesh& mesh, const std::vector<bool>& used) {
  long count = 0;
  std::size_t place = 0;
  int first = -1;
  for (const auto& [vertex, where] : mesh.nonfinite) {
    if (!used[static_cast<std::size_t>(vertex)]) continue;
    if (count++ > 0) continue;
    first = vertex;
    place = where;
  }
  if (count == 0) return;
  const Vec3& p = mesh.vertices[static_cast<std::size_t>(first)];
  throw refused(
      fmt::format("{} {}", mesh.place_unit, place),
      fmt::format("vertex {} has a coordinate that is not finite ({}, {}, {}); {} such {} in the faces",
                  first, p.x(), p.y(), p.z(), count, count == 1 ? "vertex" : "vertices"));
}

/// OpenMesh compares every corner of a face with every other.
void refuse_huge_faces(const RawMesh& mesh) {
  constexpr int most_corners = 20000;
  for (int i = 0; i < mesh.polygon_count(); ++i) {
    if (mesh.corner_count(i) <= most_corners) continue;
    throw refused("", fmt::format("face {} has {} corners; at most {} are read: export it as triangles", i,
                                  mesh.corner_count(i), most_corners));
  }
}

/// Lets OpenMesh read what was scanned, and measures what that does to the coordinates.
void deliver(RawMesh& mesh, const std::string& bytes, const MeshFormat& format, const std::vector<bool>& used,
             const ImportOptions& options, Verdict& verdict) {
  const double metres_per_unit = options.metres_per_unit;
  const std::vector<Vec3> said = mesh.float32 ? std::vector<Vec3>() : mesh.vertices;
  const std::string lost = reconcile(mesh, format.read(bytes, mesh, step_of(options.progress, 0.15, 0.35)));
  if (!lost.empty()) verdict.warnings.push_back(lost);
  double largest = 0;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (!used[v]) continue;
    largest = std::max(largest, mesh.vertices[v].cwiseAbs().maxCoeff());
    if (said.empty()) continue;
    verdict.rounding_m = std::max(verdict.rounding_m, metres_per_unit * (mesh.vertices[v] - said[v]).norm());
  }
  const auto as_float = static_cast<float>(largest);
  const float step = std::nextafter(as_float, std::numeric_limits<float>::infinity()) - as_float;
  verdict.resolution_m = metres_per_unit * static_cast<double>(step);
}

void fill_census(const Census& census, Verdict& verdict) {
  verdict.degenerate = census.degenerate;
  verdict.duplicate = census.duplicate;
  verdict.nonmanifold_edges = census.nonmanifold_edges;
  verdict.boundary_edges = census.boundary_edges;
  verdict.inconsistent_edges = census.inconsistent_edges;
  verdict.components = census.components;
  verdict.winding_consistent = census.inconsistent_edges == 0;
  verdict.closed = census.closed;
  verdict.volume_m3 = census.volume_m3;
  verdict.weld_distance_m = census.weld_distance_m;
}

std::string why_no_triangle(const RawMesh& mesh, const Fan& fan) {
  if (fan.out_of_range > 0) {
    return fmt::format("holds no triangle: all {} name vertices that are out of range (the file has {})",
                       fan.triangles, mesh.vertices.size());
  }
  if (mesh.vertices.empty()) return "holds no triangle: the mesh is empty";
  return fmt::format("holds no triangle, only {} points", mesh.vertices.size());
}

std::shared_ptr<const Part> read(const std::string& path, const ImportOptions& options, Verdict& verdict) {
  tell(options.progress, "reading", 0);
  std::string bytes = read_whole_file(path, {"a mesh", std::uint64_t{2} << 30, options.stream}, "");
  make_text_plain(bytes);
  const MeshFormat& format = mesh_format(path, bytes);
  RawMesh mesh = format.scan(bytes);
  verdict.format = mesh.format;
  verdict.warnings = mesh.warnings;
  verdict.vertices = static_cast<long>(mesh.vertices.size());
  const std::vector<bool> used = used_vertices(mesh);
  for (int i = 0; i < mesh.polygon_count(); ++i) verdict.triangles += mesh.corner_count(i) - 2;
  refuse_nonfinite(mesh, used);
  refuse_huge_faces(mesh);
  if (mesh.polygon_count() > 0 && format.read != nullptr)
    deliver(mesh, bytes, format, used, options, verdict);
  bytes = std::string();
  const Fan fan = fan_polygons(mesh, options.metres_per_unit);
  verdict.out_of_range = fan.out_of_range;
  if (fan.soup.triangles.cols() == 0) throw refused("", why_no_triangle(mesh, fan));
  verdict.repaired = options.repair;
  const LoadProgress progress = step_of(options.progress, 0.4, 1);
  BuiltPart built = options.repair ? build_repaired_part(fan.soup, options.crease_rad, progress)
                                   : build_part(fan.soup, options.crease_rad, progress);
  fill_census(built.census, verdict);
  verdict.kept = built.part.triangle_count();
  if (verdict.kept == 0) {
    throw refused("", fmt::format("holds no triangle with an area: all {} are collapsed to lines or points",
                                  verdict.triangles));
  }
  verdict.bounds_m = bounds_P(built.part);
  add_warnings(mesh, fan, built, verdict);
  return std::make_shared<const Part>(std::move(built.part));
}

}  // namespace

ImportedPart import_part(const std::string& path, const ImportOptions& options) {
  ImportedPart imported;
  Verdict& verdict = imported.verdict;
  verdict.file = path;
  try {
    imported.part = read(path, options, verdict);
    verdict.touchable = true;
  } catch (const std::bad_alloc&) {
    verdict.error = "needs more memory than there is";
  } catch (const std::exception& problem) {
    verdict.error = problem.what();
  }
  return imported;
}

ImportedPart import_part(const std::string& path, double metres_per_unit, double crease_rad) {
  return import_part(path, {metres_per_unit, crease_rad, false, false, {}});
}

ImportedPart import_touchable(const std::string& path, const ImportOptions& options) {
  ImportedPart imported = import_part(path, options);
  if (!imported.part) throw refused(path, imported.verdict.error);
  return imported;
}

ImportedPart import_touchable(const std::string& path, double metres_per_unit, double crease_rad) {
  return import_touchable(path, {metres_per_unit, crease_rad, false, false, {}});
}

}  // namespace fingerpad
