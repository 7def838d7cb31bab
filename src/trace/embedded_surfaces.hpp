#pragma once

#include <memory>

#include "trace/hdf5_file.hpp"
#include "trace/trace.hpp"

namespace fingerpad {

/// Larger parts are named by hash and bounding box only.
inline constexpr int max_embedded_triangles = 100000;

/// Writes the surfaces of a world as groups `surfaces/0`, `surfaces/1`, ... under the file's root: kind, pose
/// and properties as attributes; of a part `vertices_m` (n x 3, frame P), `triangles`, `file_triangle`.
/// @param scene_text  says at what angle each part was creased
void write_surfaces(const hdf5::Handle& file, const World& world, const std::string& scene_text);

/// Rebuilds what write_surfaces wrote; empty if the file has no surfaces or a part was too large to be
/// embedded. Throws Error (refused) for indices out of range and coordinates that are not finite.
std::shared_ptr<const World> read_surfaces(const hdf5::Handle& file);

}  // namespace fingerpad
