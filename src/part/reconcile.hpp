#pragma once

#include <string>

#include "part/openmesh_reader.hpp"
#include "part/raw_mesh.hpp"

namespace fingerpad {

/// Holds what OpenMesh delivered against what the file says, polygon by polygon, and moves the vertices of
/// `mesh` to where OpenMesh has them (the file's numbers rounded to float32).
///
/// Expected differences: OpenMesh leaves out polygons that name missing vertices, and some of those that name
/// one twice (or takes the repetition out). Anything else, and the file is taken at its own word, rounded in
/// the same way.
/// @returns  what OpenMesh lost or changed, as a warning; empty where it delivered the file
std::string reconcile(RawMesh& mesh, const OpenMeshDelivery& delivery);

}  // namespace fingerpad
