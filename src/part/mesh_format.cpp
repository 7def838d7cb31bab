#include "part/mesh_format.hpp"

namespace fingerpad {

std::string mesh_format_names(std::string_view last) {
  const auto table = mesh_format_table();
  std::string names;
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (i > 0) names += i + 1 < table.size() ? ", " : ' ' + std::string(last) + ' ';
    names += table[i].name;
  }
  return names;
}

}  // namespace fingerpad
