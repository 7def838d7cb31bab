#pragma once

#include <functional>
#include <string>

#include "fingerpad/surface_properties.hpp"
#include "part/part.hpp"
#include "trace/hdf5_file.hpp"
#include "trace/trace.hpp"

namespace fingerpad {

/// Larger parts are named by hash and bounding box only.
inline constexpr int max_embedded_triangles = 100000;

/// Writes the surfaces of a world as groups `surfaces/0`, `surfaces/1`, ... under the file's root: kind, pose
/// and properties as attributes; of a part `vertices_m` (n x 3, frame P), `triangles`, `file_triangle`.
/// @param scene_text  says at what angle each part was creased
void write_surfaces(const hdf5::Handle& file, const World& world, const std::string& scene_text,
                    hdf5::Packing packing = hdf5::Packing::plain);

/// What a file says of a surface, unchecked.
struct EmbeddedSurface {
  SurfaceProperties properties;
  bool is_part = false;
  Vec3 point_m = Vec3::Zero(), normal = Vec3::Zero();  ///< of a plane
  std::string mesh, mesh_hash;
  Vec3 position_m = Vec3::Zero();
  Mat3 rotation = Mat3::Zero();
  bool has_triangles = false;  ///< false: the part was too large to be embedded
  double crease_deg = 0;
  TriangleSoup soup;
};

/// Every field, for handover.hpp: `way` tells a const surface or hears another.
template <typename Way, typename Embedded>
void each_field(Way& way, Embedded& surface) {
  way(surface.properties.stiffness_n_per_m);
  way(surface.properties.damping_n_s_per_m);
  way(surface.properties.mu_static);
  way(surface.properties.mu_dynamic);
  way(surface.is_part);
  way(surface.point_m);
  way(surface.normal);
  way(surface.mesh);
  way(surface.mesh_hash);
  way(surface.position_m);
  way(surface.rotation);
  way(surface.has_triangles);
  way(surface.crease_deg);
  way(surface.soup.vertices_P);
  way(surface.soup.triangles);
  way(surface.soup.file_triangle);
}

/// Calls `take` for each surface that write_surfaces wrote, in their order. Throws Error (refused) for what
/// cannot be read.
void read_surfaces(const hdf5::Handle& file, const std::function<void(const EmbeddedSurface&)>& take);

/// Adds a surface to a world, built anew; without its tree. Throws Error (refused, with the file's path) for
/// indices out of range, coordinates that are not finite and poses that are none.
/// @pre a part has triangles
void add_surface(World& world, const EmbeddedSurface& surface, const std::string& path);

}  // namespace fingerpad
