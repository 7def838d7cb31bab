#pragma once

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "contact/triangle_tree.hpp"
#include "part/import.hpp"

namespace fingerpad {

/// A mesh that was looked at, with its tree and its thinnest wall where it can be touched.
struct CheckedMesh {
  ImportedPart imported;
  std::shared_ptr<const TriangleTree> tree;
  double wall_m = std::nan("");
  double metres_per_unit = 1;
};

/// Reads a mesh, builds its tree and measures its walls, with a bar on a terminal.
CheckedMesh checked(const std::string& path, ImportOptions how);

/// On standard output, or at the report's end; what is odd about it goes to standard error.
/// @returns whether it can be touched
bool tell_mesh(const CheckedMesh& mesh, bool as_json, nlohmann::ordered_json& report);

/// A place, of which numbers that are none are null.
nlohmann::ordered_json place_json(const Vec3& p);

}  // namespace fingerpad
