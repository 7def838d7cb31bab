#include "contact/normals.hpp"

#include <algorithm>

namespace fingerpad {

const Normals* find_normals(std::string_view name) noexcept {
  const auto table = normals_table();
  const auto found =
      std::find_if(table.begin(), table.end(), [name](Normals normals) { return normals->name == name; });
  return found == table.end() ? nullptr : &*found;
}

}  // namespace fingerpad
