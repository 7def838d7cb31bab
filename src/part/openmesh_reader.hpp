#pragma once

#include <string>
#include <vector>

#include "base/types.hpp"
#include "part/load_progress.hpp"
#include "part/raw_mesh.hpp"

namespace OpenMesh::IO {
class BaseReader;
}

namespace fingerpad {

/// What OpenMesh made of a file: vertices and polygons in the order in which it gave them, nothing dropped.
struct OpenMeshDelivery {
  bool succeeded = false;      ///< by its own account
  std::vector<Vec3> vertices;  ///< float32 values in this build of OpenMesh
  std::vector<int> corners;    ///< -1 where a handle named no vertex
  std::vector<int> ends;       ///< as RawMesh::ends
};

/// Reads through OpenMesh's readers, past its half-edge meshes (which would drop or split non-manifold
/// faces).
///
/// The readers are objects with state that the library shares: calls wait for each other.
/// @param reader  the format's: OpenMesh::IO::STLReader()
/// @param bytes  the file; it must have passed its scan_* (OpenMesh runs on for ever on some broken files)
/// @param mesh   what the scan found: how much to make room for, and whether OpenMesh is to read it as binary
OpenMeshDelivery read_by_openmesh(OpenMesh::IO::BaseReader& reader, const std::string& bytes,
                                  const RawMesh& mesh, const LoadProgress& progress);

/// Of the library, as "9.0".
std::string openmesh_version();

}  // namespace fingerpad
