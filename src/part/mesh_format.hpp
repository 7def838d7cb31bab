#pragma once

#include <span>
#include <string>
#include <string_view>

#include "part/load_progress.hpp"
#include "part/openmesh_reader.hpp"
#include "part/raw_mesh.hpp"

namespace fingerpad {

/// One row of the table of mesh formats.
struct MeshFormat {
  std::string_view name;                      ///< "STL"
  std::span<const std::string_view> endings;  ///< of files' names, in lower case: ".stl"
  /// Whether the content proves the format, whatever the file's name; the first row that it does is believed.
  bool (*proves)(std::string_view bytes);
  /// Whether the first word of a stream (comments left out) is one of the format's.
  bool (*begins)(std::string_view word);
  /// What the file says: see RawMesh. Throws Error (refused).
  RawMesh (*scan)(std::string& bytes);
  /// What OpenMesh makes of the scanned bytes, which is held against the scan and then taken. Null: what was
  /// scanned is the mesh.
  OpenMeshDelivery (*read)(const std::string& bytes, const RawMesh& mesh, const LoadProgress& progress);
};

/// All mesh formats, in the order in which they are told.
std::span<const MeshFormat> mesh_format_table() noexcept;

/// The format whose files' names end so, in either case; null for none.
const MeshFormat* format_of_ending(std::string_view ending) noexcept;

/// "STL, OBJ, PLY and OFF".
/// @param last  "and" or "or"
std::string mesh_format_names(std::string_view last);

}  // namespace fingerpad
