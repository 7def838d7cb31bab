#include "trace/embedded_surfaces.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "part/part.hpp"
#include "scene/scene_file.hpp"
#include "touch/world.hpp"

namespace fingerpad {
namespace {

constexpr double default_crease_deg = 30;
constexpr std::uint64_t max_surfaces = 100000;
constexpr int max_embedded_vertices = 3 * max_embedded_triangles;

bool is_embedded(const Part& part) {
  return part.triangle_count() <= max_embedded_triangles && part.vertices.cols() <= max_embedded_vertices;
}

void write_vector(const hdf5::Handle& group, const std::string& name, const Vec3& vector) {
  hdf5::write_numbers(group, name, std::span(vector.data(), 3));
}

Vec3 read_vector(const hdf5::Handle& group, const std::string& name) {
  const auto values = hdf5::read_numbers(group, name, 3);
  return {values[0], values[1], values[2]};
}

double read_number(const hdf5::Handle& group, const std::string& name) {
  return hdf5::read_numbers(group, name, 1).front();
}

void write_properties(const hdf5::Handle& group, const SurfaceProperties& properties) {
  const auto write = [&group](const char* name, double value) {
    hdf5::write_numbers(group, name, std::span(&value, 1));
  };
  write("stiffness_n_per_m", properties.stiffness_n_per_m);
  write("damping_n_s_per_m", properties.damping_n_s_per_m);
  write("mu_static", properties.mu_static);
  write("mu_dynamic", properties.mu_dynamic);
}

void write_part(const hdf5::Handle& group, const Surface& surface, double crease_deg, hdf5::Packing packing) {
  const Part& part = *surface.part;
  hdf5::write_text(group, "kind", "part");
  hdf5::write_text(group, "mesh", surface.mesh);
  hdf5::write_text(group, "mesh_hash", surface.mesh_hash);
  write_vector(group, "position_m", surface.p_WP);
  const Mat3 rows = surface.R_WP.transpose();
  hdf5::write_numbers(group, "rotation", std::span(rows.data(), 9));
  hdf5::write_numbers(group, "crease_deg", std::span(&crease_deg, 1));
  const Bounds bounds = bounds_P(part);
  write_vector(group, "min_m", bounds.min);
  write_vector(group, "max_m", bounds.max);
  if (!is_embedded(part)) return;
  hdf5::write_table(group, "vertices_m", Points(part.vertices.colwise() + part.centre_P), "m", packing);
  hdf5::write_table(group, "triangles", part.triangles, packing);
  hdf5::write_list(group, "file_triangle", part.file_triangle, packing);
}

void read_part(const hdf5::Handle& group, EmbeddedSurface& surface) {
  surface.mesh = hdf5::read_text(group, "mesh");
  surface.mesh_hash = hdf5::read_text(group, "mesh_hash");
  surface.position_m = read_vector(group, "position_m");
  const auto rotation = hdf5::read_numbers(group, "rotation", 9);
  surface.rotation = Eigen::Map<const Mat3>(rotation.data()).transpose();
  surface.has_triangles = hdf5::has_link(group, "vertices_m");
  if (!surface.has_triangles) return;
  surface.crease_deg = read_number(group, "crease_deg");
  surface.soup.vertices_P = hdf5::read_points(group, "vertices_m", max_embedded_vertices);
  surface.soup.triangles = hdf5::read_triples(group, "triangles", max_embedded_triangles);
  surface.soup.file_triangle = hdf5::read_list(group, "file_triangle", max_embedded_triangles);
}

EmbeddedSurface read_surface(const hdf5::Handle& group) {
  EmbeddedSurface surface;
  surface.properties.stiffness_n_per_m = read_number(group, "stiffness_n_per_m");
  surface.properties.damping_n_s_per_m = read_number(group, "damping_n_s_per_m");
  surface.properties.mu_static = read_number(group, "mu_static");
  surface.properties.mu_dynamic = read_number(group, "mu_dynamic");
  surface.is_part = hdf5::read_text(group, "kind") != "plane";
  if (surface.is_part) {
    read_part(group, surface);
  } else {
    surface.point_m = read_vector(group, "point_m");
    surface.normal = read_vector(group, "normal");
  }
  return surface;
}

/// What make_part asks of a soup, checked: a damaged file must not reach it.
void check_soup(const TriangleSoup& soup, const std::string& path) {
  const auto refuse = [&path](const char* what) {
    return refused(path, fmt::format("is damaged: an embedded surface has {}", what));
  };
  if (soup.triangles.cols() == 0) throw refuse("no triangles");
  if (soup.triangles.minCoeff() < 0 || soup.triangles.maxCoeff() >= soup.vertices_P.cols()) {
    throw refuse("a triangle of a vertex that is not there");
  }
  for (const int corner : soup.triangles.reshaped()) {
    if (!(soup.vertices_P.col(corner).array().abs() < 1e12).all())  // a maximum may pass over a nan
      throw refuse("a corner that is not finite");
  }
  if (static_cast<Eigen::Index>(soup.file_triangle.size()) != soup.triangles.cols()) {
    throw refuse("not one file number a triangle");
  }
}

Surface built_part(const EmbeddedSurface& embedded, const std::string& path) {
  Surface surface;
  surface.mesh = embedded.mesh;
  surface.mesh_hash = embedded.mesh_hash;
  surface.p_WP = embedded.position_m;
  surface.R_WP = embedded.rotation;
  const bool rigid = surface.p_WP.allFinite() && (surface.R_WP.transpose() * surface.R_WP).isIdentity(1e-9);
  if (!rigid || !(embedded.crease_deg >= 0 && embedded.crease_deg <= 180)) {
    throw refused(path, "is damaged: an embedded surface has no sane pose or crease angle");
  }
  check_soup(embedded.soup, path);
  surface.part =
      std::make_shared<const Part>(make_part(embedded.soup, embedded.crease_deg * std::numbers::pi / 180));
  return surface;
}

Surface built_plane(const EmbeddedSurface& embedded, const std::string& path) {
  Surface surface;
  surface.plane_point_W = embedded.point_m;
  surface.plane_normal_W = embedded.normal;
  if (!surface.plane_point_W.allFinite() || !(std::abs(surface.plane_normal_W.norm() - 1) < 1e-9)) {
    throw refused(path, "is damaged: an embedded plane has no point or normal");
  }
  return surface;
}

}  // namespace

void write_surfaces(const hdf5::Handle& file, const World& world, const std::string& scene_text,
                    hdf5::Packing packing) {
  const std::vector<double> creases_deg = part_crease_degs(scene_text);
  const hdf5::Handle all = hdf5::create_group(file, "surfaces");
  hdf5::write_whole(all, "count", world.surfaces.size());
  for (std::size_t i = 0; i < world.surfaces.size(); ++i) {
    const Surface& surface = world.surfaces[i];
    const hdf5::Handle group = hdf5::create_group(all, fmt::format("{}", i));
    write_properties(group, surface.properties);
    if (surface.part) {
      write_part(group, surface, i < creases_deg.size() ? creases_deg[i] : default_crease_deg, packing);
    } else {
      hdf5::write_text(group, "kind", "plane");
      write_vector(group, "point_m", surface.plane_point_W);
      write_vector(group, "normal", surface.plane_normal_W);
    }
  }
}

void read_surfaces(const hdf5::Handle& file, const std::function<void(const EmbeddedSurface&)>& take) {
  if (!hdf5::has_link(file, "surfaces")) return;
  const hdf5::Handle all = hdf5::open_group(file, "surfaces");
  const std::uint64_t count = hdf5::read_whole(all, "count").value_or(0);
  if (count > max_surfaces) throw refused(file.path(), fmt::format("is damaged: it has {} surfaces", count));
  for (std::uint64_t i = 0; i < count; ++i) take(read_surface(hdf5::open_group(all, fmt::format("{}", i))));
}

void add_surface(World& world, const EmbeddedSurface& embedded, const std::string& path) {
  Surface surface = embedded.is_part ? built_part(embedded, path) : built_plane(embedded, path);
  surface.properties = embedded.properties;
  if (surface.part) {
    Verdict verdict;
    verdict.file = surface.mesh;
    verdict.touchable = true;
    verdict.triangles = verdict.kept = surface.part->triangle_count();
    verdict.bounds_m = bounds_P(*surface.part);
    world.verdicts.push_back(std::move(verdict));
  }
  world.surfaces.push_back(std::move(surface));
}

}  // namespace fingerpad
