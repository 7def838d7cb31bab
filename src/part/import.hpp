#pragma once

#include <memory>
#include <string>

#include "part/part.hpp"
#include "part/verdict.hpp"

namespace fingerpad {

/// A part with the verdict on its mesh. `part` is empty where the mesh was refused (verdict.error says why).
struct ImportedPart {
  std::shared_ptr<const Part> part;
  Verdict verdict;
};

/// Reads STL (text and binary), OBJ, PLY or OFF through OpenMesh and checks the file against what came out.
///
/// Never throws for a bad file: whatever is wrong is in the verdict.
/// @param metres_per_unit  what one file unit is, > 0
/// @param crease_rad       see make_part
ImportedPart import_part(const std::string& path, double metres_per_unit, double crease_rad);

/// As import_part, but a part that cannot be touched throws Error (refused) with the verdict's reason.
ImportedPart import_touchable(const std::string& path, double metres_per_unit, double crease_rad);

}  // namespace fingerpad
