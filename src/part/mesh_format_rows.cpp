#include <array>

#include "part/mesh_format.hpp"

namespace fingerpad {

// Each format is defined in the file scan_<name>.cpp; its line here makes it known to the import, help and
// tests.
MeshFormat stl_format() noexcept;
MeshFormat obj_format() noexcept;
MeshFormat ply_format() noexcept;
MeshFormat off_format() noexcept;

std::span<const MeshFormat> mesh_format_table() noexcept {
  static const std::array table{stl_format(), obj_format(), ply_format(), off_format()};
  return table;
}

}  // namespace fingerpad
