#pragma once

#include <memory>
#include <numbers>
#include <string>

#include "part/load_progress.hpp"
#include "part/part.hpp"
#include "part/verdict.hpp"

namespace fingerpad {

/// A part with the verdict on its mesh. `part` is empty where the mesh was refused (verdict.error says why).
struct ImportedPart {
  std::shared_ptr<const Part> part;
  Verdict verdict;
};

/// How a mesh file is to be taken.
struct ImportOptions {
  double metres_per_unit = 1e-3;                    ///< what one file unit is, > 0
  double crease_rad = 30 * std::numbers::pi / 180;  ///< see make_part
  bool repair = false;    ///< see build_repaired_part; the verdict tells what was done
  bool stream = false;    ///< `-` and /dev/fd/N will do: the caller reads the mesh this once
  LoadProgress progress;  ///< told as it goes
};

/// Reads a mesh of a known format (mesh_format_table) through OpenMesh and checks the file against what came
/// out.
///
/// Never throws for a bad file: whatever is wrong is in the verdict.
ImportedPart import_part(const std::string& path, const ImportOptions& options);
ImportedPart import_part(const std::string& path, double metres_per_unit, double crease_rad);

/// As import_part, but a part that cannot be touched throws Error (refused) with the verdict's reason.
ImportedPart import_touchable(const std::string& path, const ImportOptions& options);
ImportedPart import_touchable(const std::string& path, double metres_per_unit, double crease_rad);

}  // namespace fingerpad
